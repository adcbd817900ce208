// Axial screws that turn and shift along a direction: what they carry comes out with its derivative.
#pragma once

#include <axial/scalar/dual.hpp>
#include <axial/spatial/screw.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A z-screw whose turn changes by `turn` (rad per unit of the direction) and whose shift may be a dual number. The
/// change of what was turned follows from the result by 2M 2A: no sine or cosine has a derivative of its own.
template <class C, class S, class L, class D>
struct DualScrew : AxialScrew<ZAxis, C, S, L> {
  D turn{};  ///< change of the angle

  /// The screw at the point.
  AXIAL_INLINE constexpr const AxialScrew<ZAxis, C, S, L>& at() const { return *this; }
  /// This screw as numbers: cosine and sine as values, for the slopes that matter are those of what they turn.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    using V = std::decay_t<decltype(value_of(T{}))>;
    return DualScrew<V, V, T, V>{{Holding<V>::of(this->cos), Holding<V>::of(this->sin), Holding<T>::of(this->shift)},
                                 Holding<V>::of(turn)};
  }
};
/// Dual screw of a screw at the point.
template <class C, class S, class L, class M, class Turn, class D>
AXIAL_INLINE constexpr auto dual_screw(const AxialScrew<ZAxis, C, S, L, Turn>& at, const M& shift, const D& turn) {
  return DualScrew<C, S, M, D>{{at.cos, at.sin, shift}, turn};
}

namespace detail {
// v, which the axes' turn about z changes by z x v times the amount.
template <class X, class Y, class Z, class D>
AXIAL_INLINE constexpr auto turned_about_z(const Vec3<X, Y, Z>& v, const D& turn) {
  return Vec3{add_slope(v.x, -(turn * value_of(v.y))), add_slope(v.y, turn * value_of(v.x)), v.z};
}
}  // namespace detail

/// Free vectors and forces, as an axial screw carries them.
///@{
template <class C, class S, class L, class D, class X, class Y, class Z>
AXIAL_INLINE constexpr auto to_parent(const DualScrew<C, S, L, D>& x, const Vec3<X, Y, Z>& v) {
  return detail::turned_about_z(to_parent(x.at(), v), x.turn);
}
template <class C, class S, class L, class D, class X, class Y, class Z>
AXIAL_INLINE constexpr auto to_child(const DualScrew<C, S, L, D>& x, const Vec3<X, Y, Z>& v) {
  return detail::turned_about_z(to_child(x.at(), v), -x.turn);
}
template <class C, class S, class L, class D, class N, class F, class Rounder = Plain>
AXIAL_INLINE constexpr auto to_parent(const DualScrew<C, S, L, D>& x, const ForceVector<N, F>& f, const Rounder& = {}) {
  return ForceVector{to_parent(x, f.moment - cross_shift(x.at(), f.force)), to_parent(x, f.force)};
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
