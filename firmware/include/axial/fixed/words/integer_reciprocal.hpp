// Reciprocals of positive integers.
#pragma once
#include <axial/scalar/language.hpp>

#include <cstdint>

#include <axial/fixed/words/integer_product.hpp>
#include <axial/scalar/inline.hpp>

#include <axial/options/begin.hpp>

/// 1 where the processor counts leading zeros, 0 where they are looked up. A build may define it to try the other one.
#ifndef AXIAL_COUNT_LEADING_ZEROS
#if defined(__ARM_FEATURE_CLZ) || defined(__riscv_zbb) || defined(__x86_64__) || defined(__aarch64__)
#define AXIAL_COUNT_LEADING_ZEROS 1
#else
#define AXIAL_COUNT_LEADING_ZEROS 0
#endif
#endif

namespace axial::integer {

namespace detail {

/// 2^k - 1 times a de Bruijn sequence: five other leading bits for each k in 1..32 (Leiserson, Prokop, Randall 1998).
constexpr std::uint32_t de_bruijn = 0x07C4ACDD;
struct LeadingZeros {
  std::uint8_t of[32] = {};
  constexpr LeadingZeros() {
    for (int k = 1; k <= 32; ++k)
      of[((0xFFFFFFFFU >> (32 - k)) * de_bruijn) >> 27] = static_cast<std::uint8_t>(32 - k);
  }
};
inline constexpr LeadingZeros leading_zeros_table{};

/// The number of zeros before the first one of d > 0. The library's routine branches.
AXIAL_INLINE constexpr int leading_zeros(std::uint32_t d) {
#if AXIAL_COUNT_LEADING_ZEROS
  return __builtin_clz(d);
#else
  d |= d >> 1, d |= d >> 2, d |= d >> 4, d |= d >> 8, d |= d >> 16;
  return leading_zeros_table.of[(d * de_bruijn) >> 27];
#endif
}

/// floor(a b / 2^31), where b <= 2^16 + 1 and the result is a word; of other b something.
template <class Word, class Bits>
AXIAL_INLINE constexpr Word scaled(Word a, Bits b) {
#if AXIAL_LONG_MULTIPLY
  return multiply_high(a, static_cast<Word>(b * 2U));
#else
  const Bits low = (static_cast<Bits>(a) & 0xFFFFU) * b;
  return static_cast<Word>(static_cast<Bits>(a >> 16) * b + (low >> 16)) >> 15;
#endif
}

/// See Reciprocal.
template <class Bits>
struct ReciprocalWords {
  Bits mantissa;  ///< in [2^30, 2^31)
  int exponent;   ///< in [31, 61]
};

// The words of reciprocal(), over whatever stands for a native integer.
template <class Bits, class Word>
AXIAL_INLINE constexpr ReciprocalWords<Bits> reciprocal_words(Word d) {
  const int shift = leading_zeros((static_cast<Bits>(d) << 1) | 1U);
  const Bits n = static_cast<Bits>(d) << shift;  // [2^30, 2^31)
  // 2^43 / n: (1 - T4(4f - 3) / T4(-3)) / f, where f = n / 2^31 and T4 is Chebyshev's polynomial; within 2^-9.
  const Bits f = n >> 15;
  const Bits y0 = 23170U - ((f * (48158U - ((f * (43614U - ((f * 58152U) >> 18))) >> 16))) >> 16);
  // 2^46 / n by Newton's step, within 2^-15.5. What it lacks fits the word, so no long product is needed; 32000 rounds.
  const auto e0 = static_cast<Word>((1U << 31) + 32000U - y0 * (n >> 12)) >> 5;
  const auto y1 = (y0 << 3) + static_cast<Bits>(static_cast<Word>(y0 * static_cast<Bits>(e0)) >> 23);
  // 2^61 / n by another; 28000 centres its error. 2^31 does not fit the mantissa.
  const auto e1 = static_cast<Word>(28000U - n * y1);
  const auto y2 = (y1 << 15) + static_cast<Bits>(scaled(e1, y1));
  return {y2 - (y2 >> 31), 61 - shift};
}

}  // namespace detail

/// 1/d = mantissa 2^-exponent; 2^30 <= mantissa < 2^31, so that it is a positive std::int32_t too; 31 <= exponent
/// <= 61.
using Reciprocal = detail::ReciprocalWords<std::uint32_t>;

/// Reciprocal of d in 1..2^31 - 1; the mantissa errs at most by one unit, -1 at powers of two and 0.86 upwards
/// (./axial exhaustive). 34 instructions on a Cortex-M3 or M4, 66 on a Cortex-M0, load and store included. For any
/// other d the result is some number, by operations that are defined.
AXIAL_INLINE constexpr Reciprocal reciprocal(std::int32_t d) { return detail::reciprocal_words<std::uint32_t>(d); }

}  // namespace axial::integer

#include <axial/options/end.hpp>
