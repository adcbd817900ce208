// How the mass of a body flows past its frame: what Coriolis forces depend on.
#pragma once

#include <axial/derivatives/derivative_rounding.hpp>
#include <axial/links/doubled_moments.hpp>
#include <axial/spatial/articulated_congruence.hpp>
#include <axial/spatial/congruence.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Flow of a (composite) body whose points r move with v(r), about the origin and in the axes of one frame: P = 2
/// integral of v dm and C = tr(N) 1 - N with N = 2 integral of v r^T dm. Turning with the rate a besides takes the
/// force (C a; a x P): the Coriolis matrix of Singh, Russell and Wensing 2022, section III, of which C and P are what
/// depends on the body.
template <class C, class P>
struct MassFlow {
  C moment{};    ///< kg m^2/s, a Mat3: C
  P momentum{};  ///< kg m/s: P

  /// This flow as numbers, each quantity in the form in which T keeps it.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return axial::MassFlow{moment.template dense<Kept<T, quantity::FlowMoment>>(),
                           momentum.template dense<Kept<T, quantity::FlowMomentum>>()};
  }
};
template <class C, class P>
MassFlow(C, P) -> MassFlow<C, P>;

/// Two bodies of one frame as one.
template <class A, class B, class C, class D>
AXIAL_INLINE constexpr auto operator+(const MassFlow<A, B>& a, const MassFlow<C, D>& b) {
  return MassFlow{a.moment + b.moment, a.momentum + b.momentum};
}

/// Flow of one body, by twice its moments m, h and s, whose frame moves with w and v: C = (v . h) 1 - v h^T - w x s, P
/// = m v + w x h.
template <class Link, class M, class H, class S, class W, class V>
AXIAL_INLINE constexpr auto mass_flow(const Link& link, const DoubledMoments<M, H, S>& body, const W& w, const V& v) {
  const quantity::FlowMoment q;
  const auto& h = body.first;
  const auto& s = body.second;
  const auto x = v.x * h.x;
  const auto y = v.y * h.y;
  const auto z = v.z * h.z;
  return MassFlow{
      Mat3{Vec3{link.sum(q, y + z, w.z * s.xy - w.y * s.xz), link.sum(q, w.z * s.yy - w.y * s.yz, -(v.x * h.y)),
                link.sum(q, w.z * s.yz - w.y * s.zz, -(v.x * h.z))},
           Vec3{link.sum(q, w.x * s.xz - w.z * s.xx, -(v.y * h.x)), link.sum(q, x + z, w.x * s.yz - w.z * s.xy),
                link.sum(q, w.x * s.zz - w.z * s.xz, -(v.y * h.z))},
           Vec3{link.sum(q, w.y * s.xx - w.x * s.xy, -(v.z * h.x)), link.sum(q, w.y * s.xy - w.x * s.yy, -(v.z * h.y)),
                link.sum(q, x + y, w.y * s.xz - w.x * s.yz)}},
      link.sum(quantity::FlowMomentum{}, body.mass * v, cross(w, h))};
}

