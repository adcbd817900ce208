// The algorithms on arrays and braces, and what is said of arguments that do not fit or are out of order.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/calls/arguments.hpp>
#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/dynamics/joint_torque.hpp>
#include <axial/dynamics/kinematics.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/dynamics/momentum.hpp>
#include <axial/separation/separation.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// The algorithms of the same names where arrays, or braces, with a number for each joint stand for joint values, all
/// or some. Braces are of float; of another scalar: inverse_dynamics<Arm, double>({...}, ...). Values that say what
/// they are (JointPositions, JointVelocities, JointAccelerations) stand where they belong.
///@{
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>, class... In,
          detail::IfAnyStandsIn<detail::OfMotion, A, B, C> = 0>
[[nodiscard]] constexpr auto inverse_dynamics(const A& q, const B& qd, const C& qdd, const In&... in) {
  constexpr detail::Call<S, detail::OfMotion, Efforts<robot_of<S>, float>, A, B, C, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return inverse_dynamics<S>(at...); }, q, qd, qdd, in...);
}
template <class S, class A = detail::Braces<S>, class... In, detail::IfAnyStandsIn<detail::OfPosition, A> = 0>
[[nodiscard]] constexpr auto gravity_torque(const A& q, const In&... in) {
  constexpr detail::Call<S, detail::OfPosition, Efforts<robot_of<S>, float>, A, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return gravity_torque<S>(at...); }, q, in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class... In,
          detail::IfAnyStandsIn<detail::OfState, A, B> = 0>
[[nodiscard]] constexpr auto bias_torque(const A& q, const B& qd, const In&... in) {
  constexpr detail::Call<S, detail::OfState, Efforts<robot_of<S>, float>, A, B, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return bias_torque<S>(at...); }, q, qd, in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>, class... In,
          detail::IfAnyStandsIn<detail::OfDriven, A, B, C> = 0>
[[nodiscard]] constexpr auto forward_dynamics(const A& q, const B& qd, const C& tau, const In&... in) {
  constexpr detail::Call<S, detail::OfDriven, ForwardDynamicsOf<S, float>, A, B, C, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return forward_dynamics<S>(at...); }, q, qd, tau, in...);
}
template <class S, class A = detail::Braces<S>, class... In, detail::IfAnyStandsIn<detail::OfPosition, A> = 0>
[[nodiscard]] constexpr auto mass_matrix(const A& q, const In&... in) {
  constexpr detail::Call<S, detail::OfPosition, MassMatrix<robot_of<S>, float>, A, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return mass_matrix<S>(at...); }, q, in...);
}
template <class S, class A = detail::Braces<S>, class... In, detail::IfAnyStandsIn<detail::OfPosition, A> = 0>
[[nodiscard]] constexpr auto forward_kinematics(const A& q, const In&... in) {
  constexpr detail::Call<S, detail::OfPosition, ForwardKinematics<robot_of<S>, float>, A, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return forward_kinematics<S>(at...); }, q, in...);
}
template <class S, class A = detail::Braces<S>, class... In, detail::IfAnyStandsIn<detail::OfPosition, A> = 0>
[[nodiscard]] constexpr auto jacobian(const A& q, const In&... in) {
  constexpr detail::Call<S, detail::OfPosition, Jacobian<robot_of<S>, float>, A, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return jacobian<S>(at...); }, q, in...);
}
template <class S, class A = detail::Braces<S>, class... In, detail::IfAnyStandsIn<detail::OfPosition, A> = 0>
[[nodiscard]] constexpr auto separate(const A& q, const In&... in) {
  constexpr detail::Call<S, detail::OfPosition, Separated<S, float>, A, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return separate<S>(at...); }, q, in...);
}
template <class S, class A = detail::Braces<S>, class B = detail::Braces<S>, class... In,
          detail::IfAnyStandsIn<detail::OfState, A, B> = 0>
[[nodiscard]] constexpr auto momentum_terms(const A& q, const B& qd, const In&... in) {
  constexpr detail::Call<S, detail::OfState, MomentumTerms<S, float>, A, B, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return momentum_terms<S>(at...); }, q, qd, in...);
}
template <class S, int Joint, class A = detail::Braces<S>, class B = detail::Braces<S>, class C = detail::Braces<S>,
          class... In, detail::IfAnyStandsIn<detail::OfMotion, A, B, C> = 0>
[[nodiscard]] constexpr auto joint_torque(const A& q, const B& qd, const C& qdd, const In&... in) {
  constexpr detail::Call<S, detail::OfMotion, float, A, B, C, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return joint_torque<S, Joint>(at...); }, q, qd, qdd, in...);
}
template <class S, int Joint, class A = detail::Braces<S>, class... In,
          detail::IfAnyStandsIn<detail::OfPosition, A> = 0>
[[nodiscard]] constexpr auto gravity_torque(const A& q, const In&... in) {
  constexpr detail::Call<S, detail::OfPosition, float, A, In...> call{};
  static_assert(call.fits, AXIAL_ARRAYS_FIT);
  static_assert(call.in_order, AXIAL_ROLES_MIXED);
  return call.of([](const auto&... at) AXIAL_INLINE { return gravity_torque<S, Joint>(at...); }, q, in...);
}
/// Refuses in fixed point efforts of another scene too: their formats are that scene's.
template <class S, class Q, class Qd, class X, class T, class... In,
          class = std::enable_if_t<!std::is_same_v<X, subject_of<S, T>>>>
[[nodiscard]] constexpr Accelerations<robot_of<S>, float> forward_dynamics(const Q&, const Qd&,
                                                                           const Joints<X, T, role::Effort>&,
                                                                           const In&...) {
  static_assert(std::is_same_v<X, subject_of<S, T>>,
                "axial: these efforts are in the formats of another scene; declare them as EffortsOf<Scene, Number>");
  return {};
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
