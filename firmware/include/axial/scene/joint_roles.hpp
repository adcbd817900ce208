// Positions, velocities and accelerations that do not mix, in floating point too.
#pragma once

#include <axial/scene/joints.hpp>

#include <axial/options/begin.hpp>

/// What a call says where values stand in each other's place, or are a scene's (a macro: static_assert takes a literal
/// only).
#define AXIAL_ROLES_MIXED                                                                                        \
  "axial: positions, velocities and accelerations are mixed up; give them in the order q, qd, qdd (or tau), as " \
  "axial::Positions<Robot, T> and its like of the robot, not of a scene"

namespace axial {

/// Positions that say what they are, rad or m: wherever axial::Joints (in fixed point the type of the role) are taken,
/// these are too, but a call that takes the wrong ones does not compile: `inverse_dynamics<R>(qd, q, qdd)`. Zero
/// unless initialised: `axial::JointPositions<Robot> q{0.1F, 0.2F};`.
template <class S, class T = float>
struct JointPositions : Positions<robot_of<S>, T> {
  using Base = Positions<robot_of<S>, T>;  ///< the values
  using Base::Base;                        ///< so many values, or none
  using Role = role::Position;             ///< rad or m
};
/// Velocities that say what they are, rad/s or m/s.
template <class S, class T = float>
struct JointVelocities : Velocities<robot_of<S>, T> {
  using Base = Velocities<robot_of<S>, T>;  ///< the values
  using Base::Base;                         ///< so many values, or none
  using Role = role::Velocity;              ///< rad/s or m/s
};
/// Accelerations that say what they are, rad/s^2 or m/s^2.
template <class S, class T = float>
struct JointAccelerations : Accelerations<robot_of<S>, T> {
  using Base = Accelerations<robot_of<S>, T>;  ///< the values
  using Base::Base;                            ///< so many values, or none
  using Role = role::Acceleration;             ///< rad/s^2 or m/s^2
};

namespace detail {

/// What an argument says that it is; void where it says nothing. In fixed point every type says it.
///@{
template <class A, class = void>
struct RoleSaid {
  using type = void;
};
template <class A>
struct RoleSaid<A, std::void_t<typename A::Role>> {
  using type = typename A::Role;
};
template <class S, class T, class Said>
struct RoleSaid<Joints<S, T, Said>, void> {
  using type = Said;
};
/// A motion belongs to the robot, whatever the scene; efforts in fixed point have the formats of a scene.
struct OfAScene {};
template <class Said>
inline constexpr bool is_of_motion = std::is_void_v<Said> || std::is_same_v<Said, role::Position> ||
                                     std::is_same_v<Said, role::Velocity> || std::is_same_v<Said, role::Acceleration>;
template <class R, class... F, class T, class Said>
struct RoleSaid<Joints<Scene<R, F...>, T, Said>, void> {
  using type = std::conditional_t<is_of_motion<Said>, OfAScene, Said>;
};
///@}

/// What has no role of its own, such as a third derivative: values of any role may stand there.
struct AnyRole {};
template <class Said, class Wanted>
inline constexpr bool agrees = std::is_void_v<Said> || std::is_same_v<Said, Wanted> || std::is_same_v<Wanted, AnyRole>;

/// An order of arguments: whether some that say what they are stand where others belong. Behind the last nothing may
/// be said.
template <class... Wanted>
struct Order {
  static constexpr int size = 0;  ///< arguments that have a role
  template <class... A>
  static constexpr bool broken(A*...) {
    return (false || ... || !std::is_void_v<typename RoleSaid<A>::type>);
  }
};
template <class First, class... Rest>
struct Order<First, Rest...> {
  static constexpr int size = 1 + sizeof...(Rest);  ///< arguments that have a role
  static constexpr bool broken() { return false; }
  template <class A, class... More>
  static constexpr bool broken(A*, More*... more) {
    return !agrees<typename RoleSaid<A>::type, First> || Order<Rest...>::broken(more...);
  }
};
template <class Wanted, class... A>
inline constexpr bool is_out_of_order = Wanted::broken(static_cast<std::remove_all_extents_t<A>*>(nullptr)...);

using OfPosition = Order<role::Position>;                                                       ///< q
using OfState = Order<role::Position, role::Velocity>;                                          ///< q, qd
using OfDriven = Order<role::Position, role::Velocity, role::Effort>;                           ///< q, qd, tau
using OfMotion = Order<role::Position, role::Velocity, role::Acceleration>;                     ///< q, qd, qdd
using OfHigher = Order<role::Position, role::Velocity, role::Acceleration, AnyRole>;            ///< q, qd, qdd, q3
using OfHighest = Order<role::Position, role::Velocity, role::Acceleration, AnyRole, AnyRole>;  ///< q, qd, qdd, q3, q4

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
