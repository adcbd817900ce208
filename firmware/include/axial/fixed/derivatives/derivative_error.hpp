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

}  // namespace detail

/// Error bounds of efforts, mass matrix and both Jacobians, each where inverse_dynamics_derivatives() has it, in its SI
/// unit.
template <class S, class T = Fixed32>
[[nodiscard]] constexpr InverseDynamicsDerivatives<S, double> error_bound(algorithm::InverseDynamicsDerivatives) {
  using Scene = scene_of<S>;
  using Word = typename T::Word;
  using Result = InverseDynamicsDerivatives<S, double>;
  static_assert((detail::check_bound<S, recursion::Derivatives>(), true));
  Result errors{};
  bounds::DerivativeBounds<joint_count<S>> all;
  if constexpr (detail::has_shared_drives<S>) {
    const auto found = detail::DrivenSlopeErrors<S, T>::found();
    all = found.entries;
    for (int k = 0; k < joint_count<S>; ++k)
      errors.tau[k] = found.efforts[k];
  } else {
    constexpr const auto& ranges = detail::ranges_for<Scene, Word, BaseParameters, recursion::Derivatives>;
    all = bounds::derivative_errors(
        detail::loaded_mechanism<Scene, detail::with_rotors<Scene, parameters_of<Scene, BaseParameters>>, Word>(),
        rounding_in<Scene, detail::ArithmeticOf<Scene, Word>>(), ranges, detail::DerivativeExponents<S, T>{});
    for (int i = 0; i < joint_count<S>; ++i)
      errors.tau[i] = ranges.range[i].joint_effort.error;
  }
  errors.M = detail::errors_in<decltype(Result::M)>(all.mass);
  errors.dtau_dq = detail::errors_in<decltype(Result::dtau_dq)>(all.position);
  errors.dtau_dqd = detail::errors_in<decltype(Result::dtau_dqd)>(all.velocity);
  return errors;
}

}  // namespace axial

#include <axial/options/end.hpp>
