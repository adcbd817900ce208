// Numbers with an exponent each, in integers: for the few steps in which no declared limit bounds what comes out. And
// sums of products over a long time, in 96 bits: exact, and forgetting at a rate that is a power of two.
#pragma once

#include <axial/fixed/words/divide.hpp>
#include <axial/scalar/rounding.hpp>

#include <axial/options/begin.hpp>

namespace axial::integer {

/// An integer high 2^32 + low. No branch: a carry is a comparison of unsigned words by the upper half of their sum.
struct WideSum {
  std::int64_t high = 0;  ///< with the sign
  std::uint32_t low = 0;  ///< the 32 bits below

  /// Adds x; what is summed stays within 2^94, as the caller has shown.
  AXIAL_INLINE constexpr void add(std::int64_t x) {
    const auto bits = static_cast<std::uint64_t>(x);
    const std::uint64_t sum = std::uint64_t{low} + static_cast<std::uint32_t>(bits);
    low = static_cast<std::uint32_t>(sum);
    high += (x >> 32) + static_cast<std::int64_t>(sum >> 32);
  }
  /// Takes 2^-shift of itself away, rounded down.
  template <int shift>
  AXIAL_INLINE constexpr void forget() {
    static_assert(shift > 0 && shift < 32);
    const auto bits = static_cast<std::uint64_t>(high);
    const std::uint32_t part = (low >> shift) | static_cast<std::uint32_t>(bits << (32 - shift));
    const std::uint64_t difference = std::uint64_t{low} - part;  // its upper half is 0 or -1: the borrow
    low = static_cast<std::uint32_t>(difference);
    high -= (high >> shift) - static_cast<std::int64_t>(static_cast<std::int32_t>(difference >> 32));
  }
};

}  // namespace axial::integer

namespace axial {
/// mantissa 2^exponent, 2^30 <= |mantissa| < 2^31, or 0 at exponent -4096. Results are cut, not rounded: an operation
/// errs by 2^-29 of its result, a sum by 2^-29 of its larger term. No branch, no table but of leading zeros, the same
/// bits everywhere. Exponents add up: stay below 2^20 of magnitude and nothing wraps.
struct Scaled {
  std::int32_t mantissa = 0;  ///< with the sign
  int exponent = -4096;       ///< of 2

  constexpr Scaled() = default;
  constexpr Scaled(std::int32_t m, int e) : mantissa(m), exponent(e) {}  ///< in normal form already
  constexpr explicit Scaled(Zero) {}                                     ///< 0
  constexpr explicit Scaled(One) : mantissa(1 << 30), exponent(-30) {}   ///< 1

  /// x 2^e in normal form.
  static constexpr Scaled normal(std::int64_t x, int e) {
    const auto sign = static_cast<std::uint64_t>(x >> 63), size = (static_cast<std::uint64_t>(x) ^ sign) - sign;
    const auto high = static_cast<std::uint32_t>(size >> 32), low = static_cast<std::uint32_t>(size);
    const std::uint32_t upper = 0U - static_cast<std::uint32_t>(high != 0U);
    const std::uint32_t first = (high & upper) | (low & ~upper), second = low & upper, none = first == 0U ? 1U : 0U;
    const auto zeros = static_cast<unsigned>(integer::detail::leading_zeros(first | none));
    const std::uint32_t top = (first << zeros) | ((second >> 1) >> (31U - zeros));
    const auto m = static_cast<std::int32_t>(top >> 1), s = static_cast<std::int32_t>(x >> 63);
    const int own = e + static_cast<int>(upper & 32U) + 1 - static_cast<int>(zeros);
    return {(m ^ s) - s, select(none != 0U, -4096, own)};
  }
  /// sum 2^e.
  static constexpr Scaled of(const integer::WideSum& sum, int e) {
    const std::int32_t word = static_cast<std::int32_t>(sum.high);
    const bool fits = sum.high == std::int64_t{word};
    const auto mask = std::uint64_t{0} - static_cast<std::uint64_t>(fits);
    const std::uint64_t joined = (static_cast<std::uint64_t>(sum.high) << 32) | sum.low;
    const std::uint64_t chosen = (joined & mask) | (static_cast<std::uint64_t>(sum.high) & ~mask);
    return normal(static_cast<std::int64_t>(chosen), e + select(fits, 0, 32));
  }
  /// The word at an exponent, rounded down; what does not fit is held at the largest, and `lost` set.
  constexpr std::int32_t as_word(int at, bool& lost) const {
    const int shift = -(exponent + at);
    const bool beyond = is_negative(shift) & (mantissa != 0);
    const int down = select(is_negative(shift), 0, shift), kept = select(is_negative(31 - down), 31, down);
    const std::int32_t sign = mantissa >> 31;
    lost = lost | beyond;
    return select(beyond, ((std::numeric_limits<std::int32_t>::max)() ^ sign) - sign, mantissa >> kept);
  }

