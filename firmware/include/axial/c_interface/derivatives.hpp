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

/// The first joint of which an effort or a derivative is not finite.
template <class S, class T>
[[nodiscard]] constexpr Status check_finite(const InverseDynamicsDerivatives<S, T>& d) {
  const Status parts[] = {check_finite(d.tau), check_finite(d.M), check_finite(d.dtau_dq)};
  for (const Status& status : parts)
    if (!status.ok()) return status;
  return check_finite(d.dtau_dqd);
}

}  // namespace axial

namespace axial::c_interface {

/// Derivatives into a struct of C's.
///@{
template <class R, class T, class C>
constexpr void write(ToC, const InverseDynamicsDerivatives<R, T>& d, C& result) {
  write_c(d.tau, result.tau);
  write_matrix_c(d.M, d.M.size, result.mass_matrix);
  write_matrix_c(d.dtau_dq, d.M.size, result.dtau_dq);
  write_matrix_c(d.dtau_dqd, d.M.size, result.dtau_dqd);
}
template <class R, class T, class C>
constexpr void write(ToC, const ForwardDynamicsDerivatives<R, T>& d, C& result) {
  write_c(d.qdd, result.qdd);
  write_matrix_c(d.M_inverse, d.qdd.size, result.inverse_mass_matrix);
  write_matrix_c(d.dqdd_dq, d.qdd.size, result.dqdd_dq);
  write_matrix_c(d.dqdd_dqd, d.qdd.size, result.dqdd_dqd);
}
///@}

}  // namespace axial::c_interface

/// Defines the functions of AXIAL_C_DECLARE_DERIVATIVES(prefix) for the scene and numbers that AXIAL_C_EXPORT has. In
/// one source of a program, in the global namespace, without a semicolon.
#define AXIAL_C_EXPORT_DERIVATIVES(prefix, scene, number)                                                        \
  AXIAL_C_SHADOWS                                                                                                \
  static_assert(axial::c_interface::check_export<prefix##_joints, scene, axial::c_interface::as_##number>());    \
  using prefix##_derivative_calls = axial::c_interface::Calls<scene, axial::c_interface::as_##number>;           \
  AXIAL_C_DEFINED(prefix, prefix##_derivative_calls, inverse_dynamics_derivatives, inverse_dynamics_derivatives, \
                  motion, inverse_derivatives, result)                                                           \
  AXIAL_C_DEFINED(prefix, prefix##_derivative_calls, forward_dynamics_derivatives, forward_dynamics_derivatives, \
                  driven, forward_derivatives, result)                                                           \
  AXIAL_C_SHADOWS_END

#include <axial/options/end.hpp>
