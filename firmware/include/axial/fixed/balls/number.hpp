// A number in bounds: what kernels over links of bounds compute with instead of words.
#pragma once

#include <axial/fixed/balls/terms.hpp>
#include <axial/scalar/rounding.hpp>
#include <axial/scalar/sincos.hpp>

#include <axial/options/begin.hpp>

namespace axial::bounds {

/// A constant of the model or a word: how large it can be, how far from exact, and at which exponent it stands.
struct Number {
  Ball bound{};            ///< of the value, and of the word's distance from it
  double constant = 0.0;   ///< the value of a literal
  int exponent = 0;        ///< of a word
  bool is_literal = true;  ///< whether it is a constant that no word holds yet

  /// True where no state makes it anything but zero.
  constexpr bool vanishes() const { return !(bound.largest() > 0.0); }
};

/// A constant of the model.
constexpr Number literal_of(double value) { return {{magnitude(value), 0.0}, value, 0, true}; }
/// A word at an exponent.
constexpr Number word_of(const Ball& bound, int exponent) { return {bound, 0.0, exponent, false}; }

/// A sum that nobody has rounded yet.
struct NumberSum {
  Ball bound{};             ///< of the exact sum of its terms
  Terms terms{};            ///< of which rounding depends
  double constant = 0.0;    ///< the value of a literal
  bool is_literal = false;  ///< whether the compiler knows it
};

/// Adds `factor` times a word at `exponent` that reaches `size` to the terms of a component.
constexpr void add_product(Terms& terms, const Number& factor, int exponent, double size) {
  if (factor.vanishes() || !(size > 0.0)) return;
  if (!factor.is_literal)
    terms.add_product(factor.exponent + exponent);
  else if (magnitude(factor.constant) < 1.0 || magnitude(factor.constant) > 1.0)
    terms.add_scaled(factor.constant, exponent, size);
  else
    terms.add_word(exponent);
}

/// The larger of two constants, whose product rounds more.
constexpr const Number& worse(const Number& a, const Number& b) { return a.bound.size > b.bound.size ? a : b; }

/// A number as a term of a sum.
constexpr NumberSum term_of(const Number& x) {
  NumberSum sum{x.bound, {}, x.constant, x.is_literal};
  if (!x.vanishes()) x.is_literal ? sum.terms.add_literal() : sum.terms.add_word(x.exponent);
  return sum;
}
/// A sum is one already.
constexpr const NumberSum& term_of(const NumberSum& x) { return x; }
/// Zero adds nothing.
constexpr NumberSum term_of(Zero) { return {{}, {}, 0.0, true}; }

namespace detail {
template <class X>
inline constexpr bool is_bounded = std::is_same_v<X, Number> || std::is_same_v<X, NumberSum>;
}  // namespace detail

/// Opposite numbers have the same bounds.
template <class X, std::enable_if_t<detail::is_bounded<X>, int> = 0>
constexpr X operator-(X x) {
  x.constant = -x.constant;
  return x;
}

/// An exact product; of two literals a literal.
constexpr NumberSum operator*(const Number& a, const Number& b) {
  if (a.is_literal && b.is_literal) return term_of(literal_of(a.constant * b.constant));
  NumberSum product{a.bound * b.bound, {}, 0.0, false};
  const Number &factor = a.is_literal ? a : b, &word = a.is_literal ? b : a;
  add_product(product.terms, factor, word.exponent, word.bound.largest());
  return product;
}
namespace detail {
// Where a sum is rounded each literal is, even beside another.
constexpr void accumulate(NumberSum& sum, const NumberSum& x) {
  sum.bound = sum.bound + x.bound, sum.is_literal = false;
  sum.terms.add(x.terms);
}
constexpr NumberSum sum_of(const NumberSum& a, const NumberSum& b) {
  if (a.is_literal && b.is_literal) return term_of(literal_of(a.constant + b.constant));
  NumberSum sum = a;
  accumulate(sum, b);
  return sum;
}
}  // namespace detail
/// An exact sum, and a difference, whose bounds are those of a sum; of two literals a literal.
///@{
template <class X, class Y, std::enable_if_t<detail::is_bounded<X> && detail::is_bounded<Y>, int> = 0>
constexpr NumberSum operator+(const X& a, const Y& b) {
  return detail::sum_of(term_of(a), term_of(b));
}
template <class X, class Y, std::enable_if_t<detail::is_bounded<X> && detail::is_bounded<Y>, int> = 0>
constexpr NumberSum operator-(const X& a, const Y& b) {
  return detail::sum_of(term_of(a), term_of(-b));
}
///@}

/// 2 x by its exponent.
constexpr Number twice(Number x) {
  x.bound = 2.0 * x.bound, x.constant = 2.0 * x.constant, --x.exponent;
  return x;
}
/// x / 2 by its exponent.
constexpr Number half(Number x) {
  x.bound = 0.5 * x.bound, x.constant = 0.5 * x.constant, ++x.exponent;
  return x;
}

/// A joint's angle, exact in binary angles; its sine and cosine are not.
struct Angle {
  const WordRounding* rounding = nullptr;  ///< of the arithmetic
  double error = 0.0;                      ///< of a constant that was added to it, rad
};
/// A joint's position: an angle, or a length.
struct Position {
  Number length{};  ///< of a slide
  Angle angle{};    ///< of a revolute joint
};
/// A position as the kind of the joint reads it.
///@{
constexpr const Angle& joint_angle(const Position& q) { return q.angle; }
constexpr const Number& joint_length(const Position& q) { return q.length; }
///@}
/// Sine and cosine of a joint: words at the exponent of a turn.
constexpr SinCos<Number> sincos(const Angle& angle) {
  const Number entry = word_of({1.0, angle.rounding->turn_error + angle.error}, angle.rounding->bits - 2);
  return {entry, entry};
}

}  // namespace axial::bounds

namespace axial {
/// Structural scalars meet numbers and sums in bounds as they meet any other number.
template <class X>
struct NumberTraits<X, std::enable_if_t<bounds::detail::is_bounded<X>>> {
  static constexpr bool is_number = true;  ///< kernels compute with it
  /// A constant of the model.
  static constexpr X constant(double value) {
    if constexpr (std::is_same_v<X, bounds::Number>)
      return bounds::literal_of(value);
    else
      return bounds::term_of(bounds::literal_of(value));
  }
};
}  // namespace axial

#include <axial/options/end.hpp>
