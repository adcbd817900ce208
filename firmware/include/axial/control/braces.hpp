// The control step on numbers in braces.
#pragma once

#include <axial/control/plain_arrays.hpp>
#include <axial/dynamics/braces.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// feedforward, compensate_gravity, checks and the nearest request on braces that hold a number for each joint, of the
/// state's scalar, or where there is none of float.
///@{
template <class S, class T, class A = detail::Braces<S, T>, class B = detail::Braces<S, T>,
          class C = detail::Braces<S, T>, class... In, detail::IfAnyIsBraced<A, B, C> = 0>
[[nodiscard]] constexpr auto feedforward(FeedforwardState<S, T>& state, const A& q, const B& qd, const C& x,
                                         const In&... in) {
  return feedforward<S>(state, detail::unbraced(q), detail::unbraced(qd), detail::unbraced(x), in...);
}
template <class S, class T, class A = detail::Braces<S, T>, class... In, detail::IfAnyIsBraced<A> = 0>
[[nodiscard]] constexpr auto compensate_gravity(SafeLoopState<S, T>& state, const A& q, const In&... in) {
  return compensate_gravity<S>(state, detail::unbraced(q), in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>, class... In,
          detail::IfAnyIsBraced<A, B, C> = 0>
[[nodiscard]] constexpr auto check_request(const A& q, const B& qd, const C& x, const In&... in) {
  return check_request<S>(detail::unbraced(q), detail::unbraced(qd), detail::unbraced(x), in...);
}
template <class S, class A = detail::Braces<S>, class... In, detail::IfAnyIsBraced<A> = 0>
[[nodiscard]] constexpr auto check_position(const A& q, const In&... in) {
  return check_position<S>(detail::unbraced(q), in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>, class... In,
          detail::IfAnyIsBraced<A, B, C> = 0>
[[nodiscard]] constexpr auto clamped_request(const A& q, const B& qd, const C& x, const In&... in) {
  return clamped_request<S>(detail::unbraced(q), detail::unbraced(qd), detail::unbraced(x), in...);
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
