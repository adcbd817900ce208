// What the kernels ask of a number: float and double here, the counting scalar and fixed point add themselves.
#pragma once

#include <axial/scalar/inline.hpp>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <axial/options/begin.hpp>

namespace axial {

/// Says whether T is a number that kernels compute with, and how a constant of the model becomes one.
/// Specialise it to add a number system: `is_number`, `constant(double)`, `epsilon()`.
template <class T, class = void>
struct NumberTraits {
  static constexpr bool is_number = false;  ///< whether kernels compute with T: not unless specialised
};

/// Floating point: constants are rounded to T by the compiler.
template <class T>
struct NumberTraits<T, std::enable_if_t<std::is_floating_point_v<T>>> {
  static constexpr bool is_number = true;                                      ///< T is a number
  static constexpr T constant(double value) { return static_cast<T>(value); }  ///< the nearest T
  static constexpr T epsilon() { return std::numeric_limits<T>::epsilon(); }   ///< distance from 1 to the next T
};

/// True where kernels compute with T.
template <class T>
inline constexpr bool is_number_v = NumberTraits<T>::is_number;

/// True for numbers, false for NaN and infinities; looks at the bits, so no compiler flag can optimise it away.
template <class T>
[[nodiscard]] constexpr bool is_finite(const T& x) {
  static_assert(std::numeric_limits<T>::is_iec559 && (sizeof(T) == 4 || sizeof(T) == 8));
  if constexpr (sizeof(T) == 4)
    return (__builtin_bit_cast(std::uint32_t, x) & 0x7F800000u) != 0x7F800000u;
  else
    return (__builtin_bit_cast(std::uint64_t, x) & 0x7FF0000000000000u) != 0x7FF0000000000000u;
}

/// One of the numbers that a T holds: T itself, but for a batch (batch.hpp), which holds several.
template <class T>
struct LaneOf {
  using type = T;  ///< the one number
};
/// The number of one lane: T for all but batches.
template <class T>
using Lane = typename LaneOf<T>::type;

/// A stored fixed-point number: its name alone, for what computes with it is a plug-in, <axial/fixed.hpp>.
template <class WordType>
struct Stored;
using Fixed32 = Stored<std::int32_t>;  ///< fixed point in 32 bits
using Fixed16 = Stored<std::int16_t>;  ///< fixed point in 16 bits

namespace detail {
/// The number that kernels take for T where what computes with T is missing and was asked for.
template <class T>
struct Substitute {
  using type = T;
};
template <class Word>
struct Substitute<Stored<Word>> {
  using type = double;
};
/// Whether numbers are words, whose formats something else must say.
template <class T>
inline constexpr bool is_word = !std::is_same_v<typename Substitute<T>::type, T>;
}  // namespace detail

}  // namespace axial

#include <axial/options/end.hpp>
