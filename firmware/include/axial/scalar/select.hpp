// Choices that compile to the same instructions whichever way they go.
#pragma once

#include <axial/scalar/structural.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {
template <class T, std::size_t bytes = sizeof(T)>
struct BitsOf;
template <class T>
struct BitsOf<T, 4> {
  using type = std::uint32_t;
};
template <class T>
struct BitsOf<T, 8> {
  using type = std::uint64_t;
};
}  // namespace detail

/// yes or no, by the bits of a float or double and a mask: a conditional expression may become a branch.
template <class T, std::enable_if_t<std::is_floating_point_v<T> && sizeof(T) <= 8, int> = 0>
AXIAL_INLINE constexpr T select(bool condition, const T& yes, const T& no) {
  using Bits = typename detail::BitsOf<T>::type;
  const Bits y = __builtin_bit_cast(Bits, yes), n = __builtin_bit_cast(Bits, no);
  return __builtin_bit_cast(T, static_cast<Bits>(n ^ ((y ^ n) & (Bits{0} - static_cast<Bits>(condition)))));
}
/// Overload for other numbers.
template <class T, std::enable_if_t<!std::is_floating_point_v<T> || (sizeof(T) > 8), int> = 0>
AXIAL_INLINE constexpr T select(bool condition, const T& yes, const T& no) {
  return condition ? yes : no;
}
/// What has been found (an index, -1 for nothing), or `index` where it is found now.
AXIAL_INLINE constexpr int first_found(int found, bool now, int index) {
  const int open = (found >> (8 * static_cast<int>(sizeof(int)) - 1)) & -static_cast<int>(now);
  return (index & open) | (found & ~open);
}
/// x < 0, by its sign bit.
AXIAL_INLINE constexpr bool is_negative(int x) { return (static_cast<unsigned>(x) >> (8 * sizeof(int) - 1)) != 0; }
/// Overload for an index.
AXIAL_INLINE constexpr int select(bool condition, int yes, int no) {
  const int mask = -static_cast<int>(condition);
  return (yes & mask) | (no & ~mask);
}

/// |x|.
template <class T>
AXIAL_INLINE constexpr T magnitude(const T& x) {
  return select(x < T(Zero{}), T(-x), x);
}

namespace detail {
// |x|, of a structural scalar as a type.
template <class X>
AXIAL_INLINE constexpr auto absolute(const X& x) {
  if constexpr (is_structural_v<X>)
    return Int<(X::value < 0 ? -X::value : X::value)>{};
  else
    return magnitude(x);
}
}  // namespace detail

}  // namespace axial

#include <axial/options/end.hpp>
