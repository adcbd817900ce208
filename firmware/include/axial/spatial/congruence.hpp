// Congruences by one axial screw: bodies and tensors from the child's frame to the parent's, X^T I X. And the way from
// a link that carries several joints to the axis of one of them: a constant z-screw, then the x-screw.
#pragma once

#include <axial/scalar/select.hpp>
#include <axial/spatial/inertia.hpp>
#include <axial/spatial/screw.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// What the turns of one screw share (step A): s^2, c^2 - s^2, s c, 2 s c; 2M 3A, off-line for a constant turn.
/// Beyond 45 degrees a turn is an exchange of the axes and a small remainder; with `exchange` (a bool, or a type where
/// the turn is constant) `small` is -c^2 instead of s^2. So an element does not become the difference of large ones: a
/// rotor's reflected inertia of 1e-6 survives a quarter turn beside inertias of 1.
template <class X, class W, class C2, class SC, class SC2>
struct DoubleAngle {
  X exchange{};  ///< whether the axes are exchanged: a bool or a type
  W lesser{};    ///< s^2, or -c^2 behind an exchange
  C2 cc_ss{};    ///< c^2 - s^2
  SC sc{};       ///< s c
  SC2 two_sc{};  ///< 2 s c
};
template <class X, class W, class A, class B, class C>
DoubleAngle(X, W, A, B, C) -> DoubleAngle<X, W, A, B, C>;

namespace detail {

// `Number` is what two different structural scalars (a link of 1 kg m^2 about one axis, 0 about another) become.
template <class Number, class A, class B>
AXIAL_INLINE constexpr auto pick(std::true_type, const A& yes, const B&) {
  return yes;
}
template <class Number, class A, class B>
AXIAL_INLINE constexpr auto pick(std::false_type, const A&, const B& no) {
  return no;
}
template <class Number, class C, class A, class B>
AXIAL_INLINE constexpr auto pick(const C& condition, const A& yes, const B& no) {
  if constexpr (std::is_same_v<A, B> && is_structural_v<A>)
    return yes;
  else if constexpr (is_structural_v<A> && is_structural_v<B>)
    return select(condition, Number(yes), Number(no));
  else if constexpr (is_structural_v<A>)
    return select(condition, B(yes), no);
  else
    return select(condition, yes, A(no));
}

}  // namespace detail

/// Double angle of a screw; plain, without the exchange: for composite bodies, whose elements do not span magnitudes.
template <class Axis, class C, class S, class L, class Turn>
AXIAL_INLINE constexpr auto double_angle(const AxialScrew<Axis, C, S, L, Turn>& x) {
  auto ss = turned(x.sin * x.sin);
  auto sc = turned(x.sin * x.cos);
  return DoubleAngle{std::false_type{}, ss, One{} - ss - ss, sc, sc + sc};
}
namespace detail {

// R S R^T about z, step B or C of Table I: 8M 7A.
template <class A, class Screw, class XX, class YY, class ZZ, class XY, class XZ, class YZ>
AXIAL_INLINE constexpr auto turn(const A& twice, const Screw& x, const Sym3<XX, YY, ZZ, XY, XZ, YZ>& s) {
  using W = decltype(twice.lesser);
  auto difference = s.xx - s.yy;
  auto k1 = turned(difference * twice.lesser + s.xy * twice.two_sc);
  auto k2 = turned(difference * twice.sc + s.xy * twice.cc_ss);
  auto column = to_parent(z_screw(x.cos, x.sin, Zero{}), Vec3{s.xz, s.yz, Zero{}});
  return Sym3{
      pick<W>(twice.exchange, s.yy, s.xx) - k1, pick<W>(twice.exchange, s.xx, s.yy) + k1, s.zz, k2, column.x, column.y};
}

}  // namespace detail

/// Symmetric 3x3, R S R^T (Table II: 18M 17A for both screws with step A).
template <class Axis, class C, class S, class L, class Turn, class A, class B, class D, class E, class F, class G>
AXIAL_INLINE constexpr auto to_parent(const AxialScrew<Axis, C, S, L, Turn>& x, const Sym3<A, B, D, E, F, G>& tensor) {
  return Axis::out(detail::turn(double_angle(x), x, Axis::in(tensor)));
}

