// The safe call of a control loop in fixed point: gains as words, feedback and steps by integers alone.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/control/tracking.hpp>
#include <axial/fixed/control/border.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Gains in units of the effort's format per unit of the error's, times 2^20: to_fixed_gains() makes them. Gains of
/// velocity errors have the same scale.
template <class S, class Word>
struct TrackingGains<S, Stored<Word>> {
  static constexpr int exponent = 20;           ///< of a gain
  std::int32_t stiffness[joint_count<S>] = {};  ///< from the base outwards
  std::int32_t damping[joint_count<S>] = {};    ///< from the base outwards
};

/// Gains after a conversion, and the first joint whose gain could not be kept as it was.
template <class S, class Word>
struct ConvertedGains {
  TrackingGains<S, Stored<Word>> gains{};  ///< the nearest that there are
  Status status{};                         ///< input_limit: negative, not a number or too large
};

namespace detail {

/// An error times a gain, in the effort's units, to nearest.
constexpr std::int64_t gained(std::int32_t error, std::int32_t gain, int exponent) {
  return (integer::multiply(error, gain) + (std::int64_t{1} << (exponent - 1))) >> exponent;
}

/// What is left of a way from one position to another, both within the range, along it; no branch on positions.
constexpr std::int32_t way_within(const PositionRange& range, const Fixed32& from, const Fixed32& to) {
  const std::uint32_t start = static_cast<std::uint32_t>(range.min);
  const std::uint32_t a = static_cast<std::uint32_t>(from.raw) - start, b = static_cast<std::uint32_t>(to.raw) - start;
  const bool every_angle = range.span == (std::numeric_limits<std::uint32_t>::max)();
  const auto round = static_cast<std::int32_t>(b - a);  // the short way round
  return every_angle ? round : nearest_word<std::int32_t>(std::int64_t{b} - std::int64_t{a});
}

template <class S, class Word>
struct Feedback<S, Stored<Word>> {
  using T = Stored<Word>;
  using Gains = TrackingGains<S, T>;
  static constexpr bool sound(const Gains& gains, int i) { return (gains.stiffness[i] | gains.damping[i]) >= 0; }
  static constexpr T add(const T& tau, int i, const Request<S, T>& desired, const MeasuredMotion<S, T>& measured,
                         const Gains& gains) {
    const std::int32_t q = way_within(fixed_limits_of<S, Word>.joints[i], measured.q[i], desired.q[i]);
    const std::int32_t qd =
        nearest_word<std::int32_t>(std::int64_t{desired.qd[i].raw} - std::int64_t{measured.qd[i].raw});
    return {nearest_word<Word>(tau.raw + gained(q, gains.stiffness[i], Gains::exponent) +
                               gained(qd, gains.damping[i], Gains::exponent))};
  }
};

template <class Word>
struct Step<Stored<Word>> {
  using T = Stored<Word>;
  static constexpr T unlimited() { return {(std::numeric_limits<Word>::max)()}; }
  static constexpr bool limit(T& target, const T& last, const T& step) {
    constexpr std::int64_t all = std::int64_t{1} << 32;  // the largest word is any change, from end to end
    const std::int64_t asked = step.raw == unlimited().raw ? all : std::int64_t{step.raw};
    const std::int64_t most = asked & ~(asked >> 63);
    const std::int64_t over = target.raw - (last.raw + most), under = last.raw - most - target.raw;
    const std::int64_t change = (under & ~(under >> 63)) - (over & ~(over >> 63));
    target.raw = static_cast<Word>(target.raw + change);
    return change != 0;
  }
};

/// A gain in words; `unit` is what one unit of the error is, in the effort's units.
constexpr std::int32_t gain_word(double gain, double unit, int exponent, bool& kept) {
  constexpr double most = 2147483647.0;
  const double exact = gain * unit * power_of_two(exponent);
  const bool good = exact >= 0.0 && exact <= most;
  kept = kept && good;
  return good ? static_cast<std::int32_t>(nearest_integer(exact)) : exact > most ? 2147483647 : 0;
}

}  // namespace detail

/// Gains in words, from N m/rad and N m s/rad, N/m and N s/m; meant for a constant:
/// `static constexpr auto gains = axial::to_fixed_gains<Robot, std::int32_t>(real).gains;`. Where a gain cannot be
/// kept, the status says so and names the joint: what is too large becomes the largest, what is negative or NaN 0.
template <class S, class Word>
[[nodiscard]] constexpr ConvertedGains<S, Word> to_fixed_gains(const TrackingGains<S, double>& real) {
  using T = Stored<Word>;
  using Q = Positions<robot_of<S>, T>;
  using Qd = Velocities<robot_of<S>, T>;
  constexpr int exponent = TrackingGains<S, T>::exponent;
  ConvertedGains<S, Word> result;
  for (int i = joint_count<S>; i-- > 0;) {
    const int effort = EffortsOf<S, T>::exponent(i);
    const double angle =
        detail::is_angle<Q>(i) ? detail::whole_turn / 4294967296.0 : detail::power_of_two(-Q::exponent(i));
    bool kept = true;
    result.gains.stiffness[i] =
        detail::gain_word(real.stiffness[i], angle * detail::power_of_two(effort), exponent, kept);
    result.gains.damping[i] =
        detail::gain_word(real.damping[i], detail::power_of_two(effort - Qd::exponent(i)), exponent, kept);
    if (!kept) result.status = {Status::Code::input_limit, i};
  }
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
