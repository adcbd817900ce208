// Feed-forward of a robot whose joints are elastic: what the motors exert, and where they stand, for a motion of links.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/derivatives/torque_rates.hpp>
#include <axial/scene/without_drives.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// What the motors do for a motion of the links; all on the side of the joint, behind the gear.
template <class S, class T>
struct ElasticFeedforward {
  Efforts<robot_of<S>, T> tau_m{};      ///< N m or N, torque of each motor
  Positions<robot_of<S>, T> theta{};    ///< rad or m, position of each motor
  Velocities<robot_of<S>, T> thetad{};  ///< rad/s or m/s
  Efforts<robot_of<S>, T> tau_l{};      ///< N m or N, what the elastic element transmits to the link
};

namespace elastic {

/// The scene that a scene's links see: rotor and friction are in front of the elastic element.
template <class S>
struct WithoutMotors;
template <class Robot, class... Features>
struct WithoutMotors<Scene<Robot, Features...>> : detail::WithoutDrives<Scene<Robot>, Features...> {};

/// Whether some joint of a robot has a stiffness.
template <class Robot>
constexpr bool is_elastic() {
  for (const auto& link : Robot::chain.links)
    if (link.stiffness < LinkParameters::unlimited) return true;
  return false;
}

/// 1/K of every joint of a robot, rad/(N m) or m/N; 0 of a rigid one.
template <class Robot, class T>
inline constexpr auto compliances = [] {
  Row<T, Robot::chain.size> result;
  for (int i = 0; i < Robot::chain.size; ++i)
    result[i] = NumberTraits<T>::constant(1.0 / Robot::chain.links[i].stiffness);
  return result;
}();
/// Compliance of joint i, rad/(N m) or m/N: known to the compiler where the links are.
template <class Links, class I>
AXIAL_INLINE constexpr auto compliance(I i) {
  using Robot = typename Links::Scene::Robot;
  using T = typename Links::Scalar;
  if constexpr (Links::unrolled)
    return literal<T>([] { return compliances<Robot, double>[I::value]; });
  else
    return T(compliances<Robot, Lane<T>>[i]);
}

/// Spong 1987: theta = q + tau_l / K, tau_m = B theta-dd + tau_l, for joint i with the Taylor number of its torque.
/// Friction is that of the motor's own speed. A joint without stiffness is rigid.
template <class Motors, class I, class Tau, class V, class A, class Result>
AXIAL_INLINE constexpr void drive(const Motors& motors, I i, const Tau& tau, const V& qd, const A& qdd,
                                  Result& result) {
  auto motor = motors.link(i);
  auto c = compliance<Motors>(i);
  result.tau_l[i] = value_at_0(tau);
  result.theta[i] = result.theta[i] + c * value_at_0(tau);
  result.thetad[i] = qd + c * linear_of(tau);
  auto acceleration = qdd + c * twice(quadratic_of(tau));
  result.tau_m[i] = motor.rotor() * acceleration + value_at_0(tau) + friction_effort(motor, result.thetad[i]);
}

}  // namespace elastic

namespace detail {

// Scenes and numbers that elastic joints are offered for.
template <class S, class T>
constexpr void check_elastic() {
  static_assert(!std::is_same_v<S, scene_of<S>> || scene_of<S>::template has<ElasticJoints>,
                "axial: elastic_feedforward takes joints as elastic; add ElasticJoints to the scene, or call "
                "inverse_dynamics for rigid ones");
  static_assert(!scene_of<S>::template has<RotorDynamics>,
                "axial: elastic_feedforward leaves out how rotors turn with their links; take RotorDynamics out of the "
                "scene and name RotorInertia");
  static_assert(elastic::is_elastic<typename scene_of<S>::Robot>(),
                "axial: no joint of the robot is elastic; declare stiffness(K), N m/rad or N/m, of those that are");
  check_rates<typename elastic::WithoutMotors<scene_of<S>>::type, T>();
}

}  // namespace detail

/// Feed-forward of elastic joints: the motors' torques tau_m, positions theta and velocities for a motion of the links
/// with its derivatives up to the fourth (q rad or m; q3 and q4 rad/s^3 and rad/s^4, or m), so that the links follow it
/// exactly: tau_l = M(q) qdd + c + g = K (theta - q), B theta-dd + tau_l = tau_m with B = gear^2 J. Stiffness is what
/// the links declare by stiffness(K), rotors and friction act on the motor's side: B is no part of tau_l. A named scene
/// asks for ElasticJoints; a bare robot stands for gravity, rotors and the stiffness that it declares.
/// As K grows theta tends to q and tau_m to the torque of rigid joints. NaN and infinities propagate: check_finite() of
/// tau_m, theta and thetad. In floating point, for a base at rest, in air.
/// Source: Spong 1987 (the model); De Luca and Lucibello 1998 (its flatness); Buondonno and De Luca 2015 (recursion).
template <class S, class T>
[[nodiscard]] constexpr ElasticFeedforward<S, T> elastic_feedforward(
    const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd, const Accelerations<robot_of<S>, T>& qdd,
    const Joints<robot_of<S>, T>& q3, const Joints<robot_of<S>, T>& q4, const Inputs<S, T>& in = no_inputs<S, T>()) {
  detail::check_elastic<S, T>();
  using Links = typename elastic::WithoutMotors<scene_of<S>>::type;
  const auto motors = links_of<S, T, FullParameters>();
  ElasticFeedforward<S, T> result{};
  result.theta = q;
  execute<derivatives::InTime>(links_of<Links, T, BaseParameters>(), in, q, qd, qdd, q3, q4,
                               [&](auto i, const auto& effort)
                                   AXIAL_INLINE { elastic::drive(motors, i, effort, qd[i], qdd[i], result); });
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
