// The terms of a lazy sum at one exponent: exact, in a double word or in upper words.
#pragma once

#include <axial/fixed/words/fx.hpp>
#include <axial/fixed/words/integer.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A double word raw * 2^-E: a sum of products on its way to one rounding. It may wrap; what it is rounded to fits.
template <int E, class S>
struct Acc {
  typename S::Bits raw{};  ///< value 2^E, modulo the double word
};

namespace detail {

inline constexpr int any_exponent = 1000;

/// The signed integer as wide as an unsigned one. A word that is no native integer brings its own.
template <class Bits>
struct SignedOf {
  using type = std::make_signed_t<Bits>;
};

// Exponent of a literal that multiplies a number at exponent F so that the product is at `wanted`, or what fits.
template <class L, class S>
constexpr int literal_exponent(int wanted, int f) {
  return smaller(wanted - f, fitting_exponent(L::value, S::capacity));
}

// The finest exponent at which all terms of a sum can be added, up to `wanted`: products of variables have theirs.
template <class X>
struct Terms;
struct WithoutProduct {
  static constexpr bool has_product = false;
  static constexpr int variable = any_exponent;
  static constexpr int common(int wanted) { return wanted; }
};
template <int E, class S>
struct Terms<Fx<E, S>> : WithoutProduct {};
template <std::uint64_t B, class S>
struct Terms<Literal<B, S>> : WithoutProduct {};
template <>
struct Terms<Zero> : WithoutProduct {};
template <std::uint64_t B, int F, class S, bool n>
struct Terms<Product<Literal<B, S>, Fx<F, S>, n>> {
  static constexpr bool has_product = true;
  static constexpr int variable = any_exponent;
  static constexpr int common(int wanted) { return F + literal_exponent<Literal<B, S>, S>(wanted, F); }
};
template <int E, int F, class S, bool n>
struct Terms<Product<Fx<E, S>, Fx<F, S>, n>> {
  static constexpr bool has_product = true;
  static constexpr int variable = E + F;
  static constexpr int common(int wanted) { return smaller(wanted, E + F); }
};
template <class A, class B>
struct Terms<Sum<A, B>> {
  static constexpr bool has_product = Terms<A>::has_product || Terms<B>::has_product;
  static constexpr int variable = smaller(Terms<A>::variable, Terms<B>::variable);
  static constexpr int common(int wanted) { return smaller(Terms<A>::common(wanted), Terms<B>::common(wanted)); }
};

// x * 2^Shift of a double word, down where bits are lost.
template <int Shift, class S>
AXIAL_INLINE constexpr typename S::Bits shifted(typename S::Bits x) {
  constexpr int width = 8 * static_cast<int>(sizeof(typename S::Bits));
  if constexpr (Shift >= width)
    return 0;
  else if constexpr (Shift >= 0)
    return x << Shift;
  else if constexpr (-Shift >= width)
    return static_cast<typename S::Bits>(static_cast<typename S::Wide>(x) >> (width - 1));
  else
    return static_cast<typename S::Bits>(static_cast<typename S::Wide>(x) >> -Shift);
}

template <class S>
AXIAL_INLINE constexpr typename S::Bits product(typename S::Word a, typename S::Word b) {
  using integer::multiply;  // a word that is no native integer brings its own
  constexpr bool by_processor = AXIAL_LONG_MULTIPLY && std::is_integral_v<typename S::Word>;
  if constexpr (S::bits == 32 && !by_processor)
    return static_cast<typename S::Bits>(typename S::Wide{multiply(a, b)});
  else
    return static_cast<typename S::Bits>(typename S::Wide{a} * typename S::Wide{b});
}

template <class L, int C, class S>
inline constexpr
    typename S::Word literal_word = static_cast<typename S::Word>(nearest_integer(L::value* power_of_two(C)));

// A term as a double word at exponent A.
template <int A, int E, class S>
AXIAL_INLINE constexpr typename S::Bits widened(const Fx<E, S>& x) {
  return shifted<A - E, S>(static_cast<typename S::Bits>(typename S::Wide{x.raw}));
}
template <int A, std::uint64_t B, class S>
AXIAL_INLINE constexpr typename S::Bits widened(const Literal<B, S>&) {
  constexpr auto bits = static_cast<typename S::Bits>(nearest_integer(Literal<B, S>::value * power_of_two(A)));
  return bits;
}
template <int A, std::uint64_t B, int F, class S, bool n>
AXIAL_INLINE constexpr typename S::Bits widened(const Product<Literal<B, S>, Fx<F, S>, n>& x) {
  constexpr int c = literal_exponent<Literal<B, S>, S>(A, F);
  if constexpr (A == F + c)
    return product<S>(literal_word<Literal<B, S>, c, S>, x.b.raw);
  else
    return shifted<A - F - c, S>(product<S>(literal_word<Literal<B, S>, c, S>, x.b.raw));
}
template <int A, int E, int F, class S, bool negative>
AXIAL_INLINE constexpr typename S::Bits widened(const Product<Fx<E, S>, Fx<F, S>, negative>& x) {
  if constexpr (A != E + F && negative)
    return 0 - shifted<A - E - F, S>(product<S>(x.a.raw, x.b.raw));
  else if constexpr (A != E + F)
    return shifted<A - E - F, S>(product<S>(x.a.raw, x.b.raw));
  else if constexpr (negative)
    return 0 - product<S>(x.a.raw, x.b.raw);
  else
    return product<S>(x.a.raw, x.b.raw);
}
template <int A, class X, class Y>
AXIAL_INLINE constexpr auto widened(const Sum<X, Y>& x) {
  return widened<A>(x.a) + widened<A>(x.b);
}

// A word at another exponent; to nearest without a wider type. Sums of such words wrap.
template <int Shift, class S>
AXIAL_INLINE constexpr typename S::Upper moved(typename S::Upper bits) {
  using Upper = typename S::Upper;
  using Signed = typename SignedOf<Upper>::type;
  constexpr int width = 8 * static_cast<int>(sizeof(Upper));
  const auto x = static_cast<Signed>(bits);
  if constexpr (Shift >= width)
    return 0;
  else if constexpr (Shift >= 0)
    return static_cast<Upper>(bits << Shift);
  else if constexpr (S::nearest && -Shift >= S::bits)
    return 0;
  else if constexpr (S::nearest)
    return static_cast<Upper>(static_cast<Signed>(static_cast<Upper>(x >> (-Shift - 1)) + Upper{1}) >> 1);
  else
    return static_cast<Upper>(x >> smaller(-Shift, S::bits - 1));
}
template <int Shift, class S>
AXIAL_INLINE constexpr typename S::Upper moved_word(typename S::Word x) {
  return moved<Shift, S>(static_cast<typename S::Upper>(x));
}

// The upper words of products at exponent E. Those of two variables are summed apart at their exponent, moved once.
template <class S>
AXIAL_INLINE constexpr typename S::Upper upper(typename S::Word a, typename S::Word b) {
  using integer::multiply_high;
  if constexpr (S::bits == 32)
    return static_cast<typename S::Upper>(multiply_high(a, b));
  else
    return static_cast<typename S::Upper>((typename S::Wide{a} * typename S::Wide{b}) >> S::bits);
}

template <int E, int F, class S>
AXIAL_INLINE constexpr typename S::Upper upper_constant(const Fx<F, S>& x) {
  return moved_word<E - F, S>(x.raw);
}
template <int E, std::uint64_t B, class S>
AXIAL_INLINE constexpr typename S::Upper upper_constant(const Literal<B, S>&) {
  return static_cast<typename S::Upper>(literal_word<Literal<B, S>, E, S>);
}
template <int E, std::uint64_t B, int F, class S, bool n>
AXIAL_INLINE constexpr typename S::Upper upper_constant(const Product<Literal<B, S>, Fx<F, S>, n>& x) {
  constexpr int c = literal_exponent<Literal<B, S>, S>(E + S::bits, F);
  return moved<E + S::bits - F - c, S>(upper<S>(literal_word<Literal<B, S>, c, S>, x.b.raw));
}
template <int E, int F, int G, class S, bool n>
AXIAL_INLINE constexpr typename S::Upper upper_constant(const Product<Fx<F, S>, Fx<G, S>, n>&) {
  return 0;
}
template <int E, class X, class Y>
AXIAL_INLINE constexpr auto upper_constant(const Sum<X, Y>& x) {
  return static_cast<typename X::Arithmetic::Upper>(upper_constant<E>(x.a) + upper_constant<E>(x.b));
}

template <int H, class X>
AXIAL_INLINE constexpr typename X::Arithmetic::Upper upper_variable(const X&) {
  return 0;
}
template <int H, int F, int G, class S, bool negative>
AXIAL_INLINE constexpr typename S::Upper upper_variable(const Product<Fx<F, S>, Fx<G, S>, negative>& x) {
  const auto word = moved<H + S::bits - F - G, S>(upper<S>(x.a.raw, x.b.raw));
  if constexpr (negative)
    return static_cast<typename S::Upper>(0 - word);
  else
    return word;
}
template <int H, class X, class Y>
AXIAL_INLINE constexpr typename X::Arithmetic::Upper upper_variable(const Sum<X, Y>& x) {
  return static_cast<typename X::Arithmetic::Upper>(upper_variable<H>(x.a) + upper_variable<H>(x.b));
}

template <int E, class X>
AXIAL_INLINE constexpr auto rounded_from_upper(const X& x) {
  using S = typename X::Arithmetic;
  constexpr int variable = Terms<X>::variable;
  const auto constant = upper_constant<E>(x);
  if constexpr (variable == any_exponent) {
    return Fx<E, S>{narrowed<S>(constant)};
  } else {
    constexpr int h = smaller(variable - S::bits, E);
    return Fx<E, S>{narrowed<S>(static_cast<typename S::Upper>(constant + moved<E - h, S>(upper_variable<h>(x))))};
  }
}

// A sum without products needs no double word.
template <int E, int F, class S>
AXIAL_INLINE constexpr typename S::Upper gathered(const Fx<F, S>& x) {
  return moved_word<E - F, S>(x.raw);
}
template <int E, std::uint64_t B, class S>
AXIAL_INLINE constexpr typename S::Upper gathered(const Literal<B, S>&) {
  return static_cast<typename S::Upper>(literal_word<Literal<B, S>, E, S>);
}
template <int E, class X, class Y>
AXIAL_INLINE constexpr auto gathered(const Sum<X, Y>& x) {
  return static_cast<typename X::Arithmetic::Upper>(gathered<E>(x.a) + gathered<E>(x.b));
}

// A zero by type adds nothing, in any arithmetic.
template <int A>
AXIAL_INLINE constexpr unsigned char widened(Zero) {
  return 0;
}
template <int E>
AXIAL_INLINE constexpr unsigned char gathered(Zero) {
  return 0;
}

}  // namespace detail

/// The exponent at which a sum of products meets its one rounding into exponent E: up to a word finer.
template <class X, int E>
inline constexpr int accumulator_exponent = detail::Terms<X>::common(E + X::Arithmetic::bits);

/// The sum of a lazy expression, exact but for terms finer than A.
template <int A, class X>
AXIAL_INLINE constexpr auto accumulate(const X& x) {
  return Acc<A, typename X::Arithmetic>{detail::widened<A>(x)};
}

}  // namespace axial

#include <axial/options/end.hpp>
