// Axial screws: a turn about one coordinate axis and a shift along it. McMillan and Orin 1995, eq. (10).
#pragma once

#include <axial/scalar/rounding.hpp>
#include <axial/spatial/mat3.hpp>
#include <axial/spatial/spatial_vector.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// The z axis as the axis of a screw: operands stay as they are.
struct ZAxis {
  /// An operand in the order in which the screw's axis is z.
  template <class V>
  AXIAL_INLINE static constexpr const V& in(const V& v) {
    return v;
  }
  /// An operand back in its own order.
  template <class V>
  AXIAL_INLINE static constexpr const V& out(const V& v) {
    return v;
  }
};

/// The x axis as the axis of a screw: a cyclic exchange (x, y, z) -> (y, z, x) makes it the z axis, so that every
/// operator is written once.
struct XAxis {
  /// An operand in the order in which the screw's axis is z (`in`), and back (`out`).
  ///@{
  template <class A, class B, class C>
  AXIAL_INLINE static constexpr auto in(const Vec3<A, B, C>& v) {
    return Vec3{v.y, v.z, v.x};
  }
  template <class A, class B, class C>
  AXIAL_INLINE static constexpr auto out(const Vec3<A, B, C>& v) {
    return Vec3{v.z, v.x, v.y};
  }
  template <class A, class B, class C>
  AXIAL_INLINE static constexpr auto in(const Mat3<A, B, C>& m) {
    return Mat3{in(m.y), in(m.z), in(m.x)};
  }
  template <class A, class B, class C>
  AXIAL_INLINE static constexpr auto out(const Mat3<A, B, C>& m) {
    return Mat3{out(m.z), out(m.x), out(m.y)};
  }
  template <class A, class B, class C, class D, class E, class F>
  AXIAL_INLINE static constexpr auto in(const Sym3<A, B, C, D, E, F>& s) {
    return Sym3{s.yy, s.zz, s.xx, s.yz, s.xy, s.xz};
  }
  template <class A, class B, class C, class D, class E, class F>
  AXIAL_INLINE static constexpr auto out(const Sym3<A, B, C, D, E, F>& s) {
    return Sym3{s.zz, s.xx, s.yy, s.xz, s.yz, s.xy};
  }
  ///@}
};

/// A turn that is known at run time only.
struct AnyTurn {};

/// Turn by (cos, sin) about, and shift (m) along one axis: the pose of a child frame in its parent frame. `Turn` says
/// what is known of a constant turn: std::true_type beyond 45 degrees (sin^2 > 1/2), std::false_type up to there.
template <class Axis, class C, class S, class L, class Turn = AnyTurn>
struct AxialScrew {
  C cos{};    ///< cosine of the turn
  S sin{};    ///< sine of the turn
  L shift{};  ///< m, along the axis

  /// True where neither turn nor shift exists: operators then cost nothing.
  static constexpr bool is_identity = std::is_same_v<C, One> && is_zero_v<S> && is_zero_v<L>;

  /// This screw as numbers, each quantity in the form in which T keeps it.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    using Turned = Kept<T, quantity::Turn>;
    using Length = Kept<T, quantity::Length>;
    return AxialScrew<Axis, Turned, Turned, Length>{Holding<Turned>::of(cos), Holding<Turned>::of(sin),
                                                    Holding<Length>::of(shift)};
  }
  /// This screw with what is known of its turn.
  template <class Known>
  AXIAL_INLINE constexpr AxialScrew<Axis, C, S, L, Known> with_turn(Known) const {
    return {cos, sin, shift};
  }
};
/// A screw about the x axis: alpha and a of a link.
template <class C, class S, class L>
using XScrew = AxialScrew<XAxis, C, S, L>;
/// A screw about the z axis: theta and d of a link.
template <class C, class S, class L>
using ZScrew = AxialScrew<ZAxis, C, S, L>;

/// A screw about x from the cosine and sine of its turn and its shift (m).
template <class C, class S, class L>
AXIAL_INLINE constexpr XScrew<C, S, L> x_screw(const C& cos, const S& sin, const L& shift) {
  return {cos, sin, shift};
}
/// A screw about z from the cosine and sine of its turn and its shift (m).
template <class C, class S, class L>
AXIAL_INLINE constexpr ZScrew<C, S, L> z_screw(const C& cos, const S& sin, const L& shift) {
  return {cos, sin, shift};
}

/// Free vector from the child's axes to the parent's: at most 4M 2A (Table II, Cartesian vectors).
template <class Axis, class C, class S, class L, class Turn, class X, class Y, class Z>
AXIAL_INLINE constexpr auto to_parent(const AxialScrew<Axis, C, S, L, Turn>& x, const Vec3<X, Y, Z>& vector) {
  auto v = Axis::in(vector);
  return Axis::out(Vec3{turned(x.cos * v.x - x.sin * v.y), turned(x.sin * v.x + x.cos * v.y), v.z});
}
/// Free vector from the parent's axes to the child's: at most 4M 2A.
template <class Axis, class C, class S, class L, class Turn, class X, class Y, class Z>
AXIAL_INLINE constexpr auto to_child(const AxialScrew<Axis, C, S, L, Turn>& x, const Vec3<X, Y, Z>& vector) {
  auto v = Axis::in(vector);
  return Axis::out(Vec3{turned(x.cos * v.x + x.sin * v.y), turned(x.cos * v.y - x.sin * v.x), v.z});
}

/// u x p, p the screw's translation: linear motion that an angular motion u gives the child's origin; 2M.
template <class Axis, class C, class S, class L, class Turn, class X, class Y, class Z>
AXIAL_INLINE constexpr auto cross_shift(const AxialScrew<Axis, C, S, L, Turn>& x, const Vec3<X, Y, Z>& u) {
  return Axis::out(cross_z(Axis::in(u), x.shift));
}

/// Motion vector from the parent's frame to the child's, v_child = X v_parent: at most 10M 6A (Table II).
template <class Axis, class C, class S, class L, class Turn, class W, class V, class Rounder = Plain>
AXIAL_INLINE constexpr auto to_child(const AxialScrew<Axis, C, S, L, Turn>& x, const MotionVector<W, V>& m,
                                     const Rounder& round = {}) {
  auto linear = round.sum(quantity::LinearAcceleration{}, m.linear, cross_shift(x, m.angular));
  return MotionVector{to_child(x, m.angular), to_child(x, linear)};
}
/// Force vector from the child's frame to the parent's, f_parent = X^T f_child: at most 10M 6A.
template <class Axis, class C, class S, class L, class Turn, class N, class F, class Rounder = Plain>
AXIAL_INLINE constexpr auto to_parent(const AxialScrew<Axis, C, S, L, Turn>& x, const ForceVector<N, F>& f,
                                      const Rounder& round = {}) {
  auto moment = round.sum(quantity::Moment{}, f.moment, -cross_shift(x, f.force));
  return ForceVector{to_parent(x, moment), round.sum(quantity::Force{}, to_parent(x, f.force))};
}

}  // namespace axial

#include <axial/options/end.hpp>
