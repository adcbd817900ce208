// The calls of a control loop on arrays and braces.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/calls/arguments.hpp>
#include <axial/control/gravity_compensation.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// feedforward, compensate_gravity, checks and the nearest request where arrays, or braces, stand for joint values: of
/// the state's scalar, or where there is none of one. Values that say what they are stand where they belong.
///@{
template <class S, class T, class A = detail::Braces<S, T>, class B = detail::Braces<S, T>,
          class C = detail::Braces<S, T>, class... In, detail::IfAnyStandsIn<detail::OfMotion, A, B, C> = 0>
[[nodiscard]] constexpr auto feedforward(FeedforwardState<S, T>& state, const A& q, const B& qd, const C& qdd,
                                         const In&... in) {
  constexpr detail::CallOf<T, S, detail::OfMotion, FeedforwardResult<S, T>, A, B, C, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([&](const auto&... at) AXIAL_INLINE { return feedforward<S>(state, at...); }, q, qd, qdd, in...);
}
template <class S, class T, class A = detail::Braces<S, T>, class... In,
          detail::IfAnyStandsIn<detail::OfPosition, A> = 0>
[[nodiscard]] constexpr auto compensate_gravity(SafeLoopState<S, T>& state, const A& q, const In&... in) {
  constexpr detail::CallOf<T, S, detail::OfPosition, FeedforwardResult<S, T>, A> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([&](const auto& at) AXIAL_INLINE { return compensate_gravity<S>(state, at, in...); }, q);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>, class... In,
          detail::IfAnyStandsIn<detail::OfMotion, A, B, C> = 0>
[[nodiscard]] constexpr auto check_request(const A& q, const B& qd, const C& qdd, const In&... in) {
  constexpr detail::Call<S, detail::OfMotion, Status, A, B, C, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return check_request<S>(at...); }, q, qd, qdd, in...);
}
template <class S, class A = detail::Braces<S>, class... In, detail::IfAnyStandsIn<detail::OfPosition, A> = 0>
[[nodiscard]] constexpr auto check_position(const A& q, const In&... in) {
  constexpr detail::Call<S, detail::OfPosition, Status, A, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return check_position<S>(at...); }, q, in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>, class... In,
          detail::IfAnyStandsIn<detail::OfMotion, A, B, C> = 0>
[[nodiscard]] constexpr auto clamped_request(const A& q, const B& qd, const C& qdd, const In&... in) {
  constexpr detail::Call<S, detail::OfMotion, Request<S, float>, A, B, C, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return clamped_request<S>(at...); }, q, qd, qdd, in...);
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
