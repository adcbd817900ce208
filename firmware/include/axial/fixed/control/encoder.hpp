// Counts of encoders and of converters (DAC, PWM) at the border of fixed point.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/limits/fixed_limits.hpp>
#include <axial/fixed/words/integer.hpp>
#include <axial/scene/status.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// One joint's value after a conversion.
template <class Value>
struct ConvertedValue {
  Value value{};    ///< in its format
  Status status{};  ///< names the joint where the value had to be limited
};

namespace detail {

/// A positive constant as mantissa 2^-shift, the mantissa in [2^30, 2^31): exact to 2^-31.
struct Scale {
  std::int32_t mantissa = 0;
  int shift = 0;
};
constexpr Scale scale_of(double factor) {
  Scale scale;
  while (factor >= 2147483647.5)
    factor *= 0.5, --scale.shift;
  while (factor < 1073741823.75)
    factor *= 2.0, ++scale.shift;
  scale.mantissa = static_cast<std::int32_t>(nearest_integer(factor));
  return scale;
}

/// x times a constant, to nearest, halves up, within +-most; says whether it had to be brought there.
template <class Factor>
constexpr std::int32_t scaled(std::int32_t x, std::int32_t most, bool& saturated) {
  constexpr Scale scale = scale_of(Factor::value);
  static_assert(scale.shift > 0 && scale.shift < 63, "axial: a factor of a conversion is out of proportion");
  const std::int64_t half = std::int64_t{1} << (scale.shift - 1);
  const std::int64_t nearest = (integer::multiply(x, scale.mantissa) + half) >> scale.shift;
  const auto above = -static_cast<std::int64_t>(nearest > most), under = -static_cast<std::int64_t>(nearest < -most);
  saturated = (above | under) != 0;
  return static_cast<std::int32_t>((nearest & ~(above | under)) | (most & above) | (-std::int64_t{most} & under));
}

/// 2^32 / counts in 2^-32, to nearest.
constexpr std::uint64_t units_a_count(std::uint32_t counts) {
  constexpr std::uint64_t all = (std::numeric_limits<std::uint64_t>::max)();
  const std::uint64_t rest = all % counts + 1;
  return all / counts + static_cast<std::uint64_t>(2 * rest >= counts);
}

/// Signed counts from a zero, modulo 2^32: a counter may wrap.
template <int direction>
constexpr std::int32_t from_zero(std::int32_t counts, std::int32_t zero) {
  const std::uint32_t up = static_cast<std::uint32_t>(counts) - static_cast<std::uint32_t>(zero);
  return static_cast<std::int32_t>(direction > 0 ? up : 0U - up);
}

template <class Values, int i, class Factor>
constexpr ConvertedValue<typename Values::Value> counted(std::int32_t counts, std::int32_t most, Status::Code beyond) {
  bool saturated = false;
  const std::int32_t raw = scaled<Factor>(counts, most, saturated);
  return {{static_cast<typename Values::Value::Word>(raw)},
          saturated ? Status{beyond, i} : Status{Status::Code::ok, -1}};
}

/// What a count is in units of joint i's format.
template <class Values, int i, std::uint32_t counts, bool turns>
struct UnitsACount {
  static constexpr double value = (turns ? whole_turn : 1.0) / counts * power_of_two(Values::exponent(i));
};

template <class Velocities, int i, std::uint32_t counts, bool turns, int direction>
constexpr auto counted_velocity(std::int32_t counts_a_second) {
  using Traits = RoleTraits<Velocities>;
  static_assert(std::is_same_v<typename Traits::Role, role::Velocity>, "axial: give Velocities<Robot, Fixed32>");
  constexpr std::int32_t most = fixed_limits_of<typename Traits::S, typename Traits::Word>.joints[i].speed.raw;
  return counted<Velocities, i, UnitsACount<Velocities, i, counts, turns>>(from_zero<direction>(counts_a_second, 0),
                                                                           most, Status::Code::speed_limit);
}

}  // namespace detail

