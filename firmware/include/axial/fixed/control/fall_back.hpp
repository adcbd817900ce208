// What the drives exert when requests stop, and braking to rest, in fixed point: by integers alone.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/control/fall_back.hpp>
#include <axial/fixed/control/limits.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// A positive factor as a word below 2^31 and a shift: x times it is (x word) >> shift.
struct StopFactor {
  std::int32_t word = 0;
  int shift = 0;
  std::int64_t half = 0;
  constexpr StopFactor() = default;
  constexpr explicit StopFactor(double value) {
    while (value * power_of_two(shift + 1) < 2147483647.0 && shift < 62)
      ++shift;
    word = static_cast<std::int32_t>(nearest_integer(value * power_of_two(shift)));
    half = (std::int64_t{1} << shift) >> 1;
  }
  /// To nearest.
  [[nodiscard]] constexpr std::int64_t times(std::int32_t x) const {
    return (integer::multiply(x, word) + half) >> shift;
  }
};

/// Ticks of joints in units of their words.
template <class S, class Word, class Stop>
struct StopStep<S, Stored<Word>, Stop> {
  using T = Stored<Word>;
  static_assert(sizeof(Word) == 4, "axial: a controlled stop takes Fixed32, float or double");

  /// Constants of one joint: what a tick of braking takes off a speed, either way; position per speed, speed per
  /// acceleration and its inverse; (speed 2^-drop)^2 per way.
  struct Joint {
    std::int32_t usual = 0, most = 0;
    StopFactor position, speed, acceleration;
    std::int32_t late = 0, ends = 0;
    int drop = 0;
  };
  struct Joints {
    Joint of[joint_count<S>] = {};
    constexpr Joints() {
      using R = robot_of<S>;
      for (int i = 0; i < joint_count<S>; ++i) {
        const auto& rates = decelerations<S, Stop>;
        const double v = power_of_two(Velocities<R, T>::exponent(i)),
                     a = power_of_two(Accelerations<R, T>::exponent(i));
        const double q = is_angle<Positions<R, T>>(i) ? bam_per_radian : power_of_two(Positions<R, T>::exponent(i));
        Joint& j = of[i];
        j.usual = raw_limit<std::int32_t>(rates.usual[i] * Stop::period * v, 0);
        j.most = raw_limit<std::int32_t>(rates.most[i] * Stop::period * v, 0);
        j.position = StopFactor(Stop::period * q / v), j.speed = StopFactor(Stop::period * v / a);
        j.acceleration = StopFactor(a / (Stop::period * v));
        double late = 1.96875 * rates.usual[i] * v * v / q;
        for (; late >= 2147483647.0; late *= 0.25)
          ++j.drop;
        j.late = static_cast<std::int32_t>(nearest_integer(late));
        j.ends = -static_cast<std::int32_t>(fixed_limits_of<S, Word>.joints[i].span !=
                                            (std::numeric_limits<std::uint32_t>::max)());
      }
    }
  };
  static constexpr Joints joints{};

  /// -1 where the usual deceleration ends beyond the position limits, else 0: no branch.
  static constexpr std::int32_t is_late(int i, const Fixed32& q, const T& v) {
    const PositionRange& l = fixed_limits_of<S, Word>.joints[i];
    const auto sign = static_cast<std::uint32_t>(v.raw >> 31);
    const std::uint32_t up = static_cast<std::uint32_t>(l.max) - static_cast<std::uint32_t>(q.raw);
    const std::uint32_t down = static_cast<std::uint32_t>(q.raw) - static_cast<std::uint32_t>(l.min);
    const auto half = static_cast<std::int32_t>(((up & ~sign) | (down & sign)) >> 1);  // of the way
    const std::int32_t slow = v.raw >> joints.of[i].drop;
    const std::int64_t left = integer::multiply(half, joints.of[i].late) - (integer::multiply(slow, slow) >> 1);
    return static_cast<std::int32_t>(left >> 63) & joints.of[i].ends;
  }
  static constexpr T slowed(int i, const T& v, std::int32_t late) {
    const Joint& j = joints.of[i];
    const std::int32_t less = j.usual + ((j.most - j.usual) & late), sign = v.raw >> 31;
    const std::int64_t size = ((std::int64_t{v.raw} ^ sign) - sign) - less, kept = size & ~(size >> 63);
    return {static_cast<Word>((kept ^ sign) - sign)};
  }
  static constexpr T gained(int i, const T& v, const T& a) {
    return {nearest_word<Word>(v.raw + joints.of[i].speed.times(a.raw))};
  }
  static constexpr Fixed32 moved(int i, const Fixed32& q, const T& v, const T& next) {
    const auto way = joints.of[i].position.times(static_cast<std::int32_t>((std::int64_t{v.raw} + next.raw) >> 1));
    const auto there = static_cast<std::uint32_t>(q.raw) + static_cast<std::uint32_t>(way);
    const PositionRange& l = fixed_limits_of<S, Word>.joints[i];
    const std::int32_t there_raw = static_cast<std::int32_t>(there), back = v.raw >> 31;
    const std::int32_t end = (l.max & ~back) | (l.min & back), beyond = l.outside({there_raw});
    return {(there_raw & ~beyond) | (end & beyond)};
  }
  static constexpr T rate(int i, const T& v, const T& next) {
    return {nearest_word<Word>(joints.of[i].acceleration.times(next.raw - v.raw))};
  }
  static constexpr bool is_moving(const T& v) { return v.raw != 0; }
};

template <class Word>
struct Blend<Stored<Word>> {
  static constexpr Stored<Word> of(const Stored<Word>& to, const Stored<Word>& from, std::uint32_t share) {
    const std::int64_t apart = std::int64_t{from.raw} - std::int64_t{to.raw};
    return {static_cast<Word>(to.raw + ((apart * static_cast<std::int32_t>(share)) >> 16))};
  }
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
