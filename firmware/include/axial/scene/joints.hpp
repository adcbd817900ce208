// One value per joint.
#pragma once

#include <axial/scene/scene.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// N values, one per joint, from the base outwards. A plain aggregate: `Joints<Robot, float> q{0.1F, 0.2F}`.
/// `Role` is void where the numbers carry their own scale; fixed point has one type a role
/// (fixed/formats/joint_formats.hpp).
template <class S, class T, class Role>
struct Joints {
  static constexpr int size = joint_count<S>;  ///< number of joints
  T values[size] = {};                         ///< from the base outwards; zero unless initialised

  AXIAL_INLINE constexpr T& operator[](int i) { return values[i]; }  ///< value of joint i; the index is not checked
  AXIAL_INLINE constexpr const T& operator[](int i) const {
    return values[i];
  }  ///< value of joint i; the index is not checked
};

/// Words without what computes with them: double, so that no second message follows.
template <class S, class Word>
struct Joints<S, Stored<Word>, void> {
  static_assert(sizeof(Word) == 0, "axial: fixed point is a plug-in: add #include <axial/fixed.hpp>");
  static constexpr int size = joint_count<S>;                                         ///< number of joints
  double values[size];                                                                ///< from the base outwards
  AXIAL_INLINE constexpr double& operator[](int i) { return values[i]; }              ///< value of joint i
  AXIAL_INLINE constexpr const double& operator[](int i) const { return values[i]; }  ///< value of joint i
};

/// What the values of joints can be.
namespace role {
struct Position {};          ///< rad or m
struct Velocity {};          ///< rad/s or m/s
struct Acceleration {};      ///< rad/s^2 or m/s^2
struct Effort {};            ///< N m or N
struct MotionEffort {};      ///< what a motion inside the limits needs, whatever efforts are declared: N m or N
struct FreeAcceleration {};  ///< what forward dynamics answers: bounded by efforts, not by a request's limits
struct Momentum {};          ///< N m s or N s
struct MomentumRate {};      ///< N m or N
struct WrenchEffort {};      ///< of a wrench at the tool: N m or N
}  // namespace role

namespace detail {
template <class T, class Role>
struct RoleOf {
  using type = void;
};
/// Whose joint values over numbers T are: the robot's; the scene's where formats follow from what it names.
template <class S, class T>
struct SubjectOf {
  using type = robot_of<S>;
};
}  // namespace detail

/// Roles: rad or m; rad/s or m/s; rad/s^2 or m/s^2; N m or N. One type in floating point.
template <class S, class T>
using Positions = Joints<S, T, typename detail::RoleOf<T, role::Position>::type>;
/// Joint values of that role.
///@{
template <class S, class T>
using Velocities = Joints<S, T, typename detail::RoleOf<T, role::Velocity>::type>;
template <class S, class T>
using Accelerations = Joints<S, T, typename detail::RoleOf<T, role::Acceleration>::type>;
template <class S, class T>
using Efforts = Joints<S, T, typename detail::RoleOf<T, role::Effort>::type>;
///@}
/// Whom results over numbers T belong to: the robot, unless their formats follow from what the scene puts on it.
template <class S, class T>
using subject_of = typename detail::SubjectOf<S, T>::type;
/// Efforts of a scene.
template <class S, class T>
using EffortsOf = Efforts<subject_of<S, T>, T>;
/// What forward dynamics answers: rad/s^2 or m/s^2.
template <class S, class T>
using FreeAccelerations = Joints<S, T, typename detail::RoleOf<T, role::FreeAcceleration>::type>;

/// Momenta of the joints, M(q) qd: N m s or N s; what changes them: N m or N.
template <class S, class T>
using MomentaOf = Joints<subject_of<S, T>, T, typename detail::RoleOf<T, role::Momentum>::type>;
/// What changes the momenta of a scene: N m or N.
template <class S, class T>
using MomentumRatesOf = Joints<subject_of<S, T>, T, typename detail::RoleOf<T, role::MomentumRate>::type>;

/// What a wrench at the tool exerts on the joints: N m or N.
template <class R, class T>
using WrenchEfforts = Joints<R, T, typename detail::RoleOf<T, role::WrenchEffort>::type>;

/// Joint values that are zero by type: a query that leaves them out does not pay for them.
struct NoMotion {
  AXIAL_INLINE constexpr Zero operator[](int) const { return {}; }  ///< zero, for every joint
};

}  // namespace axial

#include <axial/options/end.hpp>
