// Products of angular velocities that a rotating link needs, formed once.
#pragma once

#include <axial/scalar/rounding.hpp>
#include <axial/spatial/congruence.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// k (a - b) for two diagonal entries of U, whose difference is known to vanish where the `third` one does by type:
/// then the body turns about that axis alone.
template <class K, class A, class B, class C>
AXIAL_INLINE constexpr auto times_difference(const K& k, const A& a, const B& b, const C&) {
  if constexpr (is_zero_v<K> || is_zero_v<C>)
    return Zero{};
  else
    return k * (a - b);
}

/// (wy wz, wx wz, wx wy), rad^2/s^2.
template <class W, class Rounder>
AXIAL_INLINE constexpr auto products(const W& w, const Rounder& round) {
  using quantity::AngularAcceleration;
  return Vec3{round.sum(AngularAcceleration{}, w.y * w.z), round.sum(AngularAcceleration{}, w.x * w.z),
              round.sum(AngularAcceleration{}, w.x * w.y)};
}

/// Third column of U, how points of the z axis accelerate: (p.y + dw.y, p.x - dw.x, -wx^2 - wy^2).
template <class W, class DW, class P, class Rounder>
AXIAL_INLINE constexpr auto axis_acceleration(const W& w, const DW& dw, const P& p, const Rounder& round) {
  const quantity::AngularAcceleration q{};
  return Vec3{round.sum(q, p.y, dw.y), round.sum(q, p.x, -dw.x), round.sum(q, -(w.x * w.x), -(w.y * w.y))};
}

/// Matrix U = dw~ + w~ w~: U r is the acceleration of a point r of a body that turns with w and dw, relative to the
/// frame's origin (Khalil and Dombre 2002, chapter 9). `p` are products(w), `axis` the third column; dw may be zero.
template <class W, class DW, class P, class Axis, class Rounder>
AXIAL_INLINE constexpr auto rotation_acceleration(const W& w, const DW& dw, const P& p, const Axis& axis,
                                                  const Rounder& round) {
  const quantity::AngularAcceleration q{};
  auto zz = w.z * w.z;
  return Mat3{Vec3{round.sum(q, -(w.y * w.y), -zz), round.sum(q, p.z, -dw.z), axis.x},
              Vec3{round.sum(q, p.z, dw.z), round.sum(q, -(w.x * w.x), -zz), axis.y},
              Vec3{round.sum(q, p.y, -dw.y), round.sum(q, p.x, dw.x), axis.z}};
}
/// Overload that computes the third column, too.
template <class W, class DW, class P, class Rounder>
AXIAL_INLINE constexpr auto rotation_acceleration(const W& w, const DW& dw, const P& p, const Rounder& round) {
  return rotation_acceleration(w, dw, p, axis_acceleration(w, dw, p, round), round);
}

/// The joint's axis in the axes of the link that carries it.
template <class X>
AXIAL_INLINE constexpr auto axis_in_parent(const X& x) {
  return to_parent(x, along_z(One{}));
}
/// Component of a free vector along the joint's axis.
template <class V>
AXIAL_INLINE constexpr auto axial_part(const V& v) {
  return v.z;
}
/// Angular acceleration of a link whose z axis accelerates by `axis` (U's third column): across the axis from that and
/// the products p, along it from what the parent has there and the joint adds.
template <class Link, class P, class Axis, class Z, class A>
AXIAL_INLINE constexpr auto angular_acceleration(const Link& link, const P& p, const Axis& axis, const Z& along,
                                                 const A& qdd) {
  const quantity::AngularAcceleration q{};
  return Vec3{link.sum(q, p.x, -axis.y), link.sum(q, axis.x, -p.y), link.sum(q, along, qdd)};
}
/// by_column(axis) where the joint's axis is one of the parent's, known to the compiler, else by_vectors().
template <class Link, class Axis, class ByColumn, class ByVectors>
AXIAL_INLINE constexpr auto by_axis(const Link&, const Axis& axis, const ByColumn& by_column,
                                    const ByVectors& by_vectors) {
  if constexpr (is_structural_vector<Axis>)
    return by_column(axis);
  else
    return by_vectors();
}

/// J dw + w x (J w) from the entries of U and the products p: 15M 15A, where the vector form takes 24M 18A.
/// `differences` are (Jzz - Jyy, Jxx - Jzz, Jyy - Jxx).
template <class J, class D, class DW, class P, class U>
AXIAL_INLINE constexpr auto rotational_moment(const J& j, const D& differences, const DW& dw, const P& p, const U& u) {
  return Vec3{
      j.xx * dw.x + differences.x * p.x - j.xy * u.z.x + j.xz * u.y.x + times_difference(j.yz, u.y.y, u.z.z, u.x.x),
      j.yy * dw.y + differences.y * p.y + j.xy * u.z.y - j.yz * u.x.y + times_difference(j.xz, u.z.z, u.x.x, u.y.y),
      j.zz * dw.z + differences.z * p.z - j.xz * u.y.z + j.yz * u.x.z + times_difference(j.xy, u.x.x, u.y.y, u.z.z)};
}

}  // namespace axial

#include <axial/options/end.hpp>
