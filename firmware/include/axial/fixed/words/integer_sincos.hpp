// Sine-cosine pairs of binary angles.
#pragma once
#include <axial/scalar/language.hpp>

#include <cstdint>

#include <axial/fixed/words/integer_product.hpp>
#include <axial/scalar/inline.hpp>

#include <axial/options/begin.hpp>

namespace axial::integer::detail {

#if AXIAL_LONG_MULTIPLY == 0 && defined(__ARM_ARCH_6M__)

/// floor((2^16 high + low) a / 2^32) without signs, 17 instructions. The mixed sum's carry is its borrow plus 1, which
/// takes a register less than adding a carry to zero.
AXIAL_INLINE inline std::uint32_t high_word_by_assembler(std::uint32_t low, std::uint32_t high, std::uint32_t a) {
  std::uint32_t t, u;
  asm(".syntax unified\n\t"
      "uxth %[t], %[a]\n\t"
      "lsrs %[a], %[a], #16\n\t"
      "movs %[u], %[t]\n\t"
      "muls %[u], %[low], %[u]\n\t"
      "lsrs %[u], %[u], #16\n\t"
      "muls %[t], %[high], %[t]\n\t"
      "adds %[t], %[t], %[u]\n\t"
      "movs %[u], %[a]\n\t"
      "muls %[u], %[low], %[u]\n\t"
      "muls %[a], %[high], %[a]\n\t"
      "adds %[t], %[t], %[u]\n\t"
      "sbcs %[u], %[u]\n\t"
      "adds %[u], %[u], #1\n\t"
      "lsls %[u], %[u], #16\n\t"
      "lsrs %[t], %[t], #16\n\t"
      "adds %[a], %[a], %[t]\n\t"
      "adds %[a], %[a], %[u]\n\t"
      : [a] "+l"(a), [t] "=&l"(t), [u] "=&l"(u)
      : [low] "l"(low), [high] "l"(high)
      : "cc");
  return a;
}

#endif

/// floor(a b / 2^32) for one a and many b: where there is no long multiplication, the halves of a are made once. Bits
/// is std::uint32_t, or a word that brings its own multiply_high_unsigned.
template <class Bits>
class Multiplier {
 public:
  AXIAL_INLINE explicit constexpr Multiplier(Bits a) : a_{a}, low_{a & 0xFFFFU}, high_{a >> 16} {}
  AXIAL_INLINE constexpr Bits high() const { return high_; }
  AXIAL_INLINE constexpr Bits operator*(Bits b) const {
#if AXIAL_LONG_MULTIPLY == 0 && defined(__ARM_ARCH_6M__)
    if (!__builtin_is_constant_evaluated()) return high_word_by_assembler(low_, high_, b);
#endif
    return multiply_high_unsigned(a_, b);
  }
  AXIAL_INLINE constexpr Bits square() const {
#if AXIAL_LONG_MULTIPLY
    return multiply_high_unsigned(a_, a_);
#else
    return high_ * high_ + ((high_ * low_ + ((low_ * low_) >> 17)) >> 15);
#endif
  }

 private:
  [[maybe_unused]] Bits a_, low_, high_;  // which of them depends on the processor
};

}  // namespace axial::integer::detail

namespace axial::integer {

/// Sine and cosine with 30 fractional bits.
template <class Word>
struct SinCosWords {
  Word sin, cos;  ///< value 2^30
};
using SinCosBits = SinCosWords<std::int32_t>;  ///< of native integers

/// What sine and cosine err at most, over all angles (`./axial exhaustive`).
inline constexpr double sincos_error = 6.3e-10;

namespace detail {

// The words of sincos(), over whatever stands for a native integer.
template <class Word, class Bits>
AXIAL_INLINE constexpr SinCosWords<Word> sincos_words(Bits bam) {
  // v / 2^32: the distance to the nearest quarter turn over an eighth of a turn; z / 2^32 its square.
  const Bits x = bam << 2, minus = 0U - (x >> 31), distance = (x ^ minus) - minus;
  auto v = Multiplier<Bits>((distance << 1) - (distance >> 31));
  auto z = Multiplier<Bits>(v.square());
  // Coefficients: minimax by reweighted least squares in 40 digits (1.7e-12 for sin, 5.4e-11 for cos), then their last
  // bits by random descent on the largest error of the integers as computed here, over 4 * 10^5 angles.
  // sin = v (b0 - z (b1 - ...)), 32 fractional bits in b0 and 35 in the others.
  const Bits b3 = 1256540U - ((z.high() * 10571U) >> 16);
  const Bits b0 = 3373259426U - ((z * (2774394679U - z * (85569236U - z * b3))) >> 3);
  const Bits sine = (v * b0 + 2U) >> 2;
  // cos = 1 - z (a1 - z (a2 - ...)), 33 fractional bits in a1, 35 in a2 and a3, 34 in the last.
  const Bits a3 = 11199269U - ((z.high() * 60661U) >> 15);
  const Bits a1 = 2649351742U - ((z * (544750554U - z * a3)) >> 2);
  const Bits cosine = (1U << 30) - ((z * a1 + 5U) >> 3);
  // Exchanged in the second and third of each four octants, and the signs.
  const Bits exchange = (sine ^ cosine) & (0U - (((bam + (1U << 29)) >> 30) & 1U));
  const Bits sine_minus = 0U - (bam >> 31), cosine_minus = 0U - ((bam + (1U << 30)) >> 31);
  return {static_cast<Word>(((sine ^ exchange) ^ sine_minus) - sine_minus),
          static_cast<Word>(((cosine ^ exchange) ^ cosine_minus) - cosine_minus)};
}

}  // namespace detail

/// Sine and cosine of bam 2 pi / 2^32 rad, within sincos_error; exact at quarter turns, symmetric:
/// sin(-x) = -sin(x), cos(-x) = cos(x). 52 instructions on a Cortex-M3 or M4, 201 on a Cortex-M0, load and store
/// included.
AXIAL_INLINE constexpr SinCosBits sincos(std::uint32_t bam) { return detail::sincos_words<std::int32_t>(bam); }

}  // namespace axial::integer

#include <axial/options/end.hpp>
