// The control step on arrays of numbers.
#pragma once

#include <axial/control/gravity_compensation.hpp>
#include <axial/dynamics/plain_arrays.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

/// takes_arrays, of the numbers T of a control loop's state.
template <class T, class S, int count, class... A>
inline constexpr bool takes_arrays_of = takes_arrays<S, count, A...> && (true && ... && fits_number<A, T>);

}  // namespace detail

/// feedforward on arrays that have a number for each joint, instead of joint values or mixed with them.
template <class S, class T, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto feedforward(FeedforwardState<S, T>& state, const A&... given) {
  constexpr bool fit = detail::takes_arrays_of<T, S, 3, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, FeedforwardResult<S, T>>(
      [&](const auto&... in) AXIAL_INLINE { return feedforward<S>(state, in...); }, given...);
}

/// compensate_gravity on an array that has a number for each joint.
template <class S, class T, class A, class... More, class = detail::IfAnyIsPlain<A>>
[[nodiscard]] constexpr auto compensate_gravity(SafeLoopState<S, T>& state, const A& q, const More&... in) {
  constexpr bool fit = detail::takes_arrays_of<T, S, 1, A>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, FeedforwardResult<S, T>>(
      [&](const auto& at) AXIAL_INLINE { return compensate_gravity<S>(state, at, in...); }, q);
}

/// Checks and the nearest request on arrays that have a number for each joint, instead of joint values or mixed with
/// them.
///@{
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto check_request(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 3, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, Status>(
      [](const auto&... in) AXIAL_INLINE { return check_request<S>(in...); }, given...);
}
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto check_position(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 1, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, Status>(
      [](const auto&... in) AXIAL_INLINE { return check_position<S>(in...); }, given...);
}
template <class S, class... A, class = detail::IfAnyIsPlain<A...>>
[[nodiscard]] constexpr auto clamped_request(const A&... given) {
  constexpr bool fit = detail::takes_arrays<S, 3, A...>;
  static_assert(fit, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, fit, Request<S, float>>(
      [](const auto&... in) AXIAL_INLINE { return clamped_request<S>(in...); }, given...);
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
