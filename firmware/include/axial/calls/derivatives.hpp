// Derivatives, rates and the regressor on arrays and braces, as dynamics.hpp has the other algorithms.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/calls/arguments.hpp>
#include <axial/derivatives/forward_dynamics_derivatives.hpp>
#include <axial/derivatives/inverse_dynamics_derivatives.hpp>
#include <axial/derivatives/torque_rates.hpp>
#include <axial/derivatives/torque_regressor.hpp>
#include <axial/transmissions/elastic_feedforward.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// The algorithms of the same names where arrays or braces stand for joint values.
///@{
template <class S, class... Wanted, class A = detail::Braces<S>, class B = detail::Braces<S>,
          class C = detail::Braces<S>, class... In, detail::IfAnyStandsIn<detail::OfMotion, A, B, C> = 0>
[[nodiscard]] constexpr auto inverse_dynamics_derivatives(const A& q, const B& qd, const C& qdd, const In&... in) {
  constexpr detail::Call<S, detail::OfMotion, InverseDynamicsDerivatives<S, float, Wanted...>, A, B, C, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return inverse_dynamics_derivatives<S, Wanted...>(at...); }, q,
                 qd, qdd, in...);
}
template <class S, class... Wanted, class A = detail::Braces<S>, class B = detail::Braces<S>,
          class C = detail::Braces<S>, class... In, detail::IfAnyStandsIn<detail::OfDriven, A, B, C> = 0>
[[nodiscard]] constexpr auto forward_dynamics_derivatives(const A& q, const B& qd, const C& tau, const In&... in) {
  constexpr detail::Call<S, detail::OfDriven, ForwardDynamicsDerivatives<S, float, Wanted...>, A, B, C, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return forward_dynamics_derivatives<S, Wanted...>(at...); }, q,
                 qd, tau, in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>, class... In,
          detail::IfAnyStandsIn<detail::OfMotion, A, B, C> = 0>
[[nodiscard]] constexpr auto torque_regressor(const A& q, const B& qd, const C& qdd, const In&... in) {
  constexpr detail::Call<S, detail::OfMotion, TorqueRegressor<S, float>, A, B, C, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return torque_regressor<S>(at...); }, q, qd, qdd, in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>,
          class D = detail::Braces<S>, class... In, detail::IfAnyStandsIn<detail::OfHigher, A, B, C, D> = 0>
[[nodiscard]] constexpr auto torque_rates(const A& q, const B& qd, const C& qdd, const D& q3, const In&... in) {
  constexpr detail::Call<S, detail::OfHigher, TorqueRates<S, float>, A, B, C, D, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return torque_rates<S>(at...); }, q, qd, qdd, q3, in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>,
          class D = detail::Braces<S>, class E = detail::Braces<S>, class... In,
          detail::IfAnyStandsIn<detail::OfHighest, A, B, C, D, E> = 0, detail::IfJointValues<E> = 0>
[[nodiscard]] constexpr auto torque_rates(const A& q, const B& qd, const C& qdd, const D& q3, const E& q4,
                                          const In&... in) {
  constexpr detail::Call<S, detail::OfHighest, TorqueRates<S, float>, A, B, C, D, E, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return torque_rates<S>(at...); }, q, qd, qdd, q3, q4, in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>,
          class D = detail::Braces<S>, class E = detail::Braces<S>, class... In,
          detail::IfAnyStandsIn<detail::OfHighest, A, B, C, D, E> = 0>
[[nodiscard]] constexpr auto elastic_feedforward(const A& q, const B& qd, const C& qdd, const D& q3, const E& q4,
                                                 const In&... in) {
  constexpr detail::Call<S, detail::OfHighest, ElasticFeedforward<S, float>, A, B, C, D, E, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return elastic_feedforward<S>(at...); }, q, qd, qdd, q3, q4,
                 in...);
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
