// Power that actuators deliver.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/scene/joint_products.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {
template <class S, class T, class Tau, class V>
AXIAL_INLINE constexpr PowersOf<S, T> powers(const Tau& tau, const V& qd) {
  PowersOf<S, T> power{};
  JointProducts<scene_of<S>, T>::write(tau, qd, power);
  return power;
}
}  // namespace detail

/// Mechanical power that each actuator delivers for a motion, W: its effort in inverse_dynamics() times its speed;
/// negative where the actuator brakes. The sum over all actuators is the rate of the robot's mechanical energy, with
/// rotors as the scene names them, plus what friction and wrenches take.
/// In: q (rad or m), qd, qdd and `in` as of inverse_dynamics(); where joints share drives, values of the drives. Out:
/// W, one per actuator. NaN and infinities propagate, and in fixed point q, qd and qdd must be inside the declared
/// limits; the exponent follows from the largest effort and speed, each product is rounded once, and error_bound()
/// certifies it. Source: Featherstone 2008, chapter 2: power is the scalar product of force and velocity. Cost: one
/// inverse_dynamics() and a product per actuator.
template <class S, class T>
[[nodiscard]] constexpr PowersOf<S, T> actuator_power(const Positions<robot_of<S>, T>& q,
                                                      const Velocities<robot_of<S>, T>& qd,
                                                      const Accelerations<robot_of<S>, T>& qdd,
                                                      const Inputs<S, T>& in = no_inputs<S, T>()) {
  return detail::powers<S, T>(inverse_dynamics<S>(q, qd, qdd, in), qd);
}
/// Overload for a run-time model.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr PowersOf<M, T> actuator_power(const Model<N, F...>& model, const Positions<M, T>& q,
                                                      const Velocities<M, T>& qd, const Accelerations<M, T>& qdd,
                                                      const Inputs<M, T>& in = no_inputs<M, T>()) {
  return detail::powers<M, T>(inverse_dynamics(model, q, qd, qdd, in), qd);
}

}  // namespace axial

#include <axial/options/end.hpp>
