// A vector in bounds: its part across the joint's axis, its part along it, and the whole, each with its error. A turn
// about the axis keeps all three, where a box of components would grow at every joint.
#pragma once

#include <axial/fixed/balls/ball.hpp>
#include <axial/fixed/balls/number.hpp>
#include <axial/spatial/congruence.hpp>

#include <axial/options/begin.hpp>

namespace axial::bounds {

/// A vector of words at one exponent, or of literals.
struct BoundedVector {
  SplitBall bound{};        ///< of the vector, and of the words' distance from it
  int exponent = 0;         ///< of the words
  bool is_literal = false;  ///< whether it is constants of the model
  /// How its turns are rounded: they name no link, for their exponent is that of what they turn. Null for zero.
  const WordRounding* rounding = nullptr;

  /// Passes keep it as it is.
  template <class>
  constexpr const BoundedVector& dense() const {
    return *this;
  }
};

/// A sum of vectors that nobody has rounded yet.
struct VectorSum {
  SplitBall bound{};        ///< of the exact sum of its terms
  Terms across{}, along{};  ///< of a component across the joint's axis, the worse of two, and of that along it
};

namespace detail {

using axial::detail::hypotenuse;
using axial::detail::root2;
using axial::detail::root3;
using axial::detail::split;
using axial::detail::tightened;

/// The size of one bound with the errors of another.
constexpr SplitBall with_errors_of(SplitBall v, const SplitBall& other) {
  v.across.error = other.across.error, v.along.error = other.along.error;
  v.whole.error = hypotenuse(other.across.error, other.along.error);
  return v;
}

/// What a rounding of the part across and of the part along adds to the error of a vector.
constexpr SplitBall with_rounding(SplitBall v, double across, double along) {
  v.across.error += across, v.along.error += along, v.whole.error += hypotenuse(across, along);
  return tightened(v);
}

}  // namespace detail

/// A vector as a term of a sum.
///@{
constexpr VectorSum vector_of(const BoundedVector& v) {
  VectorSum sum{v.bound, {}, {}};
  const auto add = [&v](Terms& terms) { v.is_literal ? terms.add_literal() : terms.add_word(v.exponent); };
  if (v.bound.across.largest() > 0.0) add(sum.across);
  if (v.bound.along.largest() > 0.0) add(sum.along);
  return sum;
}
constexpr const VectorSum& vector_of(const VectorSum& v) { return v; }
template <class Z>
constexpr VectorSum vector_of(const Vec3<Zero, Zero, Z>& v) {
  const auto z = term_of(v.z);
  return {detail::split({}, z.bound), {}, z.terms};
}
///@}

namespace detail {
template <class V>
inline constexpr bool is_bounded_vector = std::is_same_v<V, BoundedVector> || std::is_same_v<V, VectorSum>;
template <class V>
inline constexpr bool is_vector = is_bounded_vector<V>;
template <class X, class Y, class Z>
inline constexpr bool is_vector<Vec3<X, Y, Z>> = true;

// At least one of two vectors is in bounds.
template <class U, class V>
using if_vectors =
    std::enable_if_t<is_vector<U> && is_vector<V> && (is_bounded_vector<U> || is_bounded_vector<V>), int>;

// Bounds are tightened where a sum is rounded.
constexpr void accumulate(VectorSum& sum, const VectorSum& v) {
  SplitBall& to = sum.bound;
  to.across = to.across + v.bound.across, to.along = to.along + v.bound.along, to.whole = to.whole + v.bound.whole;
  sum.across.add(v.across), sum.along.add(v.along);
}
}  // namespace detail

/// A part of a vector: one of two components, or the third.
enum class Part { across, along };

namespace detail {

// Adds `count` products of components, each of one part. A constant vector is the literal factor of each, as large as
// its part; what it multiplies rounds no less where it is 1.
constexpr void add_product(Terms& terms, int count, Part of_u, const BoundedVector& u, Part of_v,
                           const BoundedVector& v) {
  const auto reach = [](Part part, const BoundedVector& of) {
    return (part == Part::across ? of.bound.across : of.bound.along).largest();
  };
  const double a = reach(of_u, u), b = reach(of_v, v);
  for (int i = 0; i < count && a > 0.0 && b > 0.0; ++i)
    if (u.is_literal && v.is_literal)
      terms.add_literal();
    else if (u.is_literal)
      terms.add_scaled(a, v.exponent, b);
    else if (v.is_literal)
      terms.add_scaled(b, u.exponent, a);
    else
      terms.add_product(u.exponent + v.exponent);
}
/// v + v, words of one exponent.
constexpr BoundedVector doubled(BoundedVector v) {
  v.bound = 2.0 * v.bound;
  return v;
}
/// The joint's axis: a direction that the compiler knows.
constexpr BoundedVector unit_along(const WordRounding& r) { return {split({}, {1.0, 0.0}), r.bits - 2, true, &r}; }

}  // namespace detail

/// Words of one exponent are added at once, exactly; anything else waits for its rounding.
constexpr BoundedVector operator+(const BoundedVector& u, const BoundedVector& v) {
  return {u.bound + v.bound, u.exponent, u.is_literal && v.is_literal, u.rounding};
}
/// Nothing is added.
constexpr const BoundedVector& operator+(const BoundedVector& u, const ZeroVec3&) { return u; }
/// A lazy sum.
template <class U, class V, detail::if_vectors<U, V> = 0>
constexpr VectorSum operator+(const U& u, const V& v) {
  VectorSum sum = vector_of(u);
  detail::accumulate(sum, vector_of(v));
  return sum;
}
/// Opposite vectors have the same bounds.
///@{
constexpr const BoundedVector& operator-(const BoundedVector& v) { return v; }
constexpr const VectorSum& operator-(const VectorSum& v) { return v; }
///@}

/// A constant or a word times a vector: components are products.
constexpr VectorSum operator*(const Number& factor, const BoundedVector& v) {
  const Ball& f = factor.bound;
  VectorSum product{{f * v.bound.across, f * v.bound.along, f * v.bound.whole}, {}, {}};
  add_product(product.across, factor, v.exponent, v.bound.across.largest());
  add_product(product.along, factor, v.exponent, v.bound.along.largest());
  return product;
}
/// v x z s: what is across, turned by a quarter.
constexpr VectorSum cross_z(const BoundedVector& v, const Number& s) {
  VectorSum product{detail::split(s.bound * v.bound.across, {}), {}, {}};
  add_product(product.across, s, v.exponent, v.bound.across.largest());
  return product;
}
/// Nothing moves where the joint does not.
constexpr ZeroVec3 cross_z(const BoundedVector&, Zero) { return {}; }
/// u . v: the parts across and the parts along, or the wholes.
constexpr NumberSum dot(const BoundedVector& u, const BoundedVector& v) {
  const SplitBall &a = u.bound, &b = v.bound;
  NumberSum product{axial::detail::least(a.across * b.across + a.along * b.along, a.whole * b.whole), {}, 0.0, false};
  detail::add_product(product.terms, 2, Part::across, u, Part::across, v);
  detail::add_product(product.terms, 1, Part::along, u, Part::along, v);
  return product;
}
/// Nothing is along no vector.
constexpr Zero dot(const BoundedVector&, const ZeroVec3&) { return {}; }
/// Component of v x u along the joint's axis: two products of parts across it.
constexpr NumberSum axial_product(const BoundedVector& u, const BoundedVector& v) {
  NumberSum product{u.bound.across * v.bound.across, {}, 0.0, false};
  if (product.bound.size + product.bound.error > 0.0)
    product.terms.add_product(u.exponent + v.exponent), product.terms.add_product(u.exponent + v.exponent);
  return product;
}
/// Words of two vectors, multiplied crosswise: across the axis each part across times the other's along it, along the
/// axis the parts across; no more than the wholes. Two products a component.
constexpr VectorSum cross(const BoundedVector& u, const BoundedVector& v) {
  const SplitBall &a = u.bound, &b = v.bound;
  VectorSum product{
      axial::detail::tightened({a.across * b.along + a.along * b.across, a.across * b.across, a.whole * b.whole}),
      {},
      {}};
  detail::add_product(product.across, 1, Part::across, u, Part::along, v);
  detail::add_product(product.across, 1, Part::along, u, Part::across, v);
  detail::add_product(product.along, 2, Part::across, u, Part::across, v);
  return product;
}
/// Component along the joint's axis.
constexpr Number axial_part(const BoundedVector& v) {
  return {v.bound.along, v.bound.along.size, v.exponent, v.is_literal};
}

}  // namespace axial::bounds

#include <axial/options/end.hpp>
