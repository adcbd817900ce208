// Rounding of lazy sums into a format: the only way in which fixed point narrows.
#pragma once

#include <axial/fixed/words/terms.hpp>
#include <axial/scalar/sincos.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {
inline constexpr double bam_per_radian = 683565275.5764316;  // 2^32 / (2 pi)

// A double word at exponent A as a word at E.
template <int E, int A, class S>
AXIAL_INLINE constexpr typename S::Word rounded_word(typename S::Bits x) {
  if constexpr (A <= E) {
    return narrowed<S>(shifted<E - A, S>(x));
  } else {
    constexpr auto half = S::nearest ? typename S::Bits{1} << (A - E - 1) : typename S::Bits{0};
    return narrowed<S>(shifted<E - A, S>(x + half));
  }
}
}  // namespace detail

/// A double word in one word at exponent E: to nearest (halves up) or down, as the arithmetic says.
template <int E, int A, class S>
AXIAL_INLINE constexpr Fx<E, S> round_to(const Acc<A, S>& x) {
  return {detail::rounded_word<E, A, S>(x.raw)};
}
/// Any expression, rounded once into exponent E. The caller has shown that the result fits.
template <int E, class X, detail::if_fixed<X> = 0>
AXIAL_INLINE constexpr auto round_to(const X& x) {
  using S = typename X::Arithmetic;
  if constexpr (!detail::Terms<X>::has_product)
    return Fx<E, S>{detail::narrowed<S>(detail::gathered<E>(x))};
  else if constexpr (S::high_word)
    return detail::rounded_from_upper<E>(x);
  else
    return Fx<E, S>{
        detail::rounded_word<E, accumulator_exponent<X, E>, S>(detail::widened<accumulator_exponent<X, E>>(x))};
}

namespace detail {

// The sum of terms; terms of one format are not added at once, for their sum may fit only the format of the result.
template <class X>
AXIAL_INLINE constexpr const X& lazy_sum(const X& x) {
  return x;
}
template <class X, class Y, class... Rest>
AXIAL_INLINE constexpr auto lazy_sum(const X& x, const Y& y, const Rest&... rest) {
  if constexpr (is_fixed_v<X> && is_fixed_v<Y>)
    return lazy_sum(Sum<X, Y>{x, y}, rest...);
  else
    return lazy_sum(x + y, rest...);
}

/// Whether a sum of terms is of fixed point, zeros by type aside.
template <class... X>
inline constexpr bool are_fixed_terms = ((is_fixed_v<X> || is_zero_v<X>)&&...) && (is_fixed_v<X> || ...);

/// The sum of terms, rounded once into exponent E: what round_to() makes of a lazy sum of them. In one step where they
/// have no products, or products by whole double words; a zero by type stays one.
template <int E, class S, class... X>
AXIAL_INLINE constexpr auto rounded_sum(const X&... x) {
  if constexpr (!are_fixed_terms<X...> || S::high_word) {
    using Exact = std::decay_t<decltype(lazy_sum(x...))>;
    if constexpr (is_zero_v<Exact>)
      return Zero{};
    else if constexpr (is_structural_v<Exact>)
      return NumberTraits<Fx<E, S>>::constant(static_cast<double>(Exact::value));
    else
      return round_to<E>(lazy_sum(x...));
  } else if constexpr (!(Terms<X>::has_product || ...)) {
    return Fx<E, S>{narrowed<S>(static_cast<typename S::Upper>((... + gathered<E>(x))))};
  } else {
    constexpr int common = [] {
      int least = E + S::bits;
      return ((least = smaller(least, Terms<X>::common(E + S::bits))), ...);
    }();
    return Fx<E, S>{rounded_word<E, common, S>(static_cast<typename S::Bits>((... + widened<common>(x))))};
  }
}

}  // namespace detail

/// A number of format E: any expression is rounded into it once.
template <int E, class S>
struct Holding<Fx<E, S>> {
  /// X in that format; structural scalars become constants.
  template <class X>
  AXIAL_INLINE static constexpr Fx<E, S> of(const X& x) {
    if constexpr (is_structural_v<X>)
      return x;
    else
      return round_to<E>(x);
  }
};

/// Any expression, rounded once, held in exponent E's range; sets `lost` where it did not fit. Sees excesses up to 2^8.
template <int E, class X>
AXIAL_INLINE constexpr auto saturated(bool& lost, const X& x) {
  using S = typename X::Arithmetic;
  constexpr int headroom = 8, finest = E + S::bits - headroom;
  constexpr int common = detail::Terms<X>::common(finest);
  const auto sum = accumulate<common>(x);
  constexpr auto half = S::nearest && common > E ? typename S::Bits{1} << (common - E - 1) : typename S::Bits{0};
  const auto wide = static_cast<typename S::Wide>(detail::shifted<E - common, S>(sum.raw + half));
  return Fx<E, S>{detail::held_in_word<S>(lost, static_cast<std::int64_t>(wide))};
}

namespace detail {

// The format of what was turned, behind a product with a sine or cosine; a constant has none of its own.
template <class X>
struct TurnedFormat;
template <std::uint64_t B, class S>
struct TurnedFormat<Literal<B, S>> {
  static constexpr int exponent = any_exponent;
};
template <int E, class S>
struct TurnedFormat<Fx<E, S>> {
  static constexpr int exponent = E;
};
template <std::uint64_t B, int F, class S, bool n>
struct TurnedFormat<Product<Literal<B, S>, Fx<F, S>, n>> {
  static constexpr int exponent = F;
};
template <int F, int G, class S, bool n>
struct TurnedFormat<Product<Fx<F, S>, Fx<G, S>, n>> {
  static constexpr int exponent = F + G - S::unit;
};
template <class A, class B>
struct TurnedFormat<Sum<A, B>> {
  static constexpr int a = TurnedFormat<A>::exponent, b = TurnedFormat<B>::exponent, exponent = smaller(a, b);
  static_assert(a == b || a == any_exponent || b == any_exponent, "what is turned has one format");
};

}  // namespace detail

/// The product, back at the exponent of the factor that is no sine or cosine.
template <class A, class B, bool n>
AXIAL_INLINE constexpr auto turned(const Product<A, B, n>& x) {
  return round_to<detail::TurnedFormat<Product<A, B, n>>::exponent>(x);
}
/// The sum of such products, rounded once.
template <class A, class B>
AXIAL_INLINE constexpr auto turned(const Sum<A, B>& x) {
  return round_to<detail::TurnedFormat<Sum<A, B>>::exponent>(x);
}

/// An angle and a constant one, `get()` in radians: exact but for the constant's rounding to 2^-33 of a turn.
template <class S, class Get>
AXIAL_INLINE constexpr Bam<S> turned_by(const Bam<S>& angle, Get get) {
  constexpr auto offset = static_cast<std::uint32_t>(detail::nearest_integer(get() * detail::bam_per_radian));
  return angle + Bam<S>{static_cast<std::int32_t>(offset)};
}

/// Sine and cosine of an angle, within integer::sincos_error and the rounding to the word.
template <class S>
AXIAL_INLINE constexpr SinCos<Fx<S::unit, S>> sincos(const Bam<S>& angle) {
  using Word = typename S::Word;
  const auto pair = integer::sincos(static_cast<std::uint32_t>(angle.raw));
  if constexpr (S::bits == 32)
    return {{pair.sin}, {pair.cos}};
  else
    return {{static_cast<Word>((pair.sin + 0x8000) >> 16)}, {static_cast<Word>((pair.cos + 0x8000) >> 16)}};
}

}  // namespace axial

#include <axial/options/end.hpp>
