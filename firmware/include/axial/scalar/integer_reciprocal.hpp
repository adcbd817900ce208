// Reciprocals of positive integers.
#pragma once

#include <cstdint>

#include <axial/scalar/inline.hpp>
#include <axial/scalar/integer_product.hpp>

namespace axial::integer {

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
