// Integer primitives of fixed point: products, sine-cosine pairs of binary angles, reciprocals. No branch, no overflow,
// the same bits on every processor and compiler.
#pragma once

#include <cstdint>

#include <axial/scalar/inline.hpp>

/// 1 where the processor multiplies 32 by 32 bits into 64, 0 where products are put together from pieces of 16 bits.
/// Both give the same bits; a build may define it to try the other one.
#ifndef AXIAL_LONG_MULTIPLY
#ifdef __ARM_ARCH_6M__
#define AXIAL_LONG_MULTIPLY 0
#else
#define AXIAL_LONG_MULTIPLY 1
#endif
#endif

namespace axial::integer {

namespace detail {

AXIAL_INLINE constexpr std::int32_t high_half(std::int32_t a) { return a >> 16; }
AXIAL_INLINE constexpr std::uint32_t high_half(std::uint32_t a) { return a >> 16; }
AXIAL_INLINE constexpr std::uint32_t low_half(std::uint32_t a) { return a & 0xFFFFU; }

/// floor(a b / 2^32) from four products of halves: no sum leaves the word, because (2^16 - 1)^2 + 2^16 - 1 < 2^32 and
/// 2^15 (2^16 - 1) + 2^16 - 1 < 2^31. Word is std::int32_t or std::uint32_t.
template <class Word>
AXIAL_INLINE constexpr Word high_word_by_halves(Word a, Word b) {
  const auto al = low_half(static_cast<std::uint32_t>(a)), bl = low_half(static_cast<std::uint32_t>(b));
  const Word ah = high_half(a), bh = high_half(b);
  const Word first = static_cast<Word>(al) * bh + static_cast<Word>((al * bl) >> 16);
  const Word second = ah * static_cast<Word>(bl) + static_cast<Word>(low_half(static_cast<std::uint32_t>(first)));
  return ah * bh + (first >> 16) + (second >> 16);
}

}  // namespace detail

/// floor(a b / 2^32).
AXIAL_INLINE constexpr std::int32_t multiply_high(std::int32_t a, std::int32_t b) {
#if AXIAL_LONG_MULTIPLY
  return static_cast<std::int32_t>((static_cast<std::int64_t>(a) * b) >> 32);
#else
  return detail::high_word_by_halves(a, b);
#endif
}
/// The same without signs.
AXIAL_INLINE constexpr std::uint32_t multiply_high(std::uint32_t a, std::uint32_t b) {
#if AXIAL_LONG_MULTIPLY
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(a) * b) >> 32);
#else
  return detail::high_word_by_halves(a, b);
#endif
}

/// The exact product a b.
AXIAL_INLINE constexpr std::int64_t multiply(std::int32_t a, std::int32_t b) {
#if AXIAL_LONG_MULTIPLY
  return static_cast<std::int64_t>(a) * b;
#else
  const std::uint32_t low = static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b);
  const auto high = static_cast<std::uint32_t>(multiply_high(a, b));
  return static_cast<std::int64_t>((static_cast<std::uint64_t>(high) << 32) | low);
#endif
}

/// sum + a b, modulo 2^64.
AXIAL_INLINE constexpr std::int64_t accumulate(std::int64_t sum, std::int32_t a, std::int32_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(sum) + static_cast<std::uint64_t>(multiply(a, b)));
}

/// Sine and cosine with 30 fractional bits.
struct SinCosBits {
  std::int32_t sin, cos;
};

