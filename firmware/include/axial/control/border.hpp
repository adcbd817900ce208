// Joint values at the border between real numbers and fixed point: by integers alone, nearest, never silently wrong.
#pragma once

#include <axial/control/limits.hpp>
#include <axial/scalar/integer.hpp>

namespace axial {

/// Joint values after a conversion, and the first joint whose value could not be kept as it was.
template <class Values>
struct Converted {
  Values values{};
  Status status{};
};

namespace detail {

template <class T>
struct Ieee;
template <>
struct Ieee<float> {
  using Bits = std::uint32_t;
  static constexpr int digits = 24, bias = 127;
};
template <>
struct Ieee<double> {
  using Bits = std::uint64_t;
  static constexpr int digits = 53, bias = 1023;
};

/// A real number as (-1)^negative significand 2^exponent.
template <class T>
struct Parts {
  typename Ieee<T>::Bits significand;
  int exponent;
  bool negative, finite, nan;
};

template <class T>
constexpr Parts<T> parts_of(const T& x) {
  using F = Ieee<T>;
  using Bits = typename F::Bits;
  constexpr Bits one = Bits{1} << (F::digits - 1);
  constexpr int largest_field = 2 * F::bias + 1;
  const Bits bits = __builtin_bit_cast(Bits, x);
  const Bits fraction = bits & (one - 1);
  const int field = static_cast<int>(bits >> (F::digits - 1)) & largest_field;
  const int subnormal = static_cast<int>(field == 0), special = static_cast<int>(field == largest_field);
  return {fraction | (one & (static_cast<Bits>(subnormal) - 1)), field + subnormal - F::bias - (F::digits - 1),
          (bits >> (8 * sizeof(Bits) - 1)) != 0, special == 0, special != 0 && fraction != 0};
}

/// Integers in the order of the numbers; both zeros are 0, NaN is beyond the infinities.
template <class T>
constexpr auto ordered(const T& x) {
  using Bits = typename Ieee<T>::Bits;
  const Bits bits = __builtin_bit_cast(Bits, x);
  const Bits sign = Bits{0} - (bits >> (8 * sizeof(Bits) - 1));
  return static_cast<std::make_signed_t<Bits>>((((bits << 1) >> 1) ^ sign) - sign);
}
template <class T>
constexpr bool below(const T& a, const T& b) {
  return ordered(a) < ordered(b);
}

constexpr int within(int x, int low, int high) {
  x = select(x < low, low, x);
  return select(x > high, high, x);
}

/// significand * 2^shift to nearest, halves up, at most `most`.
template <class Bits>
constexpr Bits shifted_to(Bits significand, int shift, Bits most) {
  constexpr int widest = 8 * static_cast<int>(sizeof(Bits)) - 1;
  const int right = within(-shift, 0, widest), left = within(shift, 0, widest);
  const Bits nearest = (((significand << 1) >> right) + 1) >> 1;
  const Bits fits = Bits{0} - static_cast<Bits>(nearest <= (most >> left));
  return ((nearest << left) & fits) | (most & ~fits);
}

constexpr std::int32_t signed_word(std::uint32_t magnitude, bool negative) {
  const std::uint32_t sign = 0U - static_cast<std::uint32_t>(negative);
  return static_cast<std::int32_t>((magnitude ^ sign) - sign);
}

/// x 2^exponent to nearest, halves away from 0; saturates; NaN is 0.
template <class Word, class T>
constexpr Word to_word(const T& x, int exponent) {
  using Bits = typename Ieee<T>::Bits;
  const auto p = parts_of(x);
  const auto most = static_cast<Bits>(std::numeric_limits<Word>::max());
  const Bits magnitude = shifted_to<Bits>(p.significand, p.exponent + exponent, most);
  const Bits number = Bits{0} - static_cast<Bits>(!p.nan);
  return static_cast<Word>(signed_word(static_cast<std::uint32_t>(magnitude & number), p.negative));
}

/// Radians that a binary angle is made from; beyond them a real number saturates.
inline constexpr double most_radians = 512.0;

/// Radians to a binary angle: nearest, to 2^-20 of a unit.
template <class T>
constexpr std::int32_t to_angle(const T& radians) {
  constexpr int fraction = 54;                                    // 512 rad fit 63 bits
  constexpr std::uint32_t high = 0x28BE60DBU, low = 0x9391054AU;  // 2^64 / (2 pi)
  constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
  const auto p = parts_of(radians);
  const auto r = shifted_to<std::uint64_t>(p.significand, p.exponent + fraction, most);
  const auto r1 = static_cast<std::uint32_t>(r >> 32), r0 = static_cast<std::uint32_t>(r);
  std::uint64_t turns = static_cast<std::uint64_t>(r1) * high;  // 2^-54 of a turn
  turns += std::uint64_t{integer::multiply_high_unsigned(r1, low)} + integer::multiply_high_unsigned(r0, high);
  const auto nearest = static_cast<std::uint32_t>((turns + (1U << (fraction - 33))) >> (fraction - 32));
  return signed_word(nearest & (0U - static_cast<std::uint32_t>(!p.nan)), p.negative);
}

/// Significand 2^exponent, its highest bit set or all 0, as the nearest T, halves to even; below the normal numbers 0.
template <class T>
constexpr T assembled(bool negative, std::uint64_t significand, int exponent) {
  using F = Ieee<T>;
  using Bits = typename F::Bits;
  constexpr int dropped = 64 - F::digits;
  const std::uint64_t kept = significand >> dropped, rest = significand & ((std::uint64_t{1} << dropped) - 1);
  const auto up = static_cast<Bits>(rest + (kept & 1U) > (std::uint64_t{1} << (dropped - 1)));
  const int field = exponent + dropped + F::digits - 1 + F::bias;
  const Bits bits = (static_cast<Bits>(field - 1) << (F::digits - 1)) + static_cast<Bits>(kept) + up;
  const Bits present = Bits{0} - static_cast<Bits>(significand != 0 && field > 0);
  return __builtin_bit_cast(T, (bits & present) | (static_cast<Bits>(negative) << (8 * sizeof(Bits) - 1)));
}

/// An integer as a significand and what it was shifted by.
struct Normalised {
  std::uint32_t significand;
  int shift;
  bool negative;
};
constexpr Normalised normalised(std::int32_t raw) {
  const bool negative = raw < 0;
  const auto magnitude = static_cast<std::uint32_t>(signed_word(static_cast<std::uint32_t>(raw), negative));
  const int shift = integer::detail::leading_zeros(magnitude | static_cast<std::uint32_t>(magnitude == 0));
  return {magnitude << shift, shift, negative};
}

template <class T>
constexpr T from_word(std::int32_t raw, int exponent) {
  const Normalised n = normalised(raw);
  return assembled<T>(n.negative, static_cast<std::uint64_t>(n.significand) << 32, -32 - n.shift - exponent);
}

/// A binary angle in [-pi, pi), to nearest but for the last bits of 64.
template <class T>
constexpr T from_angle(std::int32_t raw) {
  constexpr std::uint32_t high = 0xC90FDAA2U, low = 0x2168C235U;  // 2 pi 2^61
  const Normalised n = normalised(raw);
  std::uint64_t radians = static_cast<std::uint64_t>(n.significand) * high;
  radians += integer::multiply_high_unsigned(n.significand, low);
  const int shift = static_cast<int>(~radians >> 63);
  return assembled<T>(n.negative, radians << shift, -61 - n.shift - shift);
}

template <class Role>
constexpr Status::Code limit_code() {
  using Code = Status::Code;
  if constexpr (std::is_same_v<Role, role::Position>) return Code::position_limit;
  if constexpr (std::is_same_v<Role, role::Velocity>) return Code::speed_limit;
  if constexpr (std::is_same_v<Role, role::Acceleration>) return Code::acceleration_limit;
  return Code::effort_limit;
}

/// Declared range of a role's value: real, and raw.
template <class T, class Word>
struct RoleRange {
  T low, high;
  Word raw_low, raw_high;
};

template <class S, class T, class Word, class Role>
constexpr auto role_range(int i) {
  using RoleWord = typename Joints<S, Stored<Word>, Role>::Value::Word;
  const auto& real = limits_of<robot_of<S>, T>.joints[i];
  const auto& raw = fixed_limits_of<S, Word>.joints[i];
  using Range = RoleRange<T, RoleWord>;
  if constexpr (std::is_same_v<Role, role::Position>)
    return Range{real.position_min, real.position_max, raw.min, raw.max};
  else if constexpr (std::is_same_v<Role, role::Velocity>)
    return Range{-real.speed, real.speed, Word(-raw.speed.raw), raw.speed.raw};
  else if constexpr (std::is_same_v<Role, role::Acceleration>)
    return Range{-real.acceleration, real.acceleration, Word(-raw.acceleration.raw), raw.acceleration.raw};
  else
    return Range{-real.effort, real.effort, Word(-raw.effort.raw), raw.effort.raw};
}

/// Joint i's value in its role's format, the nearest within the declared range.
template <class Values, class T>
constexpr Status::Code convert(typename Values::Value& to, int i, const T& x) {
  using Traits = RoleTraits<Values>;
  using Word = typename Values::Value::Word;
  const auto range = role_range<typename Traits::S, T, typename Traits::Word, typename Traits::Role>(i);
  bool under = below(x, range.low), over = below(range.high, x);
  if (is_angle<Values>(i)) {
    const RawReach& reach = fixed_limits_of<typename Traits::S, typename Traits::Word>.joints[i];
    const Fixed32 angle = reach.nearest({to_angle(x)});  // a limit may round outwards
    to = {static_cast<Word>(angle.raw)};
    const T far = static_cast<T>(most_radians);
    under = under || below(x, -far), over = over || below(far, x);
  } else {
    const Word raw = to_word<Word>(x, Values::exponent(i));
    to = {raw < range.raw_low ? range.raw_low : raw > range.raw_high ? range.raw_high : raw};
  }
  if (!is_finite(x)) return Status::Code::not_finite;
  return under || over ? limit_code<typename Traits::Role>() : Status::Code::ok;
}

}  // namespace detail

/// Real joint values (SI, rad) in the formats of a role: to_fixed<Positions<Robot, Fixed32>>(q).
/// Each is rounded to nearest: halves away from 0; angles modulo a turn, to 2^-20 of their unit of 2^-32 turns. A value
/// outside the declared limits gives the nearest limit (an angle the nearer end along the circle) and a status that
/// names the first such joint and the limit; NaN gives 0, brought inside the limits, and `not_finite`, as infinities
/// do. Joints without position limits take angles up to 512 rad; count turns as encoders do (encoder.hpp) to go
/// further. Integers alone: no float routine is linked, and the loop's length is the only bound there is on time.
template <class Values, class T>
[[nodiscard]] constexpr Converted<Values> to_fixed(
    const Joints<robot_of<typename detail::RoleTraits<Values>::S>, T>& x) {
  Converted<Values> result;
  for (int i = Values::size; i-- > 0;) {
    const Status::Code code = detail::convert<Values>(result.values[i], i, x[i]);
    if (code != Status::Code::ok) result.status = {code, i};
  }
  return result;
}

/// A desired motion in fixed point. The status is that of check_request() on the real numbers; feedforward() must not
/// see a motion that has a bad one, unless the caller means to follow it as far as the limits go.
template <class S, class Word, class T>
[[nodiscard]] constexpr Request<S, Stored<Word>> to_fixed_request(const Joints<robot_of<S>, T>& q,
                                                                  const Joints<robot_of<S>, T>& qd,
                                                                  const Joints<robot_of<S>, T>& qdd) {
  using Robot = robot_of<S>;
  Request<S, Stored<Word>> request;
  for (int i = joint_count<S>; i-- > 0;) {
    using Code = Status::Code;
    const Code a = detail::convert<Positions<Robot, Stored<Word>>>(request.q[i], i, q[i]);
    const Code b = detail::convert<Velocities<Robot, Stored<Word>>>(request.qd[i], i, qd[i]);
    const Code c = detail::convert<Accelerations<Robot, Stored<Word>>>(request.qdd[i], i, qdd[i]);
    const bool number = a != Code::not_finite && b != Code::not_finite && c != Code::not_finite;
    const Code first = !number ? Code::not_finite : a != Code::ok ? a : b != Code::ok ? b : c;
    if (first != Code::ok) request.status = {first, i};
  }
  return request;
}

/// Joint values of a role as real numbers (SI, rad in [-pi, pi)), to nearest: halves to even, angles to the last bit of
/// T but for a few in 2^32 (float) or one unit (double). to_fixed() of the result is the argument where T is double.
template <class T, class SceneOrRobot, class Word, class Role>
constexpr Joints<robot_of<SceneOrRobot>, T> to_real(const Joints<SceneOrRobot, Stored<Word>, Role>& values) {
  using Values = Joints<SceneOrRobot, Stored<Word>, Role>;
  Joints<robot_of<SceneOrRobot>, T> result{};
  for (int i = 0; i < Values::size; ++i)
    result[i] = detail::is_angle<Values>(i) ? detail::from_angle<T>(values[i].raw)
                                            : detail::from_word<T>(values[i].raw, Values::exponent(i));
  return result;
}

}  // namespace axial
