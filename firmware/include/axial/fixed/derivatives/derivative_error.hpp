// Certified errors of the derivatives of inverse dynamics: their kernel, run on bounds.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/derivatives/driven_derivative_error.hpp>
#include <axial/fixed/error_bound.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Errors of the entries of one matrix.
template <class Matrix, int N>
constexpr Matrix errors_in(const bounds::EntryBounds<N>& all) {
  Matrix errors{};
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j)
      errors.set(i, j, all(i, j).error);
  return errors;
}

/// Errors of the entries and of efforts.
template <class S, class T>
constexpr auto found_slope_errors() {
  using Errors = ErrorsOf<S, T>;
  if constexpr (has_shared_drives<S>) {
    return DrivenSlopeErrors<S, T>::found();
  } else {
    const auto joints = Errors::joint_derivatives(DerivativeExponents<S, T>{});
    struct {
      bounds::DerivativeBounds<joint_count<S>> entries;
      Row<double, joint_count<S>> efforts;
    } all{joints.entries, Errors::efforts_of(joints.ranges, 0.0)};
    return all;
  }
}

}  // namespace detail

/// Error bounds of efforts, mass matrix and both Jacobians, each where inverse_dynamics_derivatives() has it, in its SI
/// unit.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr InverseDynamicsDerivatives<S, double> error_bound(algorithm::InverseDynamicsDerivatives) {
  using Result = InverseDynamicsDerivatives<S, double>;
  static_assert((detail::check_bound<S, recursion::Derivatives>(), true));
  const auto found = detail::found_slope_errors<S, T>();
  const auto& all = found.entries;
  Result errors{};
  for (int i = 0; i < joint_count<S>; ++i)
    errors.tau[i] = found.efforts[i];
  errors.M = detail::errors_in<decltype(Result::M)>(all.mass);
  errors.dtau_dq = detail::errors_in<decltype(Result::dtau_dq)>(all.position);
  errors.dtau_dqd = detail::errors_in<decltype(Result::dtau_dqd)>(all.velocity);
  return errors;
}

}  // namespace axial

#include <axial/options/end.hpp>
