// What the compiler says to who gives a kernel velocities for positions, or another scene's efforts.
#pragma once

#include <axial/dynamics/plain_arrays.hpp>
#include <axial/scene/joint_roles.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Arrays say nothing; the values that stand beside them are looked at once those are joint values.
template <class Wanted, class... A>
using IfOutOfOrder = std::enable_if_t<!(false || ... || is_plain_array<A>)&&is_out_of_order<Wanted, A...>>;

template <class S, class X, class T>
using IfOfAnother = std::enable_if_t<!std::is_same_v<X, subject_of<S, T>>>;

}  // namespace detail

/// Refused: values that say what they are (JointPositions, JointVelocities, JointAccelerations) stand where they
/// belong.
///@{
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfMotion, A...>>
[[nodiscard]] constexpr Efforts<robot_of<S>, float> inverse_dynamics(const A&...) {
  static_assert(!detail::is_out_of_order<detail::OfMotion, A...>, AXIAL_ROLES_MIXED);
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfPosition, A...>>
[[nodiscard]] constexpr Efforts<robot_of<S>, float> gravity_torque(const A&...) {
  static_assert(!detail::is_out_of_order<detail::OfPosition, A...>, AXIAL_ROLES_MIXED);
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfState, A...>>
[[nodiscard]] constexpr Efforts<robot_of<S>, float> bias_torque(const A&...) {
  static_assert(!detail::is_out_of_order<detail::OfState, A...>, AXIAL_ROLES_MIXED);
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfDriven, A...>>
[[nodiscard]] constexpr Accelerations<robot_of<S>, float> forward_dynamics(const A&...) {
  static_assert(!detail::is_out_of_order<detail::OfDriven, A...>, AXIAL_ROLES_MIXED);
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfPosition, A...>>
[[nodiscard]] constexpr MassMatrix<robot_of<S>, float> mass_matrix(const A&...) {
  static_assert(!detail::is_out_of_order<detail::OfPosition, A...>, AXIAL_ROLES_MIXED);
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfPosition, A...>>
[[nodiscard]] constexpr ForwardKinematics<robot_of<S>, float> forward_kinematics(const A&...) {
  static_assert(!detail::is_out_of_order<detail::OfPosition, A...>, AXIAL_ROLES_MIXED);
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfPosition, A...>>
[[nodiscard]] constexpr Jacobian<robot_of<S>, float> jacobian(const A&...) {
  static_assert(!detail::is_out_of_order<detail::OfPosition, A...>, AXIAL_ROLES_MIXED);
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfPosition, A...>>
[[nodiscard]] constexpr Separated<S, float> separate(const A&...) {
  static_assert(!detail::is_out_of_order<detail::OfPosition, A...>, AXIAL_ROLES_MIXED);
  return {};
}
template <class S, int Joint, class... A, class = detail::IfOutOfOrder<detail::OfMotion, A...>>
[[nodiscard]] constexpr float joint_torque(const A&...) {
  static_assert(!detail::is_out_of_order<detail::OfMotion, A...>, AXIAL_ROLES_MIXED);
  return {};
}
/// Refuses in fixed point efforts of another scene too: their formats are that scene's.
template <class S, class Q, class Qd, class X, class T, class... In, class = detail::IfOfAnother<S, X, T>>
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
