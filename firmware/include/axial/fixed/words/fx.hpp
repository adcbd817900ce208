// Fixed point: integers with a binary exponent in their type. Products and sums stay exact, and lazy, until something
// names the format that they are rounded to.
#pragma once

#include <axial/fixed/words/arithmetic.hpp>
#include <axial/scalar/rounding.hpp>
#include <axial/scalar/select.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A number raw * 2^-E in arithmetic S. Nothing mixes exponents or widens by itself.
template <int E, class S>
struct Fx {
  static constexpr int exponent = E;  ///< of its unit, 2^-E
  using Arithmetic = S;               ///< that computes with it
  typename S::Word raw{};             ///< value 2^E
};

/// A constant of the model, by the bits of its double; it takes the exponent that suits where it is used.
template <std::uint64_t Bits, class S>
struct Literal {
  using Arithmetic = S;                                              ///< that computes with it
  static constexpr double value = __builtin_bit_cast(double, Bits);  ///< as the model states it
};

/// An exact product that nobody has rounded yet; of two variables, or of a literal (the first) and a variable.
template <class A, class B, bool negative = false>
struct Product {
  using Arithmetic = typename B::Arithmetic;  ///< of its factors
  /// factor
  ///@{
  A a{};
  B b{};
  ///@}
};
/// An exact sum that nobody has rounded yet.
template <class A, class B>
struct Sum {
  using Arithmetic = typename A::Arithmetic;  ///< of its terms
  /// term
  ///@{
  A a{};
  B b{};
  ///@}
};

/// An angle: the whole range of the integer is one turn, so that it wraps exactly.
template <class S>
struct Bam {
  std::int32_t raw{};  ///< angle 2^32 / (2 pi rad), modulo a turn
};
/// Sum of angles, modulo a turn.
template <class S>
AXIAL_INLINE constexpr Bam<S> operator+(Bam<S> a, Bam<S> b) {
  return {static_cast<std::int32_t>(static_cast<std::uint32_t>(a.raw) + static_cast<std::uint32_t>(b.raw))};
}

namespace detail {

template <class X>
inline constexpr bool is_fixed_v = false;
template <int E, class S>
inline constexpr bool is_fixed_v<Fx<E, S>> = true;
template <std::uint64_t Bits, class S>
inline constexpr bool is_fixed_v<Literal<Bits, S>> = true;
template <class A, class B, bool n>
inline constexpr bool is_fixed_v<Product<A, B, n>> = true;
template <class A, class B>
inline constexpr bool is_fixed_v<Sum<A, B>> = true;

template <class X>
inline constexpr bool is_fx_v = false;
template <int E, class S>
inline constexpr bool is_fx_v<Fx<E, S>> = true;

template <class X>
using if_fixed = std::enable_if_t<is_fixed_v<X>, int>;

template <class X>
inline constexpr bool is_literal_v = false;
template <std::uint64_t Bits, class S>
inline constexpr bool is_literal_v<Literal<Bits, S>> = true;

}  // namespace detail

template <class X>
struct NumberTraits<X, std::enable_if_t<detail::is_fixed_v<X>>> {
  static constexpr bool is_number = true;
  /// The constant in the format of X.
  static constexpr X constant(double value) {
    static_assert(!std::is_empty_v<X>, "a literal has no format");
    return {
        static_cast<typename X::Arithmetic::Word>(detail::nearest_integer(value * detail::power_of_two(X::exponent)))};
  }
};

namespace detail {
template <class X>
struct Constants<X, std::enable_if_t<is_fixed_v<X> && !is_fx_v<X>>> {
  template <int N>
  AXIAL_INLINE static constexpr auto integer(Int<N>) {
    return Literal<bits_of(static_cast<double>(N)), typename X::Arithmetic>{};
  }
};
/// Beside a stored number an integer has its format, if it fits.
template <int E, class S>
struct Constants<Fx<E, S>> {
  template <int N>
  AXIAL_INLINE static constexpr auto integer(Int<N>) {
    if constexpr (fitting_exponent(N, S::capacity) >= E)
      return NumberTraits<Fx<E, S>>::constant(N);
    else
      return Literal<bits_of(static_cast<double>(N)), S>{};
  }
};
/// Constants of a model are literals until they meet a format.
template <class Word, bool nearest, bool high, bool checked>
struct Constants<Arithmetic<Word, nearest, high, checked>> {
  template <std::uint64_t bits>
  AXIAL_INLINE static constexpr auto constant() {
    return Literal<bits, Arithmetic<Word, nearest, high, checked>>{};
  }
};
}  // namespace detail

/// The opposite number, of a lazy expression as lazy: no rounding.
///@{
template <int E, class S>
AXIAL_INLINE constexpr Fx<E, S> operator-(Fx<E, S> x) {
  return {detail::narrowed<S>(-typename S::Wide{x.raw})};
}
template <std::uint64_t B, class S>
AXIAL_INLINE constexpr auto operator-(Literal<B, S>) {
  return Literal<detail::bits_of(-Literal<B, S>::value), S>{};
}
template <class A, class B, bool n>
AXIAL_INLINE constexpr auto operator-(const Product<A, B, n>& x) {
  if constexpr (detail::is_literal_v<A>)
    return Product<decltype(-x.a), B>{-x.a, x.b};
  else
    return Product<A, B, !n>{x.a, x.b};
}
template <class A, class B>
AXIAL_INLINE constexpr auto operator-(const Sum<A, B>& x) {
  return Sum<decltype(-x.a), decltype(-x.b)>{-x.a, -x.b};
}
///@}

