// Bodies in bounds. Of one: constants of the model, and what a payload adds to them at most. Composite ones: mass,
// first moment and inertia of all that a link carries. Axes add in parallel whatever the angles of the joints; a turn
// moves an inertia by twice its angle.
#pragma once

#include <axial/fixed/balls/screws.hpp>
#include <axial/spatial/inertia.hpp>

#include <axial/options/begin.hpp>

namespace axial::bounds {

/// A constant vector of known components, and whatever may be added to it: a payload's share, the rounding of words.
struct ConstantVector {
  Number x{}, y{}, z{};  ///< components
  Ball loose{};          ///< norm of what is added, of any direction

  /// Length of the part across the joint's axis.
  constexpr double side() const { return detail::hypotenuse(x.bound.size, y.bound.size); }
  /// Length of the part along it.
  constexpr double height() const { return z.bound.size; }
  /// Everything that no direction is known of: the errors of the components are.
  constexpr Ball unknown() const {
    const double error = detail::hypotenuse(detail::hypotenuse(x.bound.error, y.bound.error), z.bound.error);
    return {loose.size, loose.error + error};
  }
};

/// A constant symmetric matrix. Its difference from the known entries is bounded by its spectral norm.
struct ConstantInertia {
  Sym3<Number> of{};  ///< kg m^2
  Ball loose{};       ///< kg m^2

  /// A bound of the known entries' spectral norm: the largest row sum.
  constexpr double norm() const {
    const auto size = [](const Number& x) { return x.bound.size; };
    return axial::detail::largest_row({size(of.xx), size(of.yy), size(of.zz), size(of.xy), size(of.xz), size(of.yz)});
  }
  /// Sum of the entries' errors, which bounds that of the norm.
  constexpr double error() const {
    return loose.error + of.xx.bound.error + of.yy.bound.error + of.zz.bound.error +
           2.0 * (of.xy.bound.error + of.xz.bound.error + of.yz.bound.error);
  }
};

/// A body as kernels see it.
using Body = RigidInertia<Number, ConstantVector, ConstantInertia>;

/// A structural zero, or a number.
///@{
constexpr Number number_of(Zero) { return literal_of(0.0); }
constexpr const Number& number_of(const Number& x) { return x; }
///@}

/// h x a of a first moment: across, h's part across times a's along and the other way round; along, both parts across.
constexpr VectorSum cross(const ConstantVector& h, const BoundedVector& v) {
  const SplitBall& a = v.bound;
  VectorSum product{detail::split(h.side() * a.along + h.height() * a.across, h.side() * a.across), {}, {}};
  const Ball rest = h.unknown() * a.whole;
  product.bound = product.bound + SplitBall{rest, rest, rest};
  const double across = a.across.largest(), along = a.along.largest();
  add_product(product.across, worse(h.x, h.y), v.exponent, along), add_product(product.across, h.z, v.exponent, across);
  add_product(product.along, h.x, v.exponent, across), add_product(product.along, h.y, v.exponent, across);
  return product;
}

/// A body that is known by norms: kg, kg m about the frame's origin, and the spectral norm in kg m^2.
struct CompositeBody {
  Number mass{};                 ///< a literal, or with a payload a word
  BoundedVector first_moment{};  ///< words
  Number inertia{};              ///< bound of the matrix, words
  Ball axis{};                   ///< of its entry about the joint's axis, kg m^2

