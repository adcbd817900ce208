// Words of 64 bits in one count of instructions, whatever they hold: shifts that no compiler knows, comparisons and
// choices, for which compilers of processors of 32 bits branch.
#pragma once

#include <axial/fixed/words/divide.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// x / 2^shift, rounded down, for 0 <= shift < 64; the same instructions for every shift.
AXIAL_INLINE constexpr std::int64_t wide_shifted_by(std::int64_t x, int shift) {
  const auto low = static_cast<std::uint32_t>(shifted_by(x, shift));
  const int sign = static_cast<int>(x >> 63), above = shifted_by(x, (shift + 32) & 63);
  const int high = select(is_less(shift, 32), above, sign);  // of int: a long, as newlib's words are, would be a branch
  return static_cast<std::int64_t>((std::uint64_t{static_cast<std::uint32_t>(high)} << 32) | low);
}
AXIAL_INLINE constexpr std::int64_t wide_magnitude(std::int64_t x) {
  const std::int64_t sign = x >> 63;
  return (x ^ sign) - sign;
}

/// a < b where the difference fits, by its sign; modulo 2^64, for a compiler compares 64 bits by branches where it sees
/// what is_less() means.
AXIAL_INLINE constexpr bool is_less_wide(std::int64_t a, std::int64_t b) {
  return ((static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b)) >> 63) != 0;
}
/// yes or no by a mask: of 64 bits a conditional expression becomes a branch.
AXIAL_INLINE constexpr std::int64_t select_wide(bool condition, std::int64_t yes, std::int64_t no) {
  return no ^ ((yes ^ no) & -static_cast<std::int64_t>(condition));
}

/// x / 2^shift to nearest, 1 <= shift < 64.
AXIAL_INLINE constexpr std::int64_t wide_rounded(std::int64_t x, int shift) {
  return (wide_shifted_by(x, shift - 1) + 1) >> 1;
}
/// x 2^shift for 0 <= shift < 32: a product with a power of 2 that the compiler does not know would be a call that
/// branches on a Cortex-M0.
AXIAL_INLINE constexpr std::int64_t wide_raised(std::int64_t x, int shift) {
  const auto low = static_cast<std::uint32_t>(x),
             high = static_cast<std::uint32_t>(static_cast<std::uint64_t>(x) >> 32);
  const auto by = static_cast<unsigned>(shift) & 31U;
  const std::uint32_t raised = (high << by) | ((low >> 1) >> (31U - by));
  return static_cast<std::int64_t>((std::uint64_t{raised} << 32) | (low << by));
}

/// 2^shift for 0 <= shift < 63.
AXIAL_INLINE constexpr std::int64_t wide_power(int shift) {
  const std::uint32_t bit = 1U << (static_cast<unsigned>(shift) & 31U);
  const std::uint32_t high = 0U - (static_cast<std::uint32_t>(shift) >> 5 & 1U);
  return static_cast<std::int64_t>((std::uint64_t{bit & high} << 32) | (bit & ~high));
}

/// x / 2^shift, rounded down, to the left where shift is negative; `fits` is cleared where that does not hold it.
AXIAL_INLINE constexpr std::int64_t moved_wide(std::int64_t x, int shift, bool& fits) {
  const int left = select(is_negative(shift), -shift, 0), right = shift + left;
  const std::int64_t down = wide_shifted_by(x, select(is_less(right, 64), right, 63));
  const bool slight = is_less_wide(wide_magnitude(down), std::int64_t{1} << 31), close = is_less(left, 32),
             none = is_less(left, 1);
  fits = fits & close & (slight | none);
  return wide_raised(down, select((slight & close) | none, left & 31, 0));
}
AXIAL_INLINE constexpr std::int32_t word_magnitude(std::int32_t x) {
  const std::int32_t sign = x >> 31;
  return (x ^ sign) - sign;
}
/// Whether |x| is at most what a word holds.
AXIAL_INLINE constexpr bool fits_word(std::int64_t x) {
  return is_less_wide(wide_magnitude(x), (std::int64_t{1} << 31) - 1);
}
/// Bits of |x|, one at least.
AXIAL_INLINE constexpr int wide_bits(std::int64_t x) {
  const auto size = static_cast<std::uint64_t>(wide_magnitude(x));
  const auto high = static_cast<std::uint32_t>(size >> 32), low = static_cast<std::uint32_t>(size);
  const int above = 64 - integer::detail::leading_zeros(high | 1U),
            below = 32 - integer::detail::leading_zeros(low | 1U);
  const int wide = -static_cast<int>((high | (0U - high)) >> 31);
  return (above & wide) | (below & ~wide);
}

}  // namespace axial::detail

#include <axial/options/end.hpp>
