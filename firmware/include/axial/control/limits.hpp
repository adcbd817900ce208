// Checks of run-time requests against what a robot declares.
#pragma once

#include <axial/model/joints.hpp>
#include <axial/model/status.hpp>

namespace axial {

/// True for numbers, false for NaN and infinities; looks at the bits, so no compiler flag can optimise it away.
template <class T>
constexpr bool is_finite(const T& x) {
  static_assert(std::numeric_limits<T>::is_iec559 && (sizeof(T) == 4 || sizeof(T) == 8));
  if constexpr (sizeof(T) == 4)
    return (__builtin_bit_cast(std::uint32_t, x) & 0x7F800000u) != 0x7F800000u;
  else
    return (__builtin_bit_cast(std::uint64_t, x) & 0x7FF0000000000000u) != 0x7FF0000000000000u;
}

/// The largest number T not beyond a declared limit, so that the limit itself is inside.
template <class T>
constexpr T limit(double value) {
  constexpr double largest = static_cast<double>(std::numeric_limits<T>::max());
  if (value > largest) return std::numeric_limits<T>::max();
  if (value < -largest) return std::numeric_limits<T>::lowest();
  return NumberTraits<T>::constant(value);
}

/// Declared limits of a robot as numbers T.
template <class Robot, class T>
struct Limits {
  struct Joint {
    T position_min, position_max, speed, acceleration, effort;
  };
  Joint joints[Robot::chain.size];
};

template <class Robot, class T>
constexpr Limits<Robot, T> declared_limits() {
  Limits<Robot, T> all{};
  for (int i = 0; i < Robot::chain.size; ++i) {
    const LinkParameters& p = Robot::chain.links[i];
    all.joints[i] = {limit<T>(p.position_min), limit<T>(p.position_max), limit<T>(p.speed_limit),
                     limit<T>(p.acceleration_limit), limit<T>(p.effort_limit)};
  }
  return all;
}

/// First thing that is wrong with a request, joint by joint: not finite, or outside the declared limits.
template <class S, class T>
constexpr Status check_request(const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd,
                               const Accelerations<robot_of<S>, T>& qdd) {
  constexpr auto limits = declared_limits<robot_of<S>, T>();
  for (int i = 0; i < joint_count<S>; ++i) {
    const auto& l = limits.joints[i];
    if (!(is_finite(q[i]) && is_finite(qd[i]) && is_finite(qdd[i]))) return {Status::Code::not_finite, i};
    if (q[i] < l.position_min || q[i] > l.position_max) return {Status::Code::position_limit, i};
    if (qd[i] < -l.speed || qd[i] > l.speed) return {Status::Code::speed_limit, i};
    if (qdd[i] < -l.acceleration || qdd[i] > l.acceleration) return {Status::Code::acceleration_limit, i};
  }
  return {};
}

}  // namespace axial
