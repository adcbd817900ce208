// The kernels over a run-time model on arrays of numbers, as plain_arrays.hpp has those of a robot.
#pragma once

#include <axial/dynamics/forward_dynamics_derivatives.hpp>
#include <axial/dynamics/inverse_dynamics_derivatives.hpp>
#include <axial/dynamics/plain_arrays.hpp>
#include <axial/dynamics/torque_regressor.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

/// Where one of the arguments behind a model is an array: numbers of a joint or a link may stand there too.
template <class... A>
using IfAnyIsPlainArray = std::enable_if_t<(false || ... || is_plain_array<A>)>;

}  // namespace detail

/// The kernels of the same names on arrays that have a number for each joint of the model, instead of joint values or
/// mixed with them.
///@{
template <int N, class... F, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr auto inverse_dynamics(const Model<N, F...>& model, const A&... given) {
  using M = Model<N, F...>;
  constexpr bool fit = detail::takes_arrays<M, 3, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<M, fit, Efforts<M, float>>(
      [&](const auto&... in) AXIAL_INLINE { return inverse_dynamics(model, in...); }, given...);
}
template <int N, class... F, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr auto gravity_torque(const Model<N, F...>& model, const A&... given) {
  using M = Model<N, F...>;
  constexpr bool fit = detail::takes_arrays<M, 1, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<M, fit, Efforts<M, float>>(
      [&](const auto&... in) AXIAL_INLINE { return gravity_torque(model, in...); }, given...);
}
template <int N, class... F, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr auto bias_torque(const Model<N, F...>& model, const A&... given) {
  using M = Model<N, F...>;
  constexpr bool fit = detail::takes_arrays<M, 2, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<M, fit, Efforts<M, float>>(
      [&](const auto&... in) AXIAL_INLINE { return bias_torque(model, in...); }, given...);
}
template <int N, class... F, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr auto forward_dynamics(const Model<N, F...>& model, const A&... given) {
  using M = Model<N, F...>;
  constexpr bool fit = detail::takes_arrays<M, 3, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<M, fit, ForwardDynamicsOf<M, float>>(
      [&](const auto&... in) AXIAL_INLINE { return forward_dynamics(model, in...); }, given...);
}
template <int N, class... F, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr auto mass_matrix(const Model<N, F...>& model, const A&... given) {
  using M = Model<N, F...>;
  constexpr bool fit = detail::takes_arrays<M, 1, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<M, fit, MassMatrix<M, float>>(
      [&](const auto&... in) AXIAL_INLINE { return mass_matrix(model, in...); }, given...);
}
template <int N, class... F, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr auto forward_kinematics(const Model<N, F...>& model, const A&... given) {
  using M = Model<N, F...>;
  constexpr bool fit = detail::takes_arrays<M, 1, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<M, fit, ForwardKinematics<M, float>>(
      [&](const auto&... in) AXIAL_INLINE { return forward_kinematics(model, in...); }, given...);
}
template <int N, class... F, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr auto jacobian(const Model<N, F...>& model, const A&... given) {
  using M = Model<N, F...>;
  constexpr bool fit = detail::takes_arrays<M, 1, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<M, fit, Jacobian<M, float>>(
      [&](const auto&... in) AXIAL_INLINE { return jacobian(model, in...); }, given...);
}
template <int N, class... F, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr auto separate(const Model<N, F...>& model, const A&... given) {
  using M = Model<N, F...>;
  constexpr bool fit = detail::takes_arrays<M, 1, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<M, fit, Separated<M, float>>(
      [&](const auto&... in) AXIAL_INLINE { return separate(model, in...); }, given...);
}
template <int N, class... F, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr auto momentum_terms(const Model<N, F...>& model, const A&... given) {
  using M = Model<N, F...>;
  constexpr bool fit = detail::takes_arrays<M, 2, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<M, fit, MomentumTerms<M, float>>(
      [&](const auto&... in) AXIAL_INLINE { return momentum_terms(model, in...); }, given...);
}
template <int N, class... F, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr auto torque_regressor(const Model<N, F...>& model, const A&... given) {
  using M = Model<N, F...>;
  constexpr bool fit = detail::takes_arrays<M, 3, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<M, fit, TorqueRegressor<M, float>>(
      [&](const auto&... in) AXIAL_INLINE { return torque_regressor(model, in...); }, given...);
}
template <class... Wanted, int N, class... F, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr auto inverse_dynamics_derivatives(const Model<N, F...>& model, const A&... given) {
  using M = Model<N, F...>;
  constexpr bool fit = detail::takes_arrays<M, 3, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<M, fit, InverseDynamicsDerivatives<M, float, Wanted...>>(
      [&](const auto&... in) AXIAL_INLINE { return inverse_dynamics_derivatives<Wanted...>(model, in...); }, given...);
}
template <class... Wanted, int N, class... F, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr auto forward_dynamics_derivatives(const Model<N, F...>& model, const A&... given) {
  using M = Model<N, F...>;
  constexpr bool fit = detail::takes_arrays<M, 3, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<M, fit, ForwardDynamicsDerivatives<M, float, Wanted...>>(
      [&](const auto&... in) AXIAL_INLINE { return forward_dynamics_derivatives<Wanted...>(model, in...); }, given...);
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
