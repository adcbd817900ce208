// What derivatives of inverse dynamics carry, in bounds: mass flows, the motion of axes, the columns of joints.
#pragma once

#include <axial/derivatives/derivative_columns.hpp>
#include <axial/fixed/bounds/links.hpp>

#include <axial/options/begin.hpp>

namespace axial::bounds {

/// A general 3x3 matrix of words that is known by its spectral norm.
struct FlowMatrix {
  Ball bound{};                            ///< of the norm, and of the error's
  int exponent = 0;                        ///< of the words
  const WordRounding* rounding = nullptr;  ///< of the arithmetic

  /// Passes keep it as it is.
  template <class>
  constexpr const FlowMatrix& dense() const {
    return *this;
  }
};
/// Words of one exponent.
constexpr FlowMatrix operator+(const FlowMatrix& a, const FlowMatrix& b) {
  return {a.bound + b.bound, b.exponent, b.rounding};
}
/// A mass flow in bounds.
using BoundedFlow = MassFlow<FlowMatrix, BoundedVector>;
/// A force in bounds.
using BoundedForce = ForceVector<BoundedVector, BoundedVector>;

/// What is across the axis, turned by a quarter: u x z.
constexpr BoundedVector across(BoundedVector u) {
  u.bound = axial::detail::split(u.bound.across, {});
  return u;
}
/// 2 x by its exponent.
constexpr BoundedVector doubled(BoundedVector u) {
  u.bound = 2.0 * u.bound, --u.exponent;
  return u;
}
/// w x p of a translation.
template <class X, class Y, class Z>
constexpr VectorSum cross(const BoundedVector& w, const Vec3<X, Y, Z>& p) {
  return cross(ConstantVector{number_of(p.x), number_of(p.y), number_of(p.z), {}}, w);
}
/// w x h of a first moment.
constexpr VectorSum cross(const BoundedVector& w, const ConstantVector& h) { return cross(h, w); }

/// U's third column.
constexpr BoundedVector third_column(const Spin& u) { return {u.axis, u.exponent, false, u.rounding}; }
/// The parent's where the joint's axis is one of the parent's, else the link's own.
template <class ByParent, class ByLink>
constexpr BoundedVector axis_column(const AxisInParent& axis, const ByParent& by_parent, const ByLink& by_link) {
  if (axis.by_quarters) return by_parent(axis);
  return by_link();
}

/// How the axis of a slide moves: it only turns.
template <class Link>
constexpr auto axis_motion(
    Prismatic, const Link&,
    const derivatives::AxisFrame<BoundedVector, BoundedVector, BoundedVector, BoundedVector>& f) {
  const BoundedVector turning = across(f.w);
  return derivatives::AxisMotion{BoundedMotion{{}, turning}, BoundedMotion{{}, doubled(turning)},
                                 BoundedMotion{{}, f.column}};
}

/// Twice the moments of a link: constants. The second ones, tr(J) 1 - 2 J, are bounded by their rows.
constexpr auto doubled_moments(const Body& body) {
  const auto& h = body.first_moment;
  const auto& j = body.inertia.of;
  const auto of = [](double x) { return literal_of(x); };
  const auto c = [](const Number& x) { return x.constant; };
  return DoubledMoments<Number, ConstantVector, ConstantInertia>{
      of(2.0 * c(body.mass)),
      {of(2.0 * c(h.x)), of(2.0 * c(h.y)), of(2.0 * c(h.z)), {}},
      {{of(c(j.yy) + c(j.zz) - c(j.xx)), of(c(j.xx) + c(j.zz) - c(j.yy)), of(c(j.xx) + c(j.yy) - c(j.zz)),
        of(-2.0 * c(j.xy)), of(-2.0 * c(j.xz)), of(-2.0 * c(j.yz))},
       {}}};
}

namespace detail {

// The constant of the largest size, whose products round most; with what is added to it.
constexpr Number worst(const ConstantVector& h) {
  Number most = worse(h.x, worse(h.y, h.z));
  most.bound = most.bound + h.loose;
  return most;
}
constexpr Number worst(const ConstantInertia& j) {
  const auto& of = j.of;
  Number most = worse(worse(of.xx, worse(of.yy, of.zz)), worse(of.xy, worse(of.xz, of.yz)));
  most.bound = most.bound + j.loose;
  return most;
}
// A matrix of words that is known by its norm, times a vector: as many products a component as the vector has.
constexpr VectorSum matrix_times(const Ball& norm, int exponent, const BoundedVector& v) {
  const Ball n = norm * v.bound.whole;
  VectorSum product{{n, n, n}, {}, {}};
  if (!(n.largest() > 0.0)) return product;
  const int count = (v.bound.across.largest() > 0.0 ? 2 : 0) + (v.bound.along.largest() > 0.0 ? 1 : 0);
  for (int i = 0; i < count; ++i)
    product.across.add_product(exponent + v.exponent), product.along.add_product(exponent + v.exponent);
  return product;
}
// A matrix in the format of a link: what one entry rounds weighs `weight` times.
template <class Link>
constexpr FlowMatrix rounded(const Link& link, Ball bound, const Terms& entry, double weight) {
  const quantity::FlowMoment q;
  bound.error += weight * entry.rounding(link.exponent(q), link.rounding());
  link.note(q, bound);
  return {bound, link.exponent(q), &link.rounding()};
}
// A column or a row of a matrix.
constexpr BoundedVector line_of(const FlowMatrix& m) {
  return {{m.bound, m.bound, m.bound}, m.exponent, false, m.rounding};
}

}  // namespace detail

/// Twice the moments of a link with its payload, in words. Nothing is known of what a payload adds but its norm, of
/// which tr(J) 1 - 2 J is three times at most; so of its error.
template <class Link>
constexpr auto doubled_moments(const Link& link, const Body& body) {
  using namespace quantity;
  const auto constants = doubled_moments(body);
  if (body.mass.is_literal && !link.rounding().tabled) return constants;
  const auto& h = body.first_moment;
  const auto& j = body.inertia;
  const auto about = [&](const Number& a, const Number& b, const Number& c, const Number& own) {
    Number half_of{};
    link.while_quiet([&] { half_of = link.sum(RotationalInertia{}, half(a), half(b), -half(c)); });
    half_of.bound.size = 0.5 * own.bound.size;
    return twice(half_of);
  };
  link.leave_room(RotationalInertia{}, 1.5 * (j.norm() + j.loose.size));
  const Sym3<Number>& own = constants.second.of;
  return DoubledMoments<Number, ConstantVector, ConstantInertia>{
      twice(body.mass),
      {twice(h.x), twice(h.y), twice(h.z), 2.0 * h.loose},
      {{about(j.of.yy, j.of.zz, j.of.xx, own.xx), about(j.of.xx, j.of.zz, j.of.yy, own.yy),
        about(j.of.xx, j.of.yy, j.of.zz, own.zz), twice(j.of.xy), twice(j.of.xz), twice(j.of.yz)},
       3.0 * j.loose}};
}

/// Mass flow of a link: |C| <= |v| |h| + |w| |S|, for (v . h) a - v (h . a) = h x (a x v) and w x (S a) are no longer
/// than that. Nine entries, each rounded: of four products at most.
template <class Link>
constexpr BoundedFlow mass_flow(const Link& link, const DoubledMoments<Number, ConstantVector, ConstantInertia>& body,
                                const BoundedVector& w, const BoundedVector& v) {
  const auto& h = body.first;
  const auto& s = body.second;
  const Ball length = Ball{detail::hypotenuse(h.side(), h.height()), 0.0} + h.unknown();
  const Ball norm{s.norm() + s.loose.size, s.error()};
  Terms entry;
  for (int i = 0; i < 2; ++i) {
    add_product(entry, detail::worst(h), v.exponent, v.bound.whole.largest());
    add_product(entry, detail::worst(s), w.exponent, w.bound.whole.largest());
  }
  const Ball bound = length * v.bound.whole + norm * w.bound.whole;
  return {detail::rounded(link, bound, entry, 3.0), link.sum(quantity::FlowMomentum{}, body.mass * v, cross(w, h))};
}

namespace detail {

// R C R^T by the double angle, as R J R^T (composite.hpp); the couples with the axis are two vectors.
constexpr Ball turned_matrix(const Number& cos, const Number& sin, const FlowMatrix& m, const WordRounding& r) {
  if (by_quarters(cos, sin) || !(m.bound.largest() > 0.0)) return m.bound;
  const double norm = m.bound.largest(), plane = root2 * plane_rounding(cos, m.exponent, 2.0 * norm, r);
  const BoundedVector couple = turned(ZAxis{}, cos, sin, {split({norm, 0.0}, {}), m.exponent, false, &r});
  Ball bound = m.bound;
  bound.error += 2.0 * double_angle_error(cos, sin, r) * norm + plane + couple.bound.whole.error;
  return bound;
}

}  // namespace detail

/// Through one screw: turned, rounded into the link's format, then shifted by (P . p) 1 - P p^T, no larger than |P|
/// |p|; of that four entries, each rounded.
template <class Axis, class Known, class Link>
constexpr BoundedFlow to_parent(const detail::Screw<Axis, Known>& x, const BoundedFlow& flow, const Link& link) {
  const BoundedVector momentum = link.sum(quantity::FlowMomentum{}, to_parent(x, flow.momentum));
  Terms moved;
  if (flow.moment.bound.largest() > 0.0) moved.add_word(flow.moment.exponent);
  const FlowMatrix turned =
      detail::rounded(link, detail::turned_matrix(x.cos, x.sin, flow.moment, link.rounding()), moved, 3.0);
  if (x.shift.vanishes()) return {turned, momentum};
  Terms entry;
  if (turned.bound.largest() > 0.0) entry.add_word(turned.exponent);
  add_product(entry, x.shift, momentum.exponent, momentum.bound.whole.largest());
  return {detail::rounded(link, turned.bound + x.shift.bound * momentum.bound.whole, entry, 2.0), momentum};
}

/// Force of a turning rate across the joint's axis.
constexpr ForceVector<VectorSum, VectorSum> flow_force(const BoundedFlow& flow, const BoundedVector& rate) {
  return {detail::matrix_times(flow.moment.bound, flow.moment.exponent, rate), cross(rate, flow.momentum)};
}
/// Force of one unit of the joint's rate, and the row of what turning rates do along the joint.
///@{
constexpr BoundedForce unit_flow_force(Revolute, const BoundedFlow& flow) {
  return {detail::line_of(flow.moment), across(flow.momentum)};
}
constexpr BoundedForce unit_flow_force(Prismatic, const BoundedFlow&) { return {}; }
constexpr BoundedVector joint_row(Revolute, const BoundedFlow& flow) { return detail::line_of(flow.moment); }
constexpr BoundedVector joint_row(Prismatic, const BoundedFlow& flow) { return across(flow.momentum); }
///@}

/// I m of a composite body.
constexpr ForceVector<VectorSum, VectorSum> inertial_force(const CompositeBody& body, const BoundedMotion& m) {
  const BoundedVector& h = body.first_moment;
  return {detail::matrix_times(body.inertia.bound, body.inertia.exponent, m.angular) + cross(h, m.linear),
          body.mass * m.linear + cross(m.angular, h)};
}
/// b . phi.
///@{
constexpr Number row_along(Revolute, const BoundedVector& row) { return axial_part(row); }
constexpr Zero row_along(Prismatic, const BoundedVector&) { return {}; }
///@}

/// How an axis moves, as the looped form keeps it: a slide's in the formats of what turns. Sizes are noted from the
/// first run on, in which links have formats apart.
template <class Link>
constexpr auto kept_by(const Link& link, derivatives::AxisMotion<BoundedMotion, BoundedMotion, BoundedMotion> axis) {
  if (!link.rounding().tabled) return axis;
  axis.first.linear = link.sum(quantity::LinearVelocity{}, axis.first.linear);
  axis.doubled.linear = doubled(axis.first.linear);
  axis.second.linear = link.sum(quantity::AxisAcceleration{}, axis.second.linear);
  return axis;
}
/// What a joint carries: a step for all links adds masses that are words, and first moments before and behind a shift
/// where there is none, too.
template <class Link>
constexpr auto kept_by(const Link& link,
                       const derivatives::Subtree<CompositeBody, BoundedFlow, BoundedForce>& carried) {
  if (link.rounding().tabled) {
    link.leave_room(quantity::FirstMoment{}, 2.0 * carried.body.first_moment.bound.whole.size);
    link.leave_room(quantity::Mass{}, carried.body.mass.bound.size);
  }
  return carried;
}
/// A joint's columns as the looped form keeps them: of its inertia as unit forces, a slide's row as what turns.
template <class Link>
constexpr auto kept_by(const Link& link,
                       derivatives::Columns<BoundedForce, BoundedVector, BoundedForce, BoundedForce> columns) {
  using namespace quantity;
  if (!link.rounding().tabled) return columns;
  columns.acceleration = derivatives::sum_of<UnitMoment, UnitForce>(link, columns.acceleration);
  columns.row = link.sum(FlowMoment{}, columns.row);
  return columns;
}

/// Viscous friction: no slope describes the jump of dry friction at rest.
template <class S, int N>
constexpr Number friction_slope(const BoundedLink<S, N>& link, const Number&) {
  return link.template drive<&DriveConstants<double>::viscous>();
}

}  // namespace axial::bounds

#include <axial/options/end.hpp>
