// Whether a number is one.
#pragma once

#include <axial/scalar/traits.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// True for numbers, false for NaN and infinities; looks at the bits, so no compiler flag can optimise it away.
template <class T>
[[nodiscard]] constexpr bool is_finite(const T& x) {
  static_assert(std::numeric_limits<T>::is_iec559 && (sizeof(T) == 4 || sizeof(T) == 8));
  if constexpr (sizeof(T) == 4)
    return (__builtin_bit_cast(std::uint32_t, x) & 0x7F800000u) != 0x7F800000u;
  else
    return (__builtin_bit_cast(std::uint64_t, x) & 0x7FF0000000000000u) != 0x7FF0000000000000u;
}

}  // namespace axial

#include <axial/options/end.hpp>
