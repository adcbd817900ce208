// Division in fixed point: by a reciprocal of fixed length, whatever the operands.
#pragma once

#include <axial/fixed/words/round.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// 1/x of a positive Fx<E, S>: mantissa 2^(E - exponent), the mantissa with 31 significant bits.
template <int E, class S>
struct Inverse {
  std::int32_t mantissa{};  ///< in [2^30, 2^31)
  int exponent{};           ///< of the reciprocal of the raw word: 1 / raw = mantissa 2^-exponent
};

/// Reciprocal of x > 0: a mantissa and an exponent, at a time that does not depend on x.
template <int E, class S>
AXIAL_INLINE constexpr Inverse<E, S> inverse_of(const Fx<E, S>& x) {
  const auto r = integer::reciprocal(static_cast<std::int32_t>(x.raw));
  return {static_cast<std::int32_t>(r.mantissa), r.exponent};
}

namespace detail {

/// x / 2^shift for 0 <= shift < 64 where the result fits: down, with the same instructions for every shift.
AXIAL_INLINE constexpr std::int32_t shifted_by(std::int64_t x, int shift) {
  const auto low = static_cast<std::uint32_t>(x),
             high = static_cast<std::uint32_t>(static_cast<std::uint64_t>(x) >> 32);
  const auto sign = static_cast<std::uint32_t>(static_cast<std::int32_t>(high) >> 31);
  const std::uint32_t whole = 0U - ((static_cast<std::uint32_t>(shift) >> 5) & 1U);
  const unsigned rest = static_cast<unsigned>(shift) & 31U;
  const std::uint32_t l = (low & ~whole) | (high & whole), h = (high & ~whole) | (sign & whole);
  return static_cast<std::int32_t>((l >> rest) | ((h << 1) << (31U - rest)));
}

}  // namespace detail

/// x / y at exponent G, given 1/y. To nearest or down, as the arithmetic says.
template <int G, int E, int F, class S>
AXIAL_INLINE constexpr Fx<G, S> quotient(const Inverse<E, S>& inverse, const Fx<F, S>& x) {
  const std::int64_t product = integer::multiply(static_cast<std::int32_t>(x.raw), inverse.mantissa);
  const int shift = inverse.exponent + (F - E - G);
  const auto down = static_cast<std::uint32_t>(detail::shifted_by(product, shift));
  const std::uint32_t half = S::nearest ? static_cast<std::uint32_t>(detail::shifted_by(product, shift - 1)) & 1U : 0U;
  return {static_cast<typename S::Word>(down + half)};
}
/// Overload for a constant.
template <int G, int E, std::uint64_t B, class S>
AXIAL_INLINE constexpr auto quotient(const Inverse<E, S>& inverse, const Literal<B, S>& x) {
  return quotient<G>(inverse, round_to<detail::fitting_exponent(Literal<B, S>::value, S::capacity)>(x));
}

}  // namespace axial

#include <axial/options/end.hpp>
