// Real numbers to words of fixed point and back, by integers alone: no float routine, no branch on data.
#pragma once

#include <axial/fixed/words/integer.hpp>
#include <axial/scalar/select.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// The form of a float or double.
template <class T>
struct Ieee {
  using Bits = typename BitsOf<T>::type;
  static constexpr int digits = std::numeric_limits<T>::digits, bias = std::numeric_limits<T>::max_exponent - 1;
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
  const auto most = static_cast<Bits>((std::numeric_limits<Word>::max)());
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
  constexpr std::uint64_t most = (std::numeric_limits<std::int64_t>::max)();
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

}  // namespace axial::detail

#include <axial/options/end.hpp>