/// An exact product; of two literals a literal.
///@{
template <int E, int F, class S>
AXIAL_INLINE constexpr auto operator*(Fx<E, S> a, Fx<F, S> b) {
  return Product<Fx<E, S>, Fx<F, S>>{a, b};
}
template <std::uint64_t B, int F, class S>
AXIAL_INLINE constexpr auto operator*(Literal<B, S> a, Fx<F, S> b) {
  return Product<Literal<B, S>, Fx<F, S>>{a, b};
}
template <int E, std::uint64_t B, class S>
AXIAL_INLINE constexpr auto operator*(Fx<E, S> a, Literal<B, S> b) {
  return Product<Literal<B, S>, Fx<E, S>>{b, a};
}
template <std::uint64_t A, std::uint64_t B, class S>
AXIAL_INLINE constexpr auto operator*(Literal<A, S>, Literal<B, S>) {
  return Literal<detail::bits_of(Literal<A, S>::value * Literal<B, S>::value), S>{};
}
///@}

/// An exact sum: of one format at once, of literals by the compiler, of anything else lazy.
///@{
template <int E, class S>
AXIAL_INLINE constexpr Fx<E, S> operator+(Fx<E, S> a, Fx<E, S> b) {
  return {detail::narrowed<S>(typename S::Bits(a.raw) + typename S::Bits(b.raw))};
}
template <int E, class S>
AXIAL_INLINE constexpr Fx<E, S> operator-(Fx<E, S> a, Fx<E, S> b) {
  return {detail::narrowed<S>(typename S::Bits(a.raw) - typename S::Bits(b.raw))};
}
template <std::uint64_t A, std::uint64_t B, class S>
AXIAL_INLINE constexpr auto operator+(Literal<A, S>, Literal<B, S>) {
  return Literal<detail::bits_of(Literal<A, S>::value + Literal<B, S>::value), S>{};
}
template <class A, class B, detail::if_fixed<A> = 0, detail::if_fixed<B> = 0>
AXIAL_INLINE constexpr auto operator+(const A& a, const B& b) {
  return Sum<A, B>{a, b};
}
template <class A, class B, detail::if_fixed<A> = 0, detail::if_fixed<B> = 0>
AXIAL_INLINE constexpr auto operator-(const A& a, const B& b) {
  if constexpr (detail::is_literal_v<A> && detail::is_literal_v<B>)
    return a + (-b);
  else
    return Sum<A, decltype(-b)>{a, -b};
}
///@}

/// The sum of a format's numbers, which may be more than the format holds.
template <int E, class S>
AXIAL_INLINE constexpr auto unrounded_sum(const Fx<E, S>& a, const Fx<E, S>& b) {
  return Sum<Fx<E, S>, Fx<E, S>>{a, b};
}

/// 2 x, exactly: the same bits.
template <int E, class S>
AXIAL_INLINE constexpr Fx<E - 1, S> twice(const Fx<E, S>& x) {
  return {x.raw};
}

/// x / 2, exactly.
template <int E, class S>
AXIAL_INLINE constexpr Fx<E + 1, S> half(const Fx<E, S>& x) {
  return {x.raw};
}

// Comparisons by the sign of a difference: a processor without conditional instructions would branch otherwise.
namespace detail {
AXIAL_INLINE constexpr bool is_less(std::int64_t a, std::int64_t b) {  // where a - b fits
  return (static_cast<std::uint64_t>(a - b) >> 63) != 0;
}

/// x where it fits a word, else the largest or smallest number; sets `lost` there. |x| < 2^(31 + the word's bits).
template <class S>
AXIAL_INLINE constexpr typename S::Word held_in_word(bool& lost, std::int64_t x) {
  const auto sign = static_cast<std::int32_t>(x >> 63), held = static_cast<std::int32_t>(x);
  const std::int32_t spill = S::bits == 32 ? static_cast<std::int32_t>(x >> 32) ^ (held >> 31)
                                           : static_cast<std::int32_t>(x >> (S::bits - 1)) ^ sign;
  const auto some = static_cast<std::uint32_t>(spill) | (0U - static_cast<std::uint32_t>(spill));
  lost = lost | (some >> 31 != 0);
  constexpr auto most = static_cast<std::int32_t>(S::capacity);
  const std::int32_t limit = (most ^ sign) - sign, mask = static_cast<std::int32_t>(some) >> 31;
  return static_cast<typename S::Word>(held ^ ((held ^ limit) & mask));
}
}  // namespace detail
/// Comparison of numbers of one format, without a branch.
///@{
template <int E, class S>
AXIAL_INLINE constexpr bool operator<(Fx<E, S> a, Fx<E, S> b) {
  return detail::is_less(a.raw, b.raw);
}
template <int E, class S>
AXIAL_INLINE constexpr bool operator>(Fx<E, S> a, Fx<E, S> b) {
  return b < a;
}
///@}

/// |x| of a constant, by the compiler.
template <std::uint64_t B, class S>
AXIAL_INLINE constexpr auto magnitude(Literal<B, S>) {
  constexpr double value = Literal<B, S>::value;
  return Literal<detail::bits_of(value < 0.0 ? -value : value), S>{};
}

/// yes or no by a mask.
template <int E, class S>
AXIAL_INLINE constexpr Fx<E, S> select(bool condition, const Fx<E, S>& yes, const Fx<E, S>& no) {
  const typename S::Word mask = static_cast<typename S::Word>(-static_cast<int>(condition));
  return {static_cast<typename S::Word>((yes.raw & mask) | (no.raw & static_cast<typename S::Word>(~mask)))};
}

}  // namespace axial

#include <axial/options/end.hpp>
