// What an integrator moves on in fixed point: words, and what rounding left of their sums.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/simulation/step.hpp>
#include <axial/simulation/motion.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// State of a robot's joints in words, owned by the caller.
template <class S, class Word>
struct Motion<S, Stored<Word>> {
  using Subject = S;                             ///< the robot or scene that moves
  using Scalar = Stored<Word>;                   ///< Fixed32 or Fixed16
  static constexpr bool is_compensated = false;  ///< it is always
  static constexpr int joints = joint_count<S>;  ///< number of joints
  Positions<robot_of<S>, Scalar> q{};            ///< binary angles, m
  Velocities<robot_of<S>, Scalar> qd{};          ///< rad/s or m/s
  std::uint64_t steps = 0;                       ///< made since time 0
  std::int32_t q_rest[joints] = {};              ///< what q lacks, in 2^-32 of its unit
  std::int32_t qd_rest[joints] = {};             ///< what qd lacks, in 2^-32 of its unit

  /// Half steps since time 0.
  [[nodiscard]] AXIAL_INLINE constexpr std::uint64_t time(const FixedStep&, int halves = 0) const {
    return 2 * steps + static_cast<std::uint64_t>(halves);
  }
};

}  // namespace axial

#include <axial/options/end.hpp>
