// How a Jacobian changes: J-dot, and joint efforts of a wrench that stays as it is in the world while the joints move.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/derivatives/derivative_results.hpp>
#include <axial/tool/tool_motion.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// J-dot at joint speeds qd: column j is how column j of the Jacobian changes, rad/s per unit speed and so on, in world
/// axes; J-dot qd is bias_acceleration(). It is linear in qd: with speed 1 of joint k alone it is dJ/dq_k, with any
/// direction dq the Jacobian's change along it. From columns (z; v) alone, by the identity that bias_acceleration()
/// states: (w_j x z; w_j x v + z x u_j). 30M 24A per joint. Where links branch, of the tool or link that the Jacobian
/// is of; its status is that of the Jacobian. In floating point.
template <class R, class T>
[[nodiscard]] constexpr Jacobian<R, T> jacobian_rate(const Jacobian<R, T>& jacobian, const Velocities<R, T>& qd) {
  detail::check_axes<R, T>();
  const auto velocity = tool_velocity(jacobian, qd);
  MotionVector<Vec3<T>, Vec3<T>> passed{};
  Jacobian<R, T> rate{};
  rate.status = jacobian.status;
  for (int j = 0; j < joint_count<R>; ++j) {
    passed = passed + MotionVector{qd[j] * jacobian[j].angular, qd[j] * jacobian[j].linear};
    rate[j] = detail::cross(passed.angular, jacobian[j]);
    rate[j].linear = rate[j].linear + cross(jacobian[j].angular, velocity.linear - passed.linear);
  }
  return rate;
}

/// d(J^T w)/dq of a wrench at the tool that is constant in world axes, N m/rad and so on: (i, j) is how the effort of
/// joint i changes with the position of joint j. `wrench` as of transpose_times(). Derivatives of inverse dynamics hold
/// a TipWrench in the axes of its link; for one that keeps its direction in the world, as a weight on a rope or a
/// contact with a wall does, give none to the scene and subtract transpose_times() from tau and this from dtau_dq.
/// Symmetric where the moment is zero, for then it is the second derivative of a potential. 12M 8A per joint, 6M 5A per
/// entry at most. In floating point.
template <class R, class T>
[[nodiscard]] constexpr JointMatrix<R, T, by::Position> wrench_slope(const Jacobian<R, T>& jacobian,
                                                                     const ForceVector<Vec3<T>, Vec3<T>>& wrench) {
  detail::check_axes<R, T>();
  JointMatrix<R, T, by::Position> slope{};
  for (int j = 0; j < joint_count<R>; ++j) {
    const auto force = cross(wrench.force, jacobian[j].angular), moment = cross(wrench.moment, jacobian[j].angular);
    for (int i = j; i < joint_count<R>; ++i) {
      const T outer = dot(jacobian[i].linear, force);
      slope(j, i) = outer;
      slope(i, j) = outer + dot(jacobian[i].angular, moment);
    }
  }
  return slope;
}

}  // namespace axial

#include <axial/options/end.hpp>
