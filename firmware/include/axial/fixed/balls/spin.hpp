// Rotation on bounds: w, dw and U = dw~ + w~ w~ as one value, for U r is bounded by what w and dw make of it, not by
// U's nine entries.
#pragma once

#include <axial/fixed/balls/composite.hpp>
#include <axial/fixed/balls/screws.hpp>

#include <axial/options/begin.hpp>

namespace axial::bounds {

/// The products (wy wz, wx wz, wx wy): what w makes of them, and the rounding of one.
struct Products {
  BoundedVector w{};      ///< rad/s
  double rounding = 0.0;  ///< of one product, rad^2/s^2
  int exponent = 0;       ///< of the products

  /// Passes keep it as it is.
  template <class>
  constexpr const Products& dense() const {
    return *this;
  }
};

/// U of a body that turns with w and dw: how points of the body accelerate, in bounds of what w and dw make of it.
struct Spin {
  SplitBall w{}, dw{};                     ///< rad/s, rad/s^2
  double entry = 0.0;                      ///< rounding of one entry beyond what w and dw carry, rad^2/s^2
  SplitBall axis{};                        ///< the third column: how points of the joint's axis accelerate
  bool axis_apart = false;                 ///< whether the third column has an error of its own
  int exponent = 0;                        ///< of the entries
  const WordRounding* rounding = nullptr;  ///< of the arithmetic

