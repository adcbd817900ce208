// Products of 32-bit integers: exact, summed, or their high words; the same bits on every processor.
#pragma once
#include <axial/scalar/language.hpp>

#include <cstdint>

#include <axial/scalar/inline.hpp>

/// 1 where the processor multiplies 32 by 32 bits into 64, 0 where products are put together from halves. Both give the
/// same bits; a build may define it to try the other one.
#ifndef AXIAL_LONG_MULTIPLY
#ifdef __ARM_ARCH_6M__
#define AXIAL_LONG_MULTIPLY 0
#else
#define AXIAL_LONG_MULTIPLY 1
#endif
#endif

/// 1 for exact products by a call each, on a Cortex-M0 alone: a third of the flash, a fifth more instructions.
#ifndef AXIAL_MULTIPLY_BY_CALL
#define AXIAL_MULTIPLY_BY_CALL 0
#endif

#if AXIAL_LONG_MULTIPLY == 0
#include <axial/fixed/words/integer_halves.hpp>
#if AXIAL_MULTIPLY_BY_CALL && defined(__ARM_ARCH_6M__)
#include <axial/fixed/words/integer_calls.hpp>
#endif
#endif

#include <axial/options/begin.hpp>

namespace axial::integer {

/// What the caller knows of two factors. Narrow ones, |a|, |b| <= 2^30, save 3 instructions per product on a Cortex-M0
/// (sines and cosines with 30 fractional bits by anything within 2^30) and nothing elsewhere; others go wrong there.
enum class Factors { any, narrow };

namespace detail {

AXIAL_INLINE constexpr std::uint64_t as_unsigned(std::int64_t a) { return static_cast<std::uint64_t>(a); }

template <Factors factors>
AXIAL_INLINE constexpr std::uint64_t product(std::int32_t a, std::int32_t b) {
#if AXIAL_LONG_MULTIPLY
  return as_unsigned(static_cast<std::int64_t>(a) * b);
#else
#ifdef __ARM_ARCH_6M__
  if (!compiler_does_better(a, b)) return product_by_assembler<factors == Factors::narrow>(a, b);
#endif
  return product_by_halves(a, b);
#endif
}

}  // namespace detail

/// The exact product a b. Cortex-M0: 17 instructions.
template <Factors factors = Factors::any>
AXIAL_INLINE constexpr std::int64_t multiply(std::int32_t a, std::int32_t b) {
  return static_cast<std::int64_t>(detail::product<factors>(a, b));
}

/// sum + a b, modulo 2^64. Cortex-M0: 19 instructions.
template <Factors factors = Factors::any>
AXIAL_INLINE constexpr std::int64_t accumulate(std::int64_t sum, std::int32_t a, std::int32_t b) {
#if AXIAL_LONG_MULTIPLY == 0 && defined(__ARM_ARCH_6M__)
  if (!detail::compiler_does_better(a, b))
    return static_cast<std::int64_t>(
        detail::sum_by_assembler<factors == Factors::narrow>(detail::as_unsigned(sum), a, b));
#endif
  return static_cast<std::int64_t>(detail::as_unsigned(sum) + detail::product<factors>(a, b));
}

/// sum - a b, modulo 2^64. Cortex-M0: 19 instructions.
template <Factors factors = Factors::any>
AXIAL_INLINE constexpr std::int64_t deduct(std::int64_t sum, std::int32_t a, std::int32_t b) {
#if AXIAL_LONG_MULTIPLY == 0 && defined(__ARM_ARCH_6M__)
  if (!detail::compiler_does_better(a, b))
    return static_cast<std::int64_t>(
        detail::difference_by_assembler<factors == Factors::narrow>(detail::as_unsigned(sum), a, b));
#endif
  return static_cast<std::int64_t>(detail::as_unsigned(sum) - detail::product<factors>(a, b));
}

/// floor(a b / 2^32). Cortex-M0: 17 instructions, narrow 14.
template <Factors factors = Factors::any>
AXIAL_INLINE constexpr std::int32_t multiply_high(std::int32_t a, std::int32_t b) {
#if AXIAL_LONG_MULTIPLY
  return static_cast<std::int32_t>((static_cast<std::int64_t>(a) * b) >> 32);
#else
#ifdef __ARM_ARCH_6M__
  if (!detail::compiler_does_better(a, b)) return detail::high_word_by_assembler<factors == Factors::narrow>(a, b);
#endif
  return detail::high_word_by_halves(a, b);
#endif
}

/// floor(a b / 2^32) without signs. Not an overload: std::int32_t is long on Arm, and an int would choose this one.
AXIAL_INLINE constexpr std::uint32_t multiply_high_unsigned(std::uint32_t a, std::uint32_t b) {
#if AXIAL_LONG_MULTIPLY
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(a) * b) >> 32);
#else
  return detail::high_word_by_halves(a, b);
#endif
}

}  // namespace axial::integer

#include <axial/options/end.hpp>