namespace detail {

// What a shift adds to an inertia across it, of the first moments along it before and after; nothing to add up of none.
template <class L, class A, class B>
AXIAL_INLINE constexpr auto moment_growth(const L& shift, const A& before, const B& after) {
  if constexpr (is_zero_v<L>)
    return Zero{};
  else
    return shift * (before + after);
}

}  // namespace detail

/// Rigid or composite body: at most 16M 15A with step A off-line, one multiplication less where m p is a constant.
/// McMillan and Orin 1995, Table II (spatial inertia); parallel-axis shift of first moment and inertia.
template <class Axis, class C, class S, class L, class Turn, class M, class H, class J, class Rounder = Plain>
AXIAL_INLINE constexpr auto to_parent(const AxialScrew<Axis, C, S, L, Turn>& x, const RigidInertia<M, H, J>& body,
                                      const Rounder& round = {}) {
  using namespace quantity;
  if constexpr (AxialScrew<Axis, C, S, L, Turn>::is_identity) {
    return round.formatted(body);
  } else {
    auto [mass, turned_h, j] = round.formatted(RigidInertia{body.mass, Axis::in(to_parent(x, body.first_moment)),
                                                            detail::turn(double_angle(x), x, Axis::in(body.inertia))});
    auto hz = round.sum(FirstMoment{}, turned_h.z, x.shift * mass_across_z(mass));
    auto growth = detail::moment_growth(x.shift, turned_h.z, hz);
    Sym3 inertia{round.sum(RotationalInertia{}, j.xx, growth),
                 round.sum(RotationalInertia{}, j.yy, growth),
                 j.zz,
                 j.xy,
                 round.sum(RotationalInertia{}, j.xz, -(x.shift * turned_h.x)),
                 round.sum(RotationalInertia{}, j.yz, -(x.shift * turned_h.y))};
    return RigidInertia{mass, Axis::out(Vec3{turned_h.x, turned_h.y, hz}), Axis::out(inertia)};
  }
}

/// Rz(gamma) Tz(b) Rx(alpha) Tx(a), tree parameters of Khalil and Kleinfinger 1986. Every operator is that of the two
/// screws, one after the other; a screw that is the identity costs nothing. An articulated inertia behind an x-screw is
/// full: the constant z-screw takes 38M 40A of it, 28M 34A where it has a zero row, as McMillan and Orin 1995 count it.
template <class Z, class X>
struct BranchScrew {
  Z z{};  ///< about z of the parent's frame: gamma, b
  X x{};  ///< about x behind it: alpha, a
};
template <class Z, class X>
BranchScrew(Z, X) -> BranchScrew<Z, X>;

/// Whatever a screw carries from the child's frame to the parent's: vectors, forces, inertias.
template <class Z, class X, class Operand, class... Rounder>
AXIAL_INLINE constexpr auto to_parent(const BranchScrew<Z, X>& branch, const Operand& operand,
                                      const Rounder&... round) {
  return to_parent(branch.z, to_parent(branch.x, operand, round...), round...);
}
/// Whatever a screw carries from the parent's frame to the child's: vectors, motions.
template <class Z, class X, class Operand, class... Rounder>
AXIAL_INLINE constexpr auto to_child(const BranchScrew<Z, X>& branch, const Operand& operand, const Rounder&... round) {
  return to_child(branch.x, to_child(branch.z, operand, round...), round...);
}

/// Origin of the child's frame in the parent's, m.
template <class Axis, class C, class S, class L, class Turn>
AXIAL_INLINE constexpr auto translation(const AxialScrew<Axis, C, S, L, Turn>& x) {
  return Axis::out(along_z(x.shift));
}
/// Translation through both screws, in axes of the parent's frame.
template <class Z, class X>
AXIAL_INLINE constexpr auto translation(const BranchScrew<Z, X>& branch) {
  return to_parent(branch.z, translation(branch.x)) + translation(branch.z);
}

}  // namespace axial

#include <axial/options/end.hpp>
