// The way from a link that carries several joints to the axis of one of them: a constant z-screw, then the x-screw.
#pragma once

#include <axial/spatial/congruence.hpp>

#include <axial/options/begin.hpp>

namespace axial {

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
