// The algorithms over a run-time model on arrays and braces, as dynamics.hpp has those of a robot.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/calls/derivatives.hpp>
#include <axial/calls/dynamics.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// The algorithms of the same names over a model, where arrays or braces stand for joint values.
///@{
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class B = detail::Braces<Model<N, F...>>,
          class C = detail::Braces<Model<N, F...>>, class... In, detail::IfAnyStandsIn<detail::OfMotion, A, B, C> = 0>
[[nodiscard]] constexpr auto inverse_dynamics(const Model<N, F...>& model, const A& q, const B& qd, const C& qdd,
                                              const In&... in) {
  using M = Model<N, F...>;
  constexpr detail::Call<M, detail::OfMotion, Efforts<M, float>, A, B, C, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([&](const auto&... at) AXIAL_INLINE { return inverse_dynamics(model, at...); }, q, qd, qdd, in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class... In,
          detail::IfAnyStandsIn<detail::OfPosition, A> = 0>
[[nodiscard]] constexpr auto gravity_torque(const Model<N, F...>& model, const A& q, const In&... in) {
  using M = Model<N, F...>;
  constexpr detail::Call<M, detail::OfPosition, Efforts<M, float>, A, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([&](const auto&... at) AXIAL_INLINE { return gravity_torque(model, at...); }, q, in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class B = detail::Braces<Model<N, F...>>,
          class... In, detail::IfAnyStandsIn<detail::OfState, A, B> = 0>
[[nodiscard]] constexpr auto bias_torque(const Model<N, F...>& model, const A& q, const B& qd, const In&... in) {
  using M = Model<N, F...>;
  constexpr detail::Call<M, detail::OfState, Efforts<M, float>, A, B, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([&](const auto&... at) AXIAL_INLINE { return bias_torque(model, at...); }, q, qd, in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class B = detail::Braces<Model<N, F...>>,
          class C = detail::Braces<Model<N, F...>>, class... In, detail::IfAnyStandsIn<detail::OfDriven, A, B, C> = 0>
[[nodiscard]] constexpr auto forward_dynamics(const Model<N, F...>& model, const A& q, const B& qd, const C& tau,
                                              const In&... in) {
  using M = Model<N, F...>;
  constexpr detail::Call<M, detail::OfDriven, ForwardDynamicsOf<M, float>, A, B, C, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([&](const auto&... at) AXIAL_INLINE { return forward_dynamics(model, at...); }, q, qd, tau, in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class... In,
          detail::IfAnyStandsIn<detail::OfPosition, A> = 0>
[[nodiscard]] constexpr auto mass_matrix(const Model<N, F...>& model, const A& q, const In&... in) {
  using M = Model<N, F...>;
  constexpr detail::Call<M, detail::OfPosition, MassMatrix<M, float>, A, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([&](const auto&... at) AXIAL_INLINE { return mass_matrix(model, at...); }, q, in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class... In,
          detail::IfAnyStandsIn<detail::OfPosition, A> = 0>
[[nodiscard]] constexpr auto forward_kinematics(const Model<N, F...>& model, const A& q, const In&... in) {
  using M = Model<N, F...>;
  constexpr detail::Call<M, detail::OfPosition, ForwardKinematics<M, float>, A, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([&](const auto&... at) AXIAL_INLINE { return forward_kinematics(model, at...); }, q, in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class... In,
          detail::IfAnyStandsIn<detail::OfPosition, A> = 0>
[[nodiscard]] constexpr auto jacobian(const Model<N, F...>& model, const A& q, const In&... in) {
  using M = Model<N, F...>;
  constexpr detail::Call<M, detail::OfPosition, Jacobian<M, float>, A, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([&](const auto&... at) AXIAL_INLINE { return jacobian(model, at...); }, q, in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class... In,
          detail::IfAnyStandsIn<detail::OfPosition, A> = 0>
[[nodiscard]] constexpr auto separate(const Model<N, F...>& model, const A& q, const In&... in) {
  using M = Model<N, F...>;
  constexpr detail::Call<M, detail::OfPosition, Separated<M, float>, A, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([&](const auto&... at) AXIAL_INLINE { return separate(model, at...); }, q, in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class B = detail::Braces<Model<N, F...>>,
          class... In, detail::IfAnyStandsIn<detail::OfState, A, B> = 0>
[[nodiscard]] constexpr auto momentum_terms(const Model<N, F...>& model, const A& q, const B& qd, const In&... in) {
  using M = Model<N, F...>;
  constexpr detail::Call<M, detail::OfState, MomentumTerms<M, float>, A, B, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([&](const auto&... at) AXIAL_INLINE { return momentum_terms(model, at...); }, q, qd, in...);
}
template <int N, class... F, class A = detail::Braces<Model<N, F...>>, class B = detail::Braces<Model<N, F...>>,
          class C = detail::Braces<Model<N, F...>>, class... In, detail::IfAnyStandsIn<detail::OfMotion, A, B, C> = 0>
[[nodiscard]] constexpr auto torque_regressor(const Model<N, F...>& model, const A& q, const B& qd, const C& qdd,
                                              const In&... in) {
  using M = Model<N, F...>;
  constexpr detail::Call<M, detail::OfMotion, TorqueRegressor<M, float>, A, B, C, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([&](const auto&... at) AXIAL_INLINE { return torque_regressor(model, at...); }, q, qd, qdd, in...);
}
template <class... Wanted, int N, class... F, class A = detail::Braces<Model<N, F...>>,
          class B = detail::Braces<Model<N, F...>>, class C = detail::Braces<Model<N, F...>>, class... In,
          detail::IfAnyStandsIn<detail::OfMotion, A, B, C> = 0>
[[nodiscard]] constexpr auto inverse_dynamics_derivatives(const Model<N, F...>& model, const A& q, const B& qd,
                                                          const C& qdd, const In&... in) {
  using M = Model<N, F...>;
  constexpr detail::Call<M, detail::OfMotion, InverseDynamicsDerivatives<M, float, Wanted...>, A, B, C, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([&](const auto&... at) AXIAL_INLINE { return inverse_dynamics_derivatives<Wanted...>(model, at...); },
                 q, qd, qdd, in...);
}
template <class... Wanted, int N, class... F, class A = detail::Braces<Model<N, F...>>,
          class B = detail::Braces<Model<N, F...>>, class C = detail::Braces<Model<N, F...>>, class... In,
          detail::IfAnyStandsIn<detail::OfDriven, A, B, C> = 0>
[[nodiscard]] constexpr auto forward_dynamics_derivatives(const Model<N, F...>& model, const A& q, const B& qd,
                                                          const C& tau, const In&... in) {
  using M = Model<N, F...>;
  constexpr detail::Call<M, detail::OfDriven, ForwardDynamicsDerivatives<M, float, Wanted...>, A, B, C, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([&](const auto&... at) AXIAL_INLINE { return forward_dynamics_derivatives<Wanted...>(model, at...); },
                 q, qd, tau, in...);
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
