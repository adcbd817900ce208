// A step of time in fixed point.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/limits/fixed_limits.hpp>
#include <axial/fixed/words/integer.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A step of time for words. Made of seconds in double, so that `advance<RungeKutta4>(x, 1e-3, drive)` is what it is in
/// float; on a board a constant: `constexpr axial::FixedStep h = 1e-3`. Exact to 2^-29 of itself: Motion counts steps,
/// so that this is a scale of time, of less than a quartz is off, and nothing that adds up. From 2^-30 s to 1 s, either
/// way; any other is no step, and advance() says input_limit.
class FixedStep {
 public:
  /// mantissa 2^-shift, 2^28 <= |mantissa| <= 2^29, or 0.
  struct Scale {
    std::int32_t mantissa = 0;  ///< with the sign
    int shift = 0;              ///< halvings

    /// The number, where it is within the range of steps.
    static constexpr Scale of(double x) {
      constexpr double least = 0x1p-30;
      const double size = x < 0.0 ? -x : x;
      if (!(size >= least && size <= 1.0)) return {};
      const int shift = digits - 1 - detail::binary_exponent(size);
      return {static_cast<std::int32_t>(detail::nearest_integer(x * detail::power_of_two(shift))), shift};
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

}  // namespace axial

#include <axial/options/end.hpp>
