// Sums of products over a long time, in 96 bits: exact, and forgetting at a rate that is a power of two.
#pragma once

#include <axial/fixed/words/integer.hpp>

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

#include <axial/options/end.hpp>
