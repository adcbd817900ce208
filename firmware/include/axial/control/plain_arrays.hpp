// The control step on arrays of numbers.
#pragma once

#include <axial/control/gravity_compensation.hpp>
#include <axial/dynamics/plain_arrays.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// feedforward on arrays that have a number for each joint, instead of joint values or mixed with them.
template <class S, class T, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr auto feedforward(FeedforwardState<S, T>& state, const A&... given) {
  static_assert(detail::takes_arrays<S, A...>, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, FeedforwardResult<S, T>>(
      [&](const auto&... in) AXIAL_INLINE { return feedforward<S>(state, in...); }, given...);
}

/// compensate_gravity on an array that has a number for each joint.
template <class S, class T, class A, class... More, class = detail::IfAnyIsPlainArray<A>>
[[nodiscard]] constexpr auto compensate_gravity(SafeLoopState<S, T>& state, const A& q, const More&... in) {
  static_assert(detail::takes_arrays<S, A>, AXIAL_ARRAYS_FIT);
  return detail::with_joint_values<S, FeedforwardResult<S, T>>(
      [&](const auto& at) AXIAL_INLINE { return compensate_gravity<S>(state, at, in...); }, q);
}

}  // namespace axial

#include <axial/options/end.hpp>
