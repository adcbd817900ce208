// What a Jacobian says of the tool besides its columns: joint efforts of a wrench, velocity, bias acceleration.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/kinematics.hpp>
#include <axial/recursion/joint_axis.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// What a wrench at the tool exerts on the joints: N m or N.
template <class R, class T>
using WrenchEfforts = Joints<R, T, typename detail::RoleOf<T, role::WrenchEffort>::type>;

namespace detail {
template <class T>
constexpr void check_real() {
  static_assert(std::is_floating_point_v<T>,
                "axial: products with a Jacobian have no formats in fixed point; compute them in float");
}
// Whether columns are those of joints' own axes, one behind the other.
template <class R, class T>
constexpr void check_axes() {
  check_real<T>();
  static_assert(!shares_drives_in<typename scene_of<R>::Robot>,
                "axial: columns of drives are no axes, of which this is; take the Jacobian of JointCoordinates<Robot>");
}
template <class T>
AXIAL_INLINE constexpr auto cross(const Vec3<T>& w, const MotionVector<Vec3<T>, Vec3<T>>& column) {
  return MotionVector<Vec3<T>, Vec3<T>>{axial::cross(w, column.angular), axial::cross(w, column.linear)};
}
}  // namespace detail

/// Efforts of the joints, N m or N, that a wrench at the tool exerts on them: J^T w; what the drives exert against it
/// is the opposite. `wrench` is in world axes, its moment (N m) about the origin that the Jacobian is of. In fixed
/// point (fixed/tool/tool_motion.hpp) it has the formats of a tip wrench, and no wrench of words overflows.
template <class R, class T>
[[nodiscard]] constexpr WrenchEfforts<R, T> transpose_times(const Jacobian<R, T>& jacobian,
                                                            const ForceVector<Vec3<T>, Vec3<T>>& wrench) {
  detail::check_real<T>();
  WrenchEfforts<R, T> tau{};
  for (int j = 0; j < joint_count<R>; ++j)
    tau[j] = along_motion(jacobian[j], wrench);
  return tau;
}

/// Velocity of the tool, J qd: rad/s and m/s, world axes.
template <class R, class T>
[[nodiscard]] constexpr MotionVector<Vec3<T>, Vec3<T>> tool_velocity(const Jacobian<R, T>& jacobian,
                                                                     const Velocities<R, T>& qd) {
  detail::check_real<T>();
  MotionVector<Vec3<T>, Vec3<T>> velocity{};
  for (int j = 0; j < joint_count<R>; ++j)
    velocity = velocity + MotionVector{qd[j] * jacobian[j].angular, qd[j] * jacobian[j].linear};
  return velocity;
}

/// Bias acceleration of the tool, J-dot qd: rad/s^2 and m/s^2 in world axes, what its acceleration J qdd + J-dot qd is
/// at qdd = 0; without gravity. The linear part is that of the point. From columns (z; v) alone: link j turns at w_j =
/// sum of z_k qd_k, k <= j, the origin moves at u_j = sum of v_k qd_k, k > j, beyond joint j, and column j changes by
/// (w_j x z; w_j x v + z x u_j): what the joint's own turning does to its arm and what its axis' turning does is one
/// rotation, by Jacobi's identity. 24M 21A per joint, 48M in all.
template <class R, class T>
[[nodiscard]] constexpr MotionVector<Vec3<T>, Vec3<T>> bias_acceleration(const Jacobian<R, T>& jacobian,
                                                                         const Velocities<R, T>& qd) {
  detail::check_axes<R, T>();
  const auto velocity = tool_velocity(jacobian, qd);
  MotionVector<Vec3<T>, Vec3<T>> passed{}, acceleration{};
  for (int j = 0; j < joint_count<R>; ++j) {
    const MotionVector<Vec3<T>, Vec3<T>> own{qd[j] * jacobian[j].angular, qd[j] * jacobian[j].linear};
    passed = passed + own;
    acceleration = acceleration + detail::cross(passed.angular, own);
    acceleration.linear = acceleration.linear + cross(own.angular, velocity.linear - passed.linear);
  }
  return acceleration;
}

}  // namespace axial

#include <axial/options/end.hpp>
