// What an integrator moves on in fixed point: words, and what rounding left of their sums; a step of time.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/limits/fixed_limits.hpp>
#include <axial/fixed/words/integer.hpp>
#include <axial/simulation/motion.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A step of time for words. Made of seconds in double, so that `advance<RungeKutta4>(x, 1e-3, drive)` is what it is in
/// float; on a board a constant is cheapest: `constexpr axial::FixedStep h = 1e-3`. Exact to 2^-29 of itself: Motion
/// counts steps, so that this is a scale of time, of less than a quartz is off, and nothing that adds up. From 2^-30 s
/// to 1 s, either way; any other is no step, and advance() says input_limit.
class FixedStep {
 public:
  /// mantissa 2^-shift, 2^28 <= |mantissa| <= 2^29, or 0.
  struct Scale {
    std::int32_t mantissa = 0;  ///< with the sign
    int shift = 0;              ///< halvings

    /// The number, where it is within the range of steps. By its bits: a board that makes one has no need of double.
    static constexpr Scale of(double x) {
      constexpr std::uint64_t one = std::uint64_t{1} << 52;
      const auto bits = __builtin_bit_cast(std::uint64_t, x);
      const int e = static_cast<int>(bits >> 52 & 0x7ff) - 1023;
      const std::uint64_t size = (bits & (one - 1)) | one;  // times 2^(e - 52)
      if (e < -30 || e > 0 || (e == 0 && size != one)) return {};
      const auto nearest = static_cast<std::int32_t>((size + (one >> digits)) >> (53 - digits));
      return {bits >> 63 == 0 ? nearest : -nearest, digits - 1 - e};
    }
    /// Their product, to nearest.
    [[nodiscard]] constexpr Scale times(const Scale& by) const {
      const std::int64_t product = integer::multiply(mantissa, by.mantissa);
      const std::int64_t sign = product >> 63, size = (product ^ sign) - sign;
      const int down = digits - 1 + static_cast<int>((size >> (2 * digits - 1)) != 0);
      return {static_cast<std::int32_t>((product + (std::int64_t{1} << (down - 1))) >> down), shift + by.shift - down};
    }
  };

  /// A step of so many seconds.
  constexpr FixedStep(double seconds)  // NOLINT(google-explicit-constructor)
      : seconds_(Scale::of(seconds)), turns_(seconds_.times(Scale::of(1.0 / detail::whole_turn))) {}

  [[nodiscard]] constexpr bool is_step() const { return seconds_.mantissa != 0; }  ///< whether it is one
  [[nodiscard]] constexpr const Scale& seconds() const { return seconds_; }        ///< h
  [[nodiscard]] constexpr const Scale& turns() const { return turns_; }            ///< h / (2 pi)
  /// Half the step: exactly.
  [[nodiscard]] constexpr FixedStep half() const {
    return {{seconds_.mantissa, seconds_.shift + 1}, {turns_.mantissa, turns_.shift + 1}};
  }
  /// A sixth.
  [[nodiscard]] constexpr FixedStep sixth() const {
    constexpr Scale by = Scale::of(1.0 / 6.0);
    return {seconds_.times(by), turns_.times(by)};
  }

 private:
  static constexpr int digits = 29;
  constexpr FixedStep(const Scale& seconds, const Scale& turns) : seconds_(seconds), turns_(turns) {}
  Scale seconds_, turns_;
};

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