/// An encoder of a revolute joint: `counts` a turn of the joint (of a motor's encoder: times the gear), what it reads
/// at joint angle 0, and -1 where it counts against the joint.
template <std::uint32_t counts, std::int32_t zero = 0, int direction = 1>
struct RotaryEncoder {
  static_assert(counts >= 2, "axial: an encoder has two counts a turn at least");
  static_assert(direction == 1 || direction == -1, "axial: an encoder's direction is 1 or -1");

  /// Binary angle of a reading. Exact where counts is a power of two, also across the counter's own wrap; else within
  /// 3/4 of a unit (2^-32 turns) of the exact angle, and the counter must not wrap.
  [[nodiscard]] static constexpr Fixed32 position(std::int32_t reading) {
    constexpr std::uint64_t factor = detail::units_a_count(counts);
    const auto n = static_cast<std::uint64_t>(std::int64_t{detail::from_zero<direction>(reading, zero)});
    return {static_cast<std::int32_t>(static_cast<std::uint32_t>((n * factor + (std::uint64_t{1} << 31)) >> 32))};
  }
  /// Velocity of joint i in the format of `Velocities<Robot, Fixed32>`, from counts a second: nearest, to 2^-31 of
  /// itself. Beyond the declared limit: the limit, and `speed_limit`.
  template <class Values, int i>
  [[nodiscard]] static constexpr ConvertedValue<typename Values::Value> velocity(std::int32_t counts_a_second) {
    return detail::counted_velocity<Values, i, counts, true, direction>(counts_a_second);
  }
};

/// An encoder of a prismatic joint: counts a metre, what it reads at position 0, and its direction.
template <std::uint32_t counts, std::int32_t zero = 0, int direction = 1>
struct LinearEncoder {
  static_assert(counts >= 1, "axial: an encoder has one count a metre at least");
  static_assert(direction == 1 || direction == -1, "axial: an encoder's direction is 1 or -1");

  /// Position of joint i in the format of `Positions<Robot, Fixed32>`: nearest, to 2^-31 of itself. Beyond what the
  /// format holds: its end, and `position_limit`; the declared limits are checked where a motion is used.
  template <class Values, int i>
  [[nodiscard]] static constexpr ConvertedValue<typename Values::Value> position(std::int32_t reading) {
    return detail::counted<Values, i, detail::UnitsACount<Values, i, counts, false>>(
        detail::from_zero<direction>(reading, zero), (std::numeric_limits<std::int32_t>::max)(),
        Status::Code::position_limit);
  }
  /// Velocity of joint i, as RotaryEncoder::velocity().
  template <class Values, int i>
  [[nodiscard]] static constexpr ConvertedValue<typename Values::Value> velocity(std::int32_t counts_a_second) {
    return detail::counted_velocity<Values, i, counts, false, direction>(counts_a_second);
  }
};

namespace detail {
template <class Drive, class Values, int i>
struct CountsAUnit {
  static constexpr double effort = Drive::effort_a_count > 0.0 ? Drive::effort_a_count : 1.0;  // current_command() says
  static constexpr double value = power_of_two(-Values::exponent(i)) / effort;
};
}  // namespace detail

/// Command of joint i's drive, counts of its DAC or PWM, from an effort in the format of `EffortsOf<Scene, Fixed32>`.
/// `Drive` declares `static constexpr`: effort_a_count (N m or N at the joint: gear, torque constant and amplifier
/// together), most_counts, direction (1 or -1). Nearest, to 2^-31 of itself; beyond +-most_counts: that, and
/// `effort_limit`.
template <class Drive, class Values, int i>
[[nodiscard]] constexpr ConvertedValue<std::int32_t> current_command(const typename Values::Value& effort) {
  static_assert(Drive::effort_a_count > 0.0 && Drive::most_counts > 0, "axial: a drive's counts are positive");
  bool saturated = false;
  const std::int32_t count =
      detail::scaled<detail::CountsAUnit<Drive, Values, i>>(effort.raw, Drive::most_counts, saturated);
  return {Drive::direction > 0 ? count : -count,
          saturated ? Status{Status::Code::effort_limit, i} : Status{Status::Code::ok, -1}};
}

}  // namespace axial

#include <axial/options/end.hpp>