  /// Passes keep it as it is.
  template <class>
  constexpr const Spin& dense() const {
    return *this;
  }
  /// U r for r with a part of length `side` across the axis and one of length `height` along it.
  constexpr SplitBall times(double side, double height) const {
    const Ball ww = w.whole * w.whole, wz = w.across * w.along;
    const SplitBall from_side =
        detail::tightened({side * (dw.along + ww), side * (dw.across + wz), side * (dw.whole + ww)});
    return rounded(from_side, side * detail::root2 * entry) + height * axis;
  }
  /// Bound of one entry, and of U r per metre whatever the direction.
  constexpr Ball strength() const {
    Ball s = dw.whole + w.whole * w.whole;
    s.error += 3.0 * entry;
    if (axis_apart) s.error = detail::hypotenuse(s.error, axis.whole.error);
    return s;
  }
};

namespace detail {
// Rounding of a sum of `count` products of two components of w.
constexpr double rounding_of_products(int count, const BoundedVector& w, int exponent) {
  Terms terms;
  for (int i = 0; i < count; ++i)
    terms.add_product(2 * w.exponent);
  return w.bound.whole.largest() > 0.0 ? terms.rounding(exponent, *w.rounding) : 0.0;
}
}  // namespace detail

/// Products of angular velocities. About the joint's axis alone a body has none.
template <class Link>
constexpr Products products(const BoundedVector& w, const Link& link) {
  const int exponent = link.exponent(quantity::AngularAcceleration{});
  const double rounding = w.bound.across.largest() > 0.0 ? detail::rounding_of_products(1, w, exponent) : 0.0;
  return {w, rounding, exponent};
}

namespace detail {
// The size of U's third column: (p.y + dw.y, p.x - dw.x, -wx^2 - wy^2).
constexpr SplitBall axis_of(const SplitBall& w, const SplitBall& dw) {
  return split(dw.across + w.across * w.along, w.across * w.across);
}
}  // namespace detail

/// U from w, dw and the products: its diagonal has sums of two squares of its own. The third column is computed here,
/// or was there first (`axis`), with an error of its own. An axis that keeps its direction rounds nothing.
///@{
template <class Link>
constexpr Spin rotation_acceleration(const BoundedVector& w, const BoundedVector& dw, const Products& p,
                                     const Link& link) {
  const double square = detail::rounding_of_products(2, w, p.exponent);
  const double entry = p.rounding > square ? p.rounding : square;
  const bool moves = w.bound.across.largest() > 0.0 || dw.bound.across.largest() > 0.0;
  const SplitBall axis = rounded(detail::axis_of(w.bound, dw.bound), moves ? entry : 0.0);
  Spin u{w.bound, dw.bound, entry, axis, false, p.exponent, w.rounding};
  link.note(quantity::AngularAcceleration{}, u.strength());
  return u;
}
template <class Link>
constexpr Spin rotation_acceleration(const BoundedVector& w, const BoundedVector& dw, const Products& p,
                                     const BoundedVector& axis, const Link& link) {
  Spin u = rotation_acceleration(w, dw, p, link);
  u.axis = detail::with_errors_of(u.axis, axis.bound), u.axis_apart = true;
  return u;
}
///@}

/// U times an axis of the frame: a column, which nothing rounds.
constexpr BoundedVector operator*(const Spin& u, const AxisInParent& axis) {
  const Ball other = u.times(1.0, 0.0).whole;
  const SplitBall column = axis.parallel ? u.axis : SplitBall{other, other, other};
  return {column, u.exponent, false, u.rounding};
}
/// Across the axis dw is what the axis' acceleration and the products leave, along it what joint and parent add.
template <class Link, class Joint>
constexpr BoundedVector angular_acceleration(const Link& link, const Products& p, const BoundedVector& axis,
                                             const Number& along, const Joint& qdd) {
  const SplitBall& w = p.w.bound;
  const SplitBall products = detail::split(w.across * w.along, {});
  VectorSum sum{axis.bound + detail::with_rounding(products, detail::root2 * p.rounding, 0.0), {}, {}};
  sum.bound.along = {};
  sum = sum + Vec3{Zero{}, Zero{}, term_of(along) + term_of(qdd)};
  sum.across.add_word(p.exponent);
  return link.sum(quantity::AngularAcceleration{}, sum);
}

/// Either way of computing the motion gives the same: it is as large as the second shows, and as exact as the first
/// where the joint's axis is one of the parent's.
template <class Link, class ByColumn, class ByVectors>
constexpr auto by_axis(const Link& link, const AxisInParent& axis, const ByColumn& by_column,
                       const ByVectors& by_vectors) {
  auto motion = by_vectors();
  if (!axis.by_quarters) return motion;
  link.while_quiet([&] {
    const auto other = by_column(axis);
    motion.dw.bound = detail::with_errors_of(motion.dw.bound, other.dw.bound);
    motion.u.dw = motion.dw.bound;
    motion.u.axis = detail::with_errors_of(motion.u.axis, other.u.axis), motion.u.axis_apart = true;
  });
  return motion;
}

namespace detail {

// What one entry of U, and one of dw or of the products, reaches, by the axes that it joins.
struct EntrySizes {
  double plane, mixed, axis;  // of U: both axes across the joint's, one of them, none
  double dw_across, dw_along, p_across, p_along;
};
constexpr EntrySizes entry_sizes(const Spin& u) {
  const double across = u.w.across.largest(), along = u.w.along.largest();
  const double mixed = across * along, squares = across * across;
  return {u.dw.along.largest() + squares + along * along,
          u.dw.across.largest() + mixed,
          squares,
          u.dw.across.largest(),
          u.dw.along.largest(),
          mixed,
          squares};
}

// Terms of rotational_moment's components, as gyration.hpp adds them.
constexpr void add_entries(VectorSum& n, const Sym3<Number>& j, const Vec3<Number>& d, const Spin& u) {
  const EntrySizes of = entry_sizes(u);
  const int e = u.exponent;
  Terms &across = n.across, &along = n.along;
  add_product(across, worse(j.xx, j.yy), e, of.dw_across), add_product(across, worse(d.x, d.y), e, of.p_across);
  add_product(across, j.xy, e, of.mixed), add_product(across, j.xz, e, of.plane);
  add_product(across, j.yz, e, of.plane);
  add_product(along, j.zz, e, of.dw_along), add_product(along, d.z, e, of.p_along);
  add_product(along, j.xz, e, of.mixed), add_product(along, j.yz, e, of.mixed);
  add_product(along, j.xy, e, of.axis);
}

}  // namespace detail

/// U h of a first moment: what h's part across and its part along make of U, and any other part of the whole.
constexpr VectorSum operator*(const Spin& u, const ConstantVector& h) {
  VectorSum product{u.times(h.side(), h.height()), {}, {}};
  const Ball rest = h.unknown() * u.strength();
  product.bound = product.bound + SplitBall{rest, rest, rest};
  const detail::EntrySizes entry = detail::entry_sizes(u);
  Terms &across = product.across, &along = product.along;
  const int e = u.exponent;
  add_product(across, h.x, e, entry.plane), add_product(across, h.y, e, entry.plane);
  add_product(across, h.z, e, entry.mixed);
  add_product(along, h.x, e, entry.mixed), add_product(along, h.y, e, entry.mixed);
  add_product(along, h.z, e, entry.axis);
  return product;
}
/// U r of a vector of constants or words.
template <class X, class Y, class Z>
constexpr VectorSum operator*(const Spin& u, const Vec3<X, Y, Z>& r) {
  return u * ConstantVector{number_of(r.x), number_of(r.y), number_of(r.z), {}};
}

/// J dw + w x J w, J in blocks across and along the axis (doc/guides/ranges.md): its mean and skew across, the couple
/// between across and along, the entry along.
constexpr VectorSum rotational_moment(const ConstantInertia& inertia, const Vec3<Number>& differences,
                                      const BoundedVector&, const Products&, const Spin& u) {
  using axial::detail::hypotenuse;
  const auto& j = inertia.of;
  const auto value = [](const Number& x) { return x.constant; };
  const double xx = value(j.xx), yy = value(j.yy), zz = value(j.zz);
  const double mean = 0.5 * (xx + yy), skew = hypotenuse(0.5 * (xx - yy), value(j.xy));
  const double block = magnitude(mean) + skew, apart = magnitude(zz - mean) + skew;
  const double couple = hypotenuse(value(j.xz), value(j.yz)), axis = magnitude(zz);
  const Ball wo = u.w.across * u.w.across, wz = u.w.across * u.w.along, along = u.w.along * u.w.along;
  SplitBall n = detail::split(block * u.dw.across + couple * u.dw.along + apart * wz + couple * (along + wo),
                              couple * u.dw.across + axis * u.dw.along + skew * wo + couple * wz);
  n = rounded(n, (2.0 * block + axis + 4.0 * couple + 2.0 * skew + 2.0 * apart) * u.entry);
  const Ball column{
      0.0, u.axis_apart ? couple * u.axis.whole.error : 0.0};  // of the entries that couple the axis with the others
  const Ball rest = Ball{inertia.loose.size, inertia.error()} * u.strength() + column;
  VectorSum moment{n + SplitBall{rest, rest, rest}, {}, {}};
  detail::add_entries(moment, j, differences, u);
  return moment;
}

}  // namespace axial::bounds

#include <axial/options/end.hpp>
