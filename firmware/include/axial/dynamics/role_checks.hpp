// What the compiler says to who gives a kernel velocities for positions.
#pragma once

#include <axial/dynamics/plain_arrays.hpp>
#include <axial/scene/joint_roles.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Arrays say nothing; the values that stand beside them are looked at once those are joint values.
template <class Wanted, class... A>
using IfOutOfOrder = std::enable_if_t<!(false || ... || is_plain_array<A>)&&is_out_of_order<Wanted, A...>>;

}  // namespace detail

/// Refused: values that say what they are (JointPositions, JointVelocities, JointAccelerations) stand where they
/// belong.
///@{
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfMotion, A...>>
[[nodiscard]] constexpr Efforts<robot_of<S>, float> inverse_dynamics(const A&...) {
  static_assert(
      !detail::is_out_of_order<detail::OfMotion, A...>,
      "axial: positions, velocities and accelerations are mixed up; give them in the order q, qd, qdd (or tau)");
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfPosition, A...>>
[[nodiscard]] constexpr Efforts<robot_of<S>, float> gravity_torque(const A&...) {
  static_assert(
      !detail::is_out_of_order<detail::OfPosition, A...>,
      "axial: positions, velocities and accelerations are mixed up; give them in the order q, qd, qdd (or tau)");
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfState, A...>>
[[nodiscard]] constexpr Efforts<robot_of<S>, float> bias_torque(const A&...) {
  static_assert(
      !detail::is_out_of_order<detail::OfState, A...>,
      "axial: positions, velocities and accelerations are mixed up; give them in the order q, qd, qdd (or tau)");
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfState, A...>>
[[nodiscard]] constexpr Accelerations<robot_of<S>, float> forward_dynamics(const A&...) {
  static_assert(
      !detail::is_out_of_order<detail::OfState, A...>,
      "axial: positions, velocities and accelerations are mixed up; give them in the order q, qd, qdd (or tau)");
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfPosition, A...>>
[[nodiscard]] constexpr MassMatrix<robot_of<S>, float> mass_matrix(const A&...) {
  static_assert(
      !detail::is_out_of_order<detail::OfPosition, A...>,
      "axial: positions, velocities and accelerations are mixed up; give them in the order q, qd, qdd (or tau)");
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfPosition, A...>>
[[nodiscard]] constexpr ForwardKinematics<robot_of<S>, float> forward_kinematics(const A&...) {
  static_assert(
      !detail::is_out_of_order<detail::OfPosition, A...>,
      "axial: positions, velocities and accelerations are mixed up; give them in the order q, qd, qdd (or tau)");
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfPosition, A...>>
[[nodiscard]] constexpr Jacobian<robot_of<S>, float> jacobian(const A&...) {
  static_assert(
      !detail::is_out_of_order<detail::OfPosition, A...>,
      "axial: positions, velocities and accelerations are mixed up; give them in the order q, qd, qdd (or tau)");
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfPosition, A...>>
[[nodiscard]] constexpr Separated<S, float> separate(const A&...) {
  static_assert(
      !detail::is_out_of_order<detail::OfPosition, A...>,
      "axial: positions, velocities and accelerations are mixed up; give them in the order q, qd, qdd (or tau)");
  return {};
}
template <class S, int Joint, class... A, class = detail::IfOutOfOrder<detail::OfMotion, A...>>
[[nodiscard]] constexpr float joint_torque(const A&...) {
  static_assert(
      !detail::is_out_of_order<detail::OfMotion, A...>,
      "axial: positions, velocities and accelerations are mixed up; give them in the order q, qd, qdd (or tau)");
  return {};
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
