// Congruences by one axial screw of articulated inertias and of general 3x3 matrices.
#pragma once

#include <axial/spatial/articulated_inertia.hpp>
#include <axial/spatial/congruence.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

template <class Axis, class C, class S, class L, class Turn, class S2>
AXIAL_INLINE constexpr auto beyond_45_degrees(const AxialScrew<Axis, C, S, L, Turn>&, const S2& ss) {
  if constexpr (!std::is_same_v<Turn, AnyTurn>)
    return Turn{};
  else if constexpr (is_zero_v<C>)
    return std::true_type{};
  else if constexpr (is_zero_v<S>)
    return std::false_type{};
  else
    return ss > NumberTraits<S2>::constant(0.5);
}

}  // namespace detail

/// Double angle of a screw with the exchange: for articulated bodies; 1M more for a turn that is not constant.
template <class Axis, class C, class S, class L, class Turn>
AXIAL_INLINE constexpr auto exact_double_angle(const AxialScrew<Axis, C, S, L, Turn>& x) {
  auto ss = turned(x.sin * x.sin);
  auto sc = turned(x.sin * x.cos);
  auto exchange = detail::beyond_45_degrees(x, ss);
  return DoubleAngle{exchange, detail::pick<decltype(ss)>(exchange, -turned(x.cos * x.cos), ss), One{} - ss - ss, sc,
                     sc + sc};
}

namespace detail {

// R M R^T about z for a general M, step D of Table I: 12M 14A, 8M 10A with a zero row.
template <class A, class Screw, class R1, class R2, class R3>
AXIAL_INLINE constexpr auto turn(const A& twice, const Screw& x, const Mat3<R1, R2, R3>& m) {
  using W = decltype(twice.lesser);
  auto difference = m.x.x - m.y.y;
  auto sum = m.x.y + m.y.x;
  auto k1 = turned(difference * twice.lesser + sum * twice.sc);
  auto k2 = turned(difference * twice.sc - sum * twice.lesser);
  auto plane = z_screw(x.cos, x.sin, Zero{});
  auto column = to_parent(plane, Vec3{m.x.z, m.y.z, Zero{}});
  auto row = to_parent(plane, Vec3{m.z.x, m.z.y, m.z.z});
  return Mat3{Vec3{pick<W>(twice.exchange, m.y.y, m.x.x) - k1, pick<W>(twice.exchange, -m.y.x, m.x.y) + k2, column.x},
              Vec3{pick<W>(twice.exchange, -m.x.y, m.y.x) + k2, pick<W>(twice.exchange, m.x.x, m.y.y) + k1, column.y},
              row};
}

// p~ M for p along z, step E: 5M for a symmetric M.
template <class L, class XX, class YY, class ZZ, class XY, class XZ, class YZ>
AXIAL_INLINE constexpr auto shift_rows(const L& p, const Sym3<XX, YY, ZZ, XY, XZ, YZ>& m) {
  auto xy = p * m.xy;
  return Mat3{Vec3{-xy, -(p * m.yy), -(p * m.yz)}, Vec3{p * m.xx, xy, p * m.xz}, ZeroVec3{}};
}

}  // namespace detail

/// General 3x3, R M R^T (Table II: 26M 24A for both screws with step A).
template <class Axis, class C, class S, class L, class Turn, class A, class B, class D>
AXIAL_INLINE constexpr auto to_parent(const AxialScrew<Axis, C, S, L, Turn>& x, const Mat3<A, B, D>& matrix) {
  DoubleAngle twice{std::false_type{}, turned(x.sin * x.sin), Zero{}, turned(x.sin * x.cos), Zero{}};
  return Axis::out(detail::turn(twice, x, Axis::in(matrix)));
}

/// Articulated, reflected or any symmetric 6x6 inertia: X^T N X by one axial screw, McMillan and Orin 1995, Table I.
/// The blocks are turned first and then shifted (p along the axis): with D = R N12 R^T and I = D + p~ N22', the
/// angular block is B + I p~^T + (D p~^T)^T, which needs 4M 3A less a screw than the paper's steps F, G and H.
template <class Axis, class C, class S, class L, class Turn, class A11, class A12, class A22, class Rounder = Plain>
AXIAL_INLINE constexpr auto to_parent(const AxialScrew<Axis, C, S, L, Turn>& x,
                                      const ArticulatedInertia<A11, A12, A22>& n, const Rounder& round = {}) {
  using namespace quantity;
  if constexpr (AxialScrew<Axis, C, S, L, Turn>::is_identity) {
    return round.formatted(n);
  } else {
    auto twice = exact_double_angle(x);
    auto [b, d, linear] = round.formatted(ArticulatedInertia{detail::turn(twice, x, Axis::in(n.angular)),
                                                             detail::turn(twice, x, Axis::in(n.coupling)),
                                                             detail::turn(twice, x, Axis::in(n.linear))});
    auto e = detail::shift_rows(x.shift, linear);
    Mat3 i{round.sum(FirstMoment{}, d.x, e.x), round.sum(FirstMoment{}, d.y, e.y), d.z};
    Sym3 angular{round.sum(RotationalInertia{}, b.xx, -(x.shift * (i.x.y + d.x.y))),
                 round.sum(RotationalInertia{}, b.yy, x.shift * (i.y.x + d.y.x)),
                 b.zz,
                 round.sum(RotationalInertia{}, b.xy, x.shift * (i.x.x - d.y.y)),
                 round.sum(RotationalInertia{}, b.xz, -(x.shift * d.z.y)),
                 round.sum(RotationalInertia{}, b.yz, x.shift * d.z.x)};
    return ArticulatedInertia{Axis::out(angular), Axis::out(i), Axis::out(linear)};
  }
}

}  // namespace axial

#include <axial/options/end.hpp>
