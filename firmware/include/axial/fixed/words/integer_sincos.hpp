// Sine-cosine pairs of binary angles.
#pragma once
#include <axial/scalar/language.hpp>

#include <cstdint>

#include <axial/fixed/words/integer_multiplier.hpp>
#include <axial/scalar/inline.hpp>

#include <axial/options/begin.hpp>

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