namespace detail {

// R S R^T about z by one difference of products: 8M 8A, and none of step A; a quarter turn exchanges elements and costs
// nothing. Where congruence.hpp turns by the double angle, fixed point rounds once; here it would round in between.
template <class Axis, class C, class S, class L, class Turn, class XX, class YY, class ZZ, class XY, class XZ, class YZ>
AXIAL_INLINE constexpr auto turned_tensor(const AxialScrew<Axis, C, S, L, Turn>& x,
                                          const Sym3<XX, YY, ZZ, XY, XZ, YZ>& s) {
  auto column = to_parent(z_screw(x.cos, x.sin, Zero{}), Vec3{s.xz, s.yz, Zero{}});
  if constexpr (is_zero_v<S>) {
    return Sym3{s.xx, s.yy, s.zz, s.xy, column.x, column.y};
  } else if constexpr (is_zero_v<C>) {
    return Sym3{s.yy, s.xx, s.zz, -s.xy, column.x, column.y};
  } else {
    auto w = x.sin * (s.xx - s.yy) + (x.cos + x.cos) * s.xy;
    auto moved = x.sin * w;
    return Sym3{s.xx - moved, s.yy + moved, s.zz, x.cos * w - s.xy, column.x, column.y};
  }
}
// R M R^T about z for a general M by one difference of products: 12M 13A.
template <class Axis, class C, class S, class L, class Turn, class R1, class R2, class R3>
AXIAL_INLINE constexpr auto turned_tensor(const AxialScrew<Axis, C, S, L, Turn>& x, const Mat3<R1, R2, R3>& m) {
  auto plane = z_screw(x.cos, x.sin, Zero{});
  auto column = to_parent(plane, Vec3{m.x.z, m.y.z, Zero{}});
  auto row = to_parent(plane, Vec3{m.z.x, m.z.y, m.z.z});
  if constexpr (is_zero_v<S>) {
    return Mat3{Vec3{m.x.x, m.x.y, column.x}, Vec3{m.y.x, m.y.y, column.y}, row};
  } else if constexpr (is_zero_v<C>) {
    return Mat3{Vec3{m.y.y, -m.y.x, column.x}, Vec3{-m.x.y, m.x.x, column.y}, row};
  } else {
    auto w = x.sin * (m.x.x - m.y.y) + x.cos * (m.x.y + m.y.x);
    auto moved = x.sin * w, turning = x.cos * w;
    return Mat3{Vec3{m.x.x - moved, turning - m.y.x, column.x}, Vec3{turning - m.x.y, m.y.y + moved, column.y}, row};
  }
}

// Rounded once, where ranges are proved: by the double angle, but for quarter turns.
template <class Axis, class C, class S, class L, class Turn, class M, class Rounder>
AXIAL_INLINE constexpr auto turned_tensor(const AxialScrew<Axis, C, S, L, Turn>& x, const M& m, const Rounder&) {
  if constexpr (Rounder::ranged && !is_zero_v<C> && !is_zero_v<S>)
    return turn(double_angle(x), x, m);
  else
    return turned_tensor(x, m);
}
// m in the format of a mass flow.
template <class Rounder, class X, class Y, class Z>
AXIAL_INLINE constexpr auto as_flow(const Rounder& round, const Mat3<X, Y, Z>& m) {
  const quantity::FlowMoment q;
  return Mat3{round.sum(q, m.x), round.sum(q, m.y), round.sum(q, m.z)};
}

}  // namespace detail

/// About the parent's frame, in its axes: the matrix is turned, and P p^T taken from it and P . p added for the shift
/// p.
template <class Axis, class C, class S, class L, class Turn, class N, class P, class Rounder = Plain>
AXIAL_INLINE constexpr auto to_parent(const AxialScrew<Axis, C, S, L, Turn>& x, const MassFlow<N, P>& flow,
                                      const Rounder& round = {}) {
  const quantity::FlowMoment q;
  const auto momentum = round.sum(quantity::FlowMomentum{}, to_parent(x, flow.momentum));
  if constexpr (AxialScrew<Axis, C, S, L, Turn>::is_identity) {
    return MassFlow{detail::as_flow(round, flow.moment), momentum};
  } else {
    const auto c = detail::as_flow(round, detail::turned_tensor(x, Axis::in(flow.moment), round));
    const auto p = Axis::in(momentum);
    const auto along = x.shift * p.z;
    const Mat3 shifted{Vec3{round.sum(q, c.x.x, along), c.x.y, round.sum(q, c.x.z, -(x.shift * p.x))},
                       Vec3{c.y.x, round.sum(q, c.y.y, along), round.sum(q, c.y.z, -(x.shift * p.y))}, c.z};
    return MassFlow{Axis::out(shifted), momentum};
  }
}

/// Force of a turning rate across the joint's axis, of whose z nothing is read.
template <class C, class P, class V>
AXIAL_INLINE constexpr auto flow_force(const MassFlow<C, P>& flow, const V& rate) {
  const Vec3 a{rate.x, rate.y, Zero{}};
  return ForceVector{flow.moment * a, cross(a, flow.momentum)};
}
/// Force of one unit of the joint's rate.
template <class C, class P>
AXIAL_INLINE constexpr auto unit_flow_force(Revolute, const MassFlow<C, P>& flow) {
  const auto& c = flow.moment;
  return ForceVector{Vec3{c.x.z, c.y.z, c.z.z}, Vec3{-flow.momentum.y, flow.momentum.x, Zero{}}};
}
/// Prismatic overload: a slide turns nothing.
template <class C, class P>
AXIAL_INLINE constexpr auto unit_flow_force(Prismatic, const MassFlow<C, P>&) {
  return ForceVector{ZeroVec3{}, ZeroVec3{}};
}
/// What turning rates a do along the joint: b . a.
template <class C, class P>
AXIAL_INLINE constexpr const auto& joint_row(Revolute, const MassFlow<C, P>& flow) {
  return flow.moment.z;
}
/// Prismatic overload.
template <class C, class P>
AXIAL_INLINE constexpr auto joint_row(Prismatic, const MassFlow<C, P>& flow) {
  return Vec3{flow.momentum.y, -flow.momentum.x, Zero{}};
}

}  // namespace axial

#include <axial/options/end.hpp>
