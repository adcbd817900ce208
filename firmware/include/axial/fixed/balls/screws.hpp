// Screws on bounds: a turn keeps what is across its axis, what is along it and the whole; only the error of the sine
// and cosine, and the rounding of the products, add to the error.
#pragma once

#include <axial/fixed/balls/vector.hpp>
#include <axial/links/link_constants.hpp>
#include <axial/spatial/spatial_vector.hpp>
#include <utility>

#include <axial/options/begin.hpp>

namespace axial::bounds {

namespace detail {

template <class Axis, class Turn>
using Screw = AxialScrew<Axis, Number, Number, Number, Turn>;

// A turn by quarters exchanges components; nothing is rounded. Words of a table are multiplied whatever they hold.
constexpr bool by_quarters(const Number& cos, const Number& sin) {
  return cos.is_literal && sin.is_literal && (cos.vanishes() || sin.vanishes());
}
// A constant turn of a constant vector is a constant.
constexpr bool is_constant(const Number& cos, const Number& sin, const BoundedVector& v) {
  return cos.is_literal && sin.is_literal && v.is_literal;
}
// Norm of the difference of [c -s; s c] whose two entries are off by at most e each.
constexpr double tilt(const Number& cos, const Number& sin) { return hypotenuse(cos.bound.error, sin.bound.error); }
// One component of c x +- s y: both reach at most `size`. A literal vector is the constant of each product.
constexpr double turn_rounding(const Number& cos, const Number& sin, const BoundedVector& v, double size) {
  Terms terms;
  for (const Number* factor : {&cos, &sin})
    if (v.is_literal && !factor->is_literal)
      terms.add_scaled(size, factor->exponent, factor->bound.largest());
    else
      add_product(terms, *factor, v.exponent, size);
  return terms.rounding(v.exponent, *v.rounding);
}

constexpr BoundedVector turned(ZAxis, const Number& cos, const Number& sin, BoundedVector v) {
  if (by_quarters(cos, sin) || is_constant(cos, sin, v) || !(v.bound.across.largest() > 0.0)) return v;
  const double size = v.bound.across.largest(), error = tilt(cos, sin) * size;
  v.bound.across.error += error, v.bound.whole.error += error;
  const double step = turn_rounding(cos, sin, v, size);
  v.bound = with_rounding(v.bound, root2 * step, 0.0), v.is_literal = false;
  return v;
}
constexpr BoundedVector turned(XAxis, const Number& cos, const Number& sin, BoundedVector v) {
  if (!(v.bound.whole.largest() > 0.0)) return v;
  const double size = v.bound.whole.largest(), error = tilt(cos, sin) * size;
  v.bound = turned_about_x(v.bound, sin.bound.size, cos.bound.size);
  if (by_quarters(cos, sin) || is_constant(cos, sin, v)) return v;
  v.bound.across.error += error, v.bound.along.error += error, v.bound.whole.error += error;
  const double step = turn_rounding(cos, sin, v, size);
  v.bound = with_rounding(v.bound, step, step), v.is_literal = false;
  return v;
}

// p x f for p along an axis.
constexpr VectorSum shifted(ZAxis, const Number& shift, const BoundedVector& f) { return cross_z(f, shift); }
constexpr VectorSum shifted(XAxis, const Number& shift, const BoundedVector& f) {
  const Ball& s = shift.bound;
  VectorSum product{tightened({s * f.bound.along, s * f.bound.across, s * f.bound.whole}), {}, {}};
  add_product(product.across, shift, f.exponent, f.bound.along.largest());
  add_product(product.along, shift, f.exponent, f.bound.across.largest());
  return product;
}

}  // namespace detail

/// Free vector between the frames that a screw joins, either way.
///@{
template <class Axis, class Known>
constexpr BoundedVector to_parent(const detail::Screw<Axis, Known>& x, const BoundedVector& v) {
  return detail::turned(Axis{}, x.cos, x.sin, v);
}
template <class Axis, class Known>
constexpr BoundedVector to_child(const detail::Screw<Axis, Known>& x, const BoundedVector& v) {
  return detail::turned(Axis{}, x.cos, x.sin, v);
}
///@}

/// u x p, p the screw's translation.
template <class Axis, class Known>
constexpr VectorSum cross_shift(const detail::Screw<Axis, Known>& x, const BoundedVector& u) {
  return detail::shifted(Axis{}, x.shift, u);
}

/// Origin of a link's frame in its parent's, where constants of a table are words: the products a cos gamma and a sin
/// gamma are rounded into the exponent of a.
template <class Known, class Other>
constexpr auto translation(const BranchScrew<detail::Screw<ZAxis, Known>, detail::Screw<XAxis, Other>>& branch) {
  const auto part = [&a = branch.x.shift](const Number& turn) {
    if (a.is_literal && turn.is_literal) return literal_of(a.constant * turn.constant);
    Number word = word_of(a.bound * turn.bound, a.exponent);
    if (!word.vanishes()) word.bound.error += WordRounding::ulp(a.exponent);
    return word;
  };
  return Vec3<Number>{part(branch.z.cos), part(branch.z.sin), branch.z.shift};
}

/// The joint's axis in the parent's frame, as far as rounding depends on it: whether it is one of the parent's axes.
struct AxisInParent {
  bool by_quarters = false;  ///< behind turns by multiples of 90 degrees that the compiler knows
  bool parallel = false;     ///< whether it is the axis of the parent's joint
};
/// The axis of a link behind its constant screws.
template <class Known, class Other>
constexpr AxisInParent axis_in_parent(const BranchScrew<detail::Screw<ZAxis, Known>, detail::Screw<XAxis, Other>>& x) {
  return {detail::by_quarters(x.z.cos, x.z.sin) && detail::by_quarters(x.x.cos, x.x.sin), x.x.sin.vanishes()};
}

/// Component along a joint of a force in bounds.
///@{
constexpr Number along_joint(Revolute, const ForceVector<BoundedVector, BoundedVector>& f) {
  return axial_part(f.moment);
}
constexpr Number along_joint(Prismatic, const ForceVector<BoundedVector, BoundedVector>& f) {
  return axial_part(f.force);
}
///@}

}  // namespace axial::bounds

#include <axial/options/end.hpp>