  /// Passes keep it as it is.
  template <class>
  constexpr const CompositeBody& dense() const {
    return *this;
  }
};

/// Two bodies of one link: words of one exponent.
constexpr CompositeBody operator+(const CompositeBody& a, const CompositeBody& b) {
  const auto both = [](Number x, const Number& y) {
    if (x.is_literal) x.exponent = y.exponent;
    x.bound = x.bound + y.bound, x.constant += y.constant, x.is_literal = x.is_literal && y.is_literal;
    return x;
  };
  return {both(a.mass, b.mass), a.first_moment + b.first_moment, both(a.inertia, b.inertia), a.axis + b.axis};
}

/// What a joint's unit acceleration takes: a column of the body's 6x6 inertia. The axis' moment is one entry of it.
///@{
constexpr ForceVector<BoundedVector, BoundedVector> unit_force(Revolute, const CompositeBody& body) {
  const BoundedVector& h = body.first_moment;
  const Ball& j = body.inertia.bound;
  return {{axial::detail::tightened({j, body.axis, j}), body.inertia.exponent, false, h.rounding},
          {detail::split(h.bound.across, {}), h.exponent, false, h.rounding}};
}
constexpr ForceVector<BoundedVector, BoundedVector> unit_force(Prismatic, const CompositeBody& body) {
  const BoundedVector& h = body.first_moment;
  return {{detail::split(h.bound.across, {}), h.exponent, false, h.rounding},
          {detail::split({}, body.mass.bound), body.mass.exponent, body.mass.is_literal, h.rounding}};
}
///@}

namespace detail {

// How far s^2 and s c are off, as one length: what sine and cosine are off, and each product's rounding.
constexpr double double_angle_error(const Number& cos, const Number& sin, const WordRounding& r) {
  if (cos.is_literal && sin.is_literal) return 0.0;
  const double e = cos.bound.error > sin.bound.error ? cos.bound.error : sin.bound.error;
  Terms square;
  square.add_product(2 * cos.exponent);
  const double step = square.rounding(cos.exponent, r);
  return hypotenuse(2.0 * e * (1.0 + e) + step, root2 * e * (1.0 + e) + step);
}
// One sum of an entry of the plane: a difference and the couple, each times a product of sine and cosine.
constexpr double plane_rounding(const Number& cos, int exponent, double norm, const WordRounding& r) {
  Terms terms;
  if (cos.is_literal)
    terms.add_scaled(1.0, exponent, 2.0 * norm), terms.add_scaled(1.0, exponent, norm);
  else
    terms.add_product(cos.exponent + exponent), terms.add_product(cos.exponent + exponent);
  return terms.rounding(exponent, r);
}

// R J R^T by the double angle. In the plane the entries (xx - yy) / 2 and xy turn like a vector of at most |J|: they
// are off by twice the double angle's error of it, and by two roundings; the couple with the axis is a vector that
// turns.
constexpr Number turned_inertia(const Number& cos, const Number& sin, Number inertia, const WordRounding& r) {
  if (by_quarters(cos, sin) || inertia.vanishes()) return inertia;
  const double norm = inertia.bound.largest(), plane = root2 * plane_rounding(cos, inertia.exponent, norm, r);
  BoundedVector couple{split({norm, 0.0}, {}), inertia.exponent, false, &r};
  couple = turned(ZAxis{}, cos, sin, couple);
  inertia.bound.error += 2.0 * double_angle_error(cos, sin, r) * norm + plane + couple.bound.whole.error;
  return inertia;
}

// The entry about the joint's axis: no screw of the joint changes it, one about x makes it any other.
constexpr Ball axis_behind(ZAxis, const Ball& axis, const Ball&) { return axis; }
constexpr Ball axis_behind(XAxis, const Ball&, const Ball& inertia) { return inertia; }

// What a mass at the end of a shift adds along the screw's axis.
constexpr VectorSum along_axis(ZAxis, const Ball& moment, const Terms& terms) { return {split({}, moment), {}, terms}; }
constexpr VectorSum along_axis(XAxis, const Ball& moment, const Terms& terms) { return {split(moment, {}), terms, {}}; }

}  // namespace detail

/// A composite body through one screw: turned, rounded into the link's formats, then shifted. By parallel axes m, h and
/// J become m, h + p m and J + p (h + h') with h' the new h; what is off is carried like what is there.
template <class Axis, class Known, class Link>
constexpr CompositeBody to_parent(const detail::Screw<Axis, Known>& x, const CompositeBody& body, const Link& link) {
  using namespace quantity;
  const WordRounding& r = link.rounding();
  const Number about = detail::turned_inertia(x.cos, x.sin, body.inertia, r);
  const CompositeBody turned = link.formatted(CompositeBody{body.mass, to_parent(x, body.first_moment), about,
                                                            detail::axis_behind(Axis{}, body.axis, about.bound)});
  if (x.shift.vanishes()) return turned;
  const NumberSum weight = x.shift * turned.mass;
  const BoundedVector first =
      link.sum(FirstMoment{}, turned.first_moment, detail::along_axis(Axis{}, weight.bound, weight.terms));
  const Ball &h = turned.first_moment.bound.whole, both = h + first.bound.whole;
  link.leave_room(FirstMoment{}, both.size);
  Terms entry;
  entry.add_word(turned.inertia.exponent);
  add_product(entry, x.shift, first.exponent, both.largest());
  Ball inertia = turned.inertia.bound + x.shift.bound * both;
  inertia.error += 2.0 * entry.rounding(turned.inertia.exponent, r);
  link.note(RotationalInertia{}, inertia);
  return {turned.mass, first, word_of(inertia, turned.inertia.exponent),
          detail::axis_behind(Axis{}, turned.axis, inertia)};
}

}  // namespace axial::bounds

#include <axial/options/end.hpp>
