// Forward dynamics: accelerations from efforts.
#pragma once

#include <axial/dynamics/articulated_body.hpp>

namespace axial {

/// Accelerations for given efforts, by the articulated-body algorithm (articulated_body.hpp) on full parameters.
/// In: q (rad or m), qd, tau (N m or N); `in` carries the run-time inputs that the scene names.
/// Out: rad/s^2 or m/s^2, indexed by joint, and a status: near_singular names a joint whose articulated inertia is lost
/// in the rounding of the composite one; it is solved all the same, or held (acceleration 0) where nothing is left of
/// it. A robot with a joint that no mass, inertia or rotor resists does not compile.
template <class S, class T>
constexpr ForwardDynamics<robot_of<S>, T> forward_dynamics(const Positions<robot_of<S>, T>& q,
                                                           const Velocities<robot_of<S>, T>& qd,
                                                           const Efforts<robot_of<S>, T>& tau,
                                                           const Inputs<S, T>& in = {}) {
  static_assert(
      every_joint_is_resisted<S>(),
      "axial: forward dynamics needs every joint to move some mass, inertia or rotor; give the links outboard of "
      "each joint a mass, an inertia about the joint axis, or rotor_inertia()");
  ForwardDynamics<robot_of<S>, T> result{};
  result.status = aba::run(links_of<S, T>(), in, q, qd, tau, result);
  return result;
}
template <int N, class... F, class T, class M = Model<N, F...>>
constexpr ForwardDynamics<M, T> forward_dynamics(const Model<N, F...>& model, const Positions<M, T>& q,
                                                 const Velocities<M, T>& qd, const Efforts<M, T>& tau,
                                                 const Inputs<M, T>& in = {}) {
  ForwardDynamics<M, T> result{};
  result.status = aba::run(model.template links<T>(), in, q, qd, tau, result);
  return result;
}

}  // namespace axial
