// Numbers that the type system knows: 0, 1 and -1 cost nothing, on every compiler and without -ffast-math.
#pragma once

#include <axial/scalar/traits.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// The integer N as a type. `Zero * x` is `Zero`, `Zero + x` is `x`, `One * x` is `x`, `MinusOne * x` is `-x`.
/// The compiler computes with two of them; a result outside {0, 1, -1} is a constant of the number that it meets.
template <int N>
struct Int {
  static constexpr int value = N;  ///< the integer itself
  /// The number T that it stands for.
  template <class T, class = std::enable_if_t<is_number_v<T>>>
  AXIAL_INLINE constexpr operator T() const {  // NOLINT(google-explicit-constructor): a zero is a valid float
    return NumberTraits<T>::constant(static_cast<double>(N));
  }
};

using Zero = Int<0>;       ///< 0 as a type
using One = Int<1>;        ///< 1 as a type
using MinusOne = Int<-1>;  ///< -1 as a type

/// Whether a type is an Int.
template <class T>
struct IsStructural : std::false_type {};
template <int N>
struct IsStructural<Int<N>> : std::true_type {};

/// True for Int<N>.
template <class T>
inline constexpr bool is_structural_v = IsStructural<T>::value;

/// How a result becomes a plain number of a type.
template <class T>
struct Holding {
  /// X as T: structural scalars become constants.
  template <class X>
  AXIAL_INLINE static constexpr T of(const X& x) {
    return x;
  }
};

/// True for a type that is zero whatever happens at run time.
template <class T>
inline constexpr bool is_zero_v = std::is_same_v<T, Zero>;

/// True for anything that may stand in a formula: a number or a structural scalar.
template <class T>
inline constexpr bool is_scalar_v = is_number_v<T> || is_structural_v<T>;

namespace detail {
template <class T>
using if_number = std::enable_if_t<is_number_v<T>, int>;

// What a number system may give its own form to: a small integer beside a number T, and a constant of a model.
template <class T, class = void>
struct Constants {
  template <int N>
  AXIAL_INLINE static constexpr T integer(Int<N> n) {
    return n;
  }
  template <std::uint64_t bits>
  AXIAL_INLINE static constexpr T constant() {
    return NumberTraits<T>::constant(__builtin_bit_cast(double, bits));
  }
};
template <class T, int N>
AXIAL_INLINE constexpr auto integer(Int<N> n) {
  return Constants<T>::integer(n);
}
}  // namespace detail

/// Arithmetic of structural scalars, done by the compiler.
///@{
template <int N>
AXIAL_INLINE constexpr Int<-N> operator-(Int<N>) {
  return {};
}
template <int N, int M>
AXIAL_INLINE constexpr Int<N + M> operator+(Int<N>, Int<M>) {
  return {};
}
template <int N, int M>
AXIAL_INLINE constexpr Int<N - M> operator-(Int<N>, Int<M>) {
  return {};
}
template <int N, int M>
AXIAL_INLINE constexpr Int<N * M> operator*(Int<N>, Int<M>) {
  return {};
}
///@}

/// A structural scalar and a number: 0 and 1 cost nothing, -1 a sign; 2 x is x + x; any other is a constant of T.
///@{
template <int N, class T, detail::if_number<T> = 0>
AXIAL_INLINE constexpr auto operator*(Int<N>, const T& x) {
  if constexpr (N == 0)
    return Zero{};
  else if constexpr (N == 1)
    return x;
  else if constexpr (N == -1)
    return -x;
  else if constexpr (N == 2)
    return x + x;
  else
    return detail::integer<T>(Int<N>{}) * x;
}
template <int N, class T, detail::if_number<T> = 0>
AXIAL_INLINE constexpr auto operator*(const T& x, Int<N> n) {
  return n * x;
}

template <int N, class T, detail::if_number<T> = 0>
AXIAL_INLINE constexpr auto operator+(Int<N> n, const T& x) {
  if constexpr (N == 0)
    return x;
  else
    return detail::integer<T>(n) + x;
}
template <int N, class T, detail::if_number<T> = 0>
AXIAL_INLINE constexpr auto operator+(const T& x, Int<N> n) {
  if constexpr (N == 0)
    return x;
  else
    return x + detail::integer<T>(n);
}
template <int N, class T, detail::if_number<T> = 0>
AXIAL_INLINE constexpr auto operator-(const T& x, Int<N> n) {
  if constexpr (N == 0)
    return x;
  else
    return x - detail::integer<T>(n);
}
template <int N, class T, detail::if_number<T> = 0>
AXIAL_INLINE constexpr auto operator-(Int<N> n, const T& x) {
  if constexpr (N == 0)
    return -x;
  else
    return detail::integer<T>(n) - x;
}
///@}

namespace detail {
constexpr std::uint64_t bits_of(double value) { return __builtin_bit_cast(std::uint64_t, value); }
/// The literal of a value by its bits: one function for all places that have the same value.
template <class T, std::uint64_t bits>
AXIAL_INLINE constexpr auto literal_of_bits() {
  constexpr double value = __builtin_bit_cast(double, bits);
  if constexpr (value == 0.0 || value == 1.0 || value == -1.0)
    return Int<static_cast<int>(value)>{};
  else
    return Constants<T>::template constant<bits>();
}
}  // namespace detail

/// A compile-time value as a number T: a type where it is 0, 1 or -1, else a constant of T.
/// `literal<float>([] { return Robot::chain.links[0].a; })`.
template <class T, class Get>
AXIAL_INLINE constexpr auto literal(Get get) {
  return detail::literal_of_bits<T, detail::bits_of(get())>();
}

}  // namespace axial

#include <axial/options/end.hpp>