/// Sine and cosine of bam 2 pi / 2^32 rad, within 1.0e-9; exact at quarter turns; sin(-x) = -sin(x), cos(-x) = cos(x).
AXIAL_INLINE constexpr SinCosBits sincos(std::uint32_t bam) {
  // Distance to the nearest multiple of a quarter turn, in units of an eighth turn / 2^31 and / 2^32, and its square.
  const std::uint32_t x = bam << 2, negative = 0U - (x >> 31);
  const std::uint32_t distance = (x ^ negative) - negative;
  const std::uint32_t v = (distance << 1) - (distance >> 31);
  const std::uint32_t z = multiply_high(v, v), z16 = z >> 16;
  const std::uint32_t a3 = 2799819U - ((z16 * 30334U) >> 16);
  const std::uint32_t a2 = 136187638U - multiply_high(z, a3);
  const std::uint32_t a1 = 2649351744U - multiply_high(z, a2);
  const std::uint32_t cosine = (1U << 30) - ((multiply_high(z, a1) + 4U) >> 3);
  const std::uint32_t b3 = 157084U - ((z16 * 1333U) >> 16);
  const std::uint32_t b2 = 10696155U - multiply_high(z, b3);
  const std::uint32_t b1 = 346799329U - multiply_high(z, b2);
  const std::uint32_t b0 = 3373259425U - multiply_high(z, b1);
  const std::uint32_t sine = (((multiply_high(v, b0) + 2U) >> 2) ^ negative) - negative;
  // Exchanged in odd quadrants, and the signs.
  const std::uint32_t quadrant = bam + (1U << 29), odd = 0U - ((quadrant >> 30) & 1U);
  const std::uint32_t exchange = (sine ^ cosine) & odd;
  const std::uint32_t sine_negative = 0U - (quadrant >> 31), cosine_negative = 0U - ((quadrant + (1U << 30)) >> 31);
  return {static_cast<std::int32_t>(((sine ^ exchange) ^ sine_negative) - sine_negative),
          static_cast<std::int32_t>(((cosine ^ exchange) ^ cosine_negative) - cosine_negative)};
}

namespace detail {

/// The number of zeros before the first one, 0 < d < 2^32.
AXIAL_INLINE constexpr int leading_zeros(std::uint32_t d) {
#if defined(__ARM_FEATURE_CLZ) || defined(__x86_64__) || defined(__aarch64__) || defined(__riscv_zbb)
  return __builtin_clz(d);
#else
  int count = 0;
  for (int step = 16; step > 0; step >>= 1) {
    const int shift = static_cast<int>((d >> (32 - step)) == 0U) * step;
    d <<= shift;
    count += shift;
  }
  return count;
#endif
}

}  // namespace detail

/// 1/d = mantissa 2^-exponent; 2^30 <= mantissa < 2^31, so that it is a positive std::int32_t too; 31 <= exponent
/// <= 61.
struct Reciprocal {
  std::uint32_t mantissa;
  int exponent;
};

/// Reciprocal of d in 1..2^31 - 1, mantissa within one unit.
AXIAL_INLINE constexpr Reciprocal reciprocal(std::int32_t d) {
  const int shift = detail::leading_zeros(static_cast<std::uint32_t>(d)) - 1;
  const std::uint32_t n = static_cast<std::uint32_t>(d) << shift;  // [2^30, 2^31)
  // 2^43 / n: (1 - T4(4f - 3) / T4(-3)) / f, where f = n / 2^31 and T4 is Chebyshev's polynomial; within 2^-9.
  const std::uint32_t f = n >> 15;
  const std::uint32_t y0 = 23170U - ((f * (48158U - ((f * (43614U - ((f * 58152U) >> 18))) >> 16))) >> 16);
  // 2^46 / n by Newton's step, within 2^-15.5. What it lacks fits the word, so no long product is needed.
  const auto e0 = static_cast<std::int32_t>((1U << 31) - y0 * (n >> 12)) >> 5;
  const std::uint32_t y1 =
      (y0 << 3) + static_cast<std::uint32_t>((static_cast<std::int32_t>(y0) * e0 + (1 << 22)) >> 23);
  // 2^61 / n by another; 26000 centres the error, and 2^31 is out of range.
  const auto e1 = static_cast<std::int32_t>(26000U - n * y1);
  const std::uint32_t y2 =
      (y1 << 15) + static_cast<std::uint32_t>(multiply_high(e1, static_cast<std::int32_t>(y1 << 1)));
  return {y2 - (y2 >> 31), 61 - shift};
}

}  // namespace axial::integer
