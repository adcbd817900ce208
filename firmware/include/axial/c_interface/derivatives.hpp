// Defines, beside AXIAL_C_EXPORT, the C functions that AXIAL_C_DECLARE_DERIVATIVES (axial/axial.h) declares.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/c_interface/export.hpp>
#include <axial/derivatives/forward_dynamics_derivatives.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// The joint is the row of the first entry that is not finite.
template <class S, class T, class By>
[[nodiscard]] constexpr Status check_finite(const JointMatrix<S, T, By>& matrix) {
  return detail::first_not_finite(matrix.size, [&](int i) {
    bool finite = true;
    for (int j = 0; j < matrix.size; ++j)
      finite = finite && is_finite(matrix(i, j));
    return finite;
  });
}

}  // namespace axial

namespace axial::c_interface {

/// The derivatives of one scene over numbers T. Pointers are not null.
template <class S, class T>
struct DerivativeCalls : Calls<S, T> {
  using Base = Calls<S, T>;  ///< the other calls

  /// axial::inverse_dynamics_derivatives(): `result` is written where the status is ok.
  template <class C, class CResult>
  static axial_status inverse_dynamics_derivatives(const C& c_q, const C& c_qd, const C& c_qdd, CResult& result) {
    const auto q = from_c<typename Base::Q>(c_q);
    const auto qd = from_c<typename Base::V>(c_qd);
    const auto qdd = from_c<typename Base::A>(c_qdd);
    if (const Status asked = Base::check(q, qd, qdd); !asked.ok()) return to_c(asked);
    const auto d = axial::inverse_dynamics_derivatives<S>(q, qd, qdd);
    const Status status = CallCheck<S, T>::of_answer(d.tau, d.M, d.dtau_dq, d.dtau_dqd);
    if (!status.ok()) return to_c(status);
    write_c(d.tau, result.tau);
    write_matrix_c(d.M, Base::size, result.mass_matrix);
    write_matrix_c(d.dtau_dq, Base::size, result.dtau_dq);
    write_matrix_c(d.dtau_dqd, Base::size, result.dtau_dqd);
    return to_c(status);
  }

  /// axial::forward_dynamics_derivatives(): `result` is written unless an input is refused or an answer is no number;
  /// the status is the solver's.
  template <class C, class CResult>
  static axial_status forward_dynamics_derivatives(const C& c_q, const C& c_qd, const C& c_tau, CResult& result) {
    const auto q = from_c<typename Base::Q>(c_q);
    const auto qd = from_c<typename Base::V>(c_qd);
    const auto tau = from_c<typename Base::Tau>(c_tau);
    Status status = Base::check(q, qd);
    if (status.ok()) status = check_finite(tau);
    if (!status.ok()) return to_c(status);
    const auto d = axial::forward_dynamics_derivatives<S>(q, qd, tau);
    if (d.qdd.status.code == Status::Code::not_finite) return to_c(d.qdd.status);
    write_c(d.qdd, result.qdd);
    write_matrix_c(d.M_inverse, Base::size, result.inverse_mass_matrix);
    write_matrix_c(d.dqdd_dq, Base::size, result.dqdd_dq);
    write_matrix_c(d.dqdd_dqd, Base::size, result.dqdd_dqd);
    return to_c(d.qdd.status);
  }
};

}  // namespace axial::c_interface

/// Defines the functions of AXIAL_C_DECLARE_DERIVATIVES(prefix) for the scene and numbers that AXIAL_C_EXPORT has. In
/// one source of a program, in the global namespace, without a semicolon.
#define AXIAL_C_EXPORT_DERIVATIVES(prefix, scene, number)                                                        \
  AXIAL_C_SHADOWS                                                                                                \
  static_assert(axial::c_interface::check_export<prefix##_joints, scene, axial::c_interface::as_##number>());    \
  using prefix##_derivative_calls = axial::c_interface::DerivativeCalls<scene, axial::c_interface::as_##number>; \
  AXIAL_C_FUNCTION axial_status prefix##_inverse_dynamics_derivatives(                                           \
      const prefix##_joints* q, const prefix##_joints* qd, const prefix##_joints* qdd,                           \
      prefix##_inverse_derivatives* result) {                                                                    \
    AXIAL_C_CALL(prefix##_derivative_calls, inverse_dynamics_derivatives, (q, qd, qdd, result),                  \
                 (*q, *qd, *qdd, *result));                                                                      \
  }                                                                                                              \
  AXIAL_C_FUNCTION axial_status prefix##_forward_dynamics_derivatives(                                           \
      const prefix##_joints* q, const prefix##_joints* qd, const prefix##_joints* tau,                           \
      prefix##_forward_derivatives* result) {                                                                    \
    AXIAL_C_CALL(prefix##_derivative_calls, forward_dynamics_derivatives, (q, qd, tau, result),                  \
                 (*q, *qd, *tau, *result));                                                                      \
  }                                                                                                              \
  AXIAL_C_SHADOWS_END

#include <axial/options/end.hpp>