  /// The opposite number.
  friend constexpr Scaled operator-(const Scaled& a) { return {-a.mantissa, a.exponent}; }
  /// Product.
  friend constexpr Scaled operator*(const Scaled& a, const Scaled& b) {
    return normal(integer::multiply(a.mantissa, b.mantissa), a.exponent + b.exponent);
  }
  /// Sum, at the larger exponent.
  friend constexpr Scaled operator+(const Scaled& a, const Scaled& b) {
    const bool swap = is_negative(a.exponent - b.exponent);
    const int e = select(swap, b.exponent, a.exponent);
    return normal(std::int64_t{lowered(a.mantissa, e - a.exponent)} + lowered(b.mantissa, e - b.exponent), e);
  }
  /// Difference.
  friend constexpr Scaled operator-(const Scaled& a, const Scaled& b) { return a + -b; }
  /// Sum, difference and product in place.
  ///@{
  constexpr Scaled& operator+=(const Scaled& b) { return *this = *this + b; }
  constexpr Scaled& operator-=(const Scaled& b) { return *this = *this - b; }
  constexpr Scaled& operator*=(const Scaled& b) { return *this = *this * b; }
  ///@}
  /// Comparison, by the sign of the difference.
  ///@{
  friend constexpr bool operator<(const Scaled& a, const Scaled& b) { return is_negative((a - b).mantissa); }
  friend constexpr bool operator>(const Scaled& a, const Scaled& b) { return b < a; }
  friend constexpr bool operator<=(const Scaled& a, const Scaled& b) { return !(b < a); }
  ///@}

 private:
  static constexpr std::int32_t lowered(std::int32_t m, int by) { return m >> select(is_negative(31 - by), 31, by); }
};

/// yes or no, by masks.
AXIAL_INLINE constexpr Scaled select(bool condition, const Scaled& yes, const Scaled& no) {
  const int y = yes.mantissa, n = no.mantissa;
  return {select(condition, y, n), select(condition, yes.exponent, no.exponent)};
}
/// 1 / x of x that is not 0; of 0 a large number.
AXIAL_INLINE constexpr Scaled reciprocal(const Scaled& x) {
  const std::int32_t sign = x.mantissa >> 31, size = (x.mantissa ^ sign) - sign;
  const auto r = integer::reciprocal(size | static_cast<std::int32_t>(size == 0));
  const auto m = static_cast<std::int32_t>(r.mantissa);
  return {(m ^ sign) - sign, -r.exponent - x.exponent};
}

/// Scaled as a number of kernels.
template <>
struct NumberTraits<Scaled> {
  static constexpr bool is_number = true;  ///< it is one
  /// Within 2^-31 of the value.
  static constexpr Scaled constant(double value) {
    double size = value < 0.0 ? -value : value;
    if (!(size > 0.0)) return {};
    int e = 0;
    for (; size >= 2147483647.0; ++e)
      size *= 0.5;
    for (; size < 1073741824.0; --e)
      size *= 2.0;
    const auto m = static_cast<std::int32_t>(size);
    return {value < 0.0 ? -m : m, e};
  }
  static constexpr Scaled epsilon() { return {1 << 30, -59}; }  ///< 2^-29
};

/// x as floating point, for a host.
template <class T>
[[nodiscard]] constexpr T to_real(const Scaled& x) {
  return static_cast<T>(x.mantissa) * static_cast<T>(detail::power_of_two(x.mantissa == 0 ? 0 : x.exponent));
}

}  // namespace axial

#include <axial/options/end.hpp>
