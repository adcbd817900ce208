// The control step on arrays of numbers.
#pragma once

#include <axial/control/gravity_compensation.hpp>
#include <axial/dynamics/plain_arrays.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// feedforward on arrays that have a number for each joint, instead of joint values or mixed with them.
template <class S, class T, class... A, class = detail::IfAnyIsPlainArray<A...>>
[[nodiscard]] constexpr auto feedforward(FeedforwardState<S, T>& state, const A&... given) {
  static_assert(
      detail::takes_arrays<S, A...>,
      "axial: joint values are axial::Joints, or arrays with one number for each joint, all of float or all of "
      "double; the length of a pointer is given by axial::pointed<N>(pointer)");
  if constexpr (detail::takes_arrays<S, A...>)
    return feedforward<S>(state, detail::as_joint_values<S>(given)...);
  else
    return FeedforwardResult<S, T>{};
}

/// compensate_gravity on an array that has a number for each joint.
template <class S, class T, class A, class... More, class = detail::IfAnyIsPlainArray<A>>
[[nodiscard]] constexpr FeedforwardResult<S, T> compensate_gravity(SafeLoopState<S, T>& state, const A& q,
                                                                   const More&... in) {
  static_assert(
      detail::takes_arrays<S, A>,
      "axial: joint values are axial::Joints, or arrays with one number for each joint, all of float or all of "
      "double; the length of a pointer is given by axial::pointed<N>(pointer)");
  if constexpr (detail::takes_arrays<S, A>)
    return compensate_gravity<S>(state, detail::as_joint_values<S>(q), in...);
  else
    return {};
}

}  // namespace axial

#include <axial/options/end.hpp>
