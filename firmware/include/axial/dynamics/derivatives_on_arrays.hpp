// Derivatives, rates and the regressor on arrays of numbers, as plain_arrays.hpp has the other kernels.
#pragma once

#include <axial/dynamics/elastic_feedforward.hpp>
#include <axial/dynamics/forward_dynamics_derivatives.hpp>
#include <axial/dynamics/inverse_dynamics_derivatives.hpp>
#include <axial/dynamics/plain_arrays.hpp>
#include <axial/dynamics/torque_rates.hpp>
#include <axial/dynamics/torque_regressor.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// The kernels of the same names on arrays that have a number for each joint, instead of joint values or mixed with
/// them.
///@{
template <class S, class... Wanted, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto inverse_dynamics_derivatives(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 3, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, InverseDynamicsDerivatives<S, float, Wanted...>>(
      [](const auto&... in) AXIAL_INLINE { return inverse_dynamics_derivatives<S, Wanted...>(in...); }, given...);
}
template <class S, class... Wanted, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto forward_dynamics_derivatives(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 3, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, ForwardDynamicsDerivatives<S, float, Wanted...>>(
      [](const auto&... in) AXIAL_INLINE { return forward_dynamics_derivatives<S, Wanted...>(in...); }, given...);
}
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto torque_regressor(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 3, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, TorqueRegressor<S, float>>(
      [](const auto&... in) AXIAL_INLINE { return torque_regressor<S>(in...); }, given...);
}
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto torque_rates(const A&... given) {
  constexpr int count = detail::joint_values_among<A...> == 5 ? 5 : 4;
  constexpr bool fit = detail::takes_arrays<S, count, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, TorqueRates<S, float>>(
      [](const auto&... in) AXIAL_INLINE { return torque_rates<S>(in...); }, given...);
}
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto elastic_feedforward(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 5, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, ElasticFeedforward<S, float>>(
      [](const auto&... in) AXIAL_INLINE { return elastic_feedforward<S>(in...); }, given...);
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
