// Axial screws that turn and shift along a direction, or in time: what they carry comes out with its derivatives.
#pragma once

#include <axial/scalar/series.hpp>
#include <axial/spatial/screw.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// How the angle of a joint changes.
template <class L, class Q, class H>
struct TurnRates {
  L linear{};       ///< rad/s
  Q quadratic{};    ///< half of the angular acceleration, rad/s^2
  H half_square{};  ///< half of the squared rate, rad^2/s^2: shared by all that the screw carries
};
template <class L, class Q, class H>
TurnRates(L, Q, H) -> TurnRates<L, Q, H>;
/// A turn the other way round.
template <class L, class Q, class H>
AXIAL_INLINE constexpr auto operator-(const TurnRates<L, Q, H>& r) {
  return TurnRates{-r.linear, -r.quadratic, r.half_square};
}

namespace detail {

/// How an angle changes, as numbers V.
///@{
template <class V, class D>
AXIAL_INLINE constexpr V dense_change(const D& turn) {
  return Holding<V>::of(turn);
}
template <class V, class L, class Q, class H>
AXIAL_INLINE constexpr TurnRates<V, V, V> dense_change(const TurnRates<L, Q, H>& turn) {
  using N = Holding<V>;
  return {N::of(turn.linear), N::of(turn.quadratic), N::of(turn.half_square)};
}
///@}

}  // namespace detail

/// A z-screw whose angle changes by `turn`, along a direction or in time, and whose shift may be a dual or a Taylor
/// number. What was turned changes by what comes out: no sine or cosine has derivatives of its own.
template <class C, class S, class L, class Change>
struct MovingScrew : AxialScrew<ZAxis, C, S, L> {
  Change turn{};  ///< change of the angle

  /// The screw at the point, or at time 0.
  AXIAL_INLINE constexpr const AxialScrew<ZAxis, C, S, L>& at() const { return *this; }
  /// This screw as numbers: cosine and sine as values, for the changes that matter are those of what they turn.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    using V = std::decay_t<decltype(value_of(value_at_0(T{})))>;
    auto change = detail::dense_change<V>(turn);
    return MovingScrew<V, V, T, decltype(change)>{
        {Holding<V>::of(this->cos), Holding<V>::of(this->sin), Holding<T>::of(this->shift)}, change};
  }
};

/// A screw that moves along a direction, rad per unit of that: the change of what was turned takes 2M 2A.
template <class C, class S, class L, class D>
using DualScrew = MovingScrew<C, S, L, D>;
/// A screw that moves in time. With u = R v for the turn R of an angle q about z, u' = R v' + q' z x u and u'' = R v''
/// + 2 q' z x u' + q'^2 u + q'' z x u, u in the last two of across z alone: two derivatives take three turns and 8M 8A.
template <class C, class S, class L, class Rates>
using TaylorScrew = MovingScrew<C, S, L, Rates>;

/// The moving screw of a screw at the point, or at time 0.
///@{
template <class C, class S, class L, class M, class Turn, class D>
AXIAL_INLINE constexpr auto dual_screw(const AxialScrew<ZAxis, C, S, L, Turn>& at, const M& shift, const D& turn) {
  return DualScrew<C, S, M, D>{{at.cos, at.sin, shift}, turn};
}
template <class C, class S, class L, class M, class Turn, class Rates>
AXIAL_INLINE constexpr auto taylor_screw(const AxialScrew<ZAxis, C, S, L, Turn>& at, const M& shift,
                                         const Rates& rates) {
  return TaylorScrew<C, S, M, Rates>{{at.cos, at.sin, shift}, rates};
}
///@}

namespace detail {

// v, which the axes' turn about z changes by z x v times the amount.
template <class X, class Y, class Z, class D>
AXIAL_INLINE constexpr auto turned_about_z(const Vec3<X, Y, Z>& v, const D& turn) {
  return Vec3{add_slope(v.x, -(turn * value_of(v.y))), add_slope(v.y, turn * value_of(v.x)), v.z};
}
// v, which comes out of a turn with the rates of what went in, with those that the turn about z adds.
template <class X, class Y, class Z, class L, class Q, class H>
AXIAL_INLINE constexpr auto turned_about_z(const Vec3<X, Y, Z>& v, const TurnRates<L, Q, H>& r) {
  auto x = value_at_0(v.x);
  auto y = value_at_0(v.y);
  auto dx = linear_of(v.x) - r.linear * y;
  auto dy = linear_of(v.y) + r.linear * x;
  return Vec3{with_rates(x, dx, quadratic_of(v.x) - r.linear * dy - r.quadratic * y + r.half_square * x),
              with_rates(y, dy, quadratic_of(v.y) + r.linear * dx + r.quadratic * x + r.half_square * y), v.z};
}

}  // namespace detail

/// Free vectors and forces, as an axial screw carries them.
///@{
template <class C, class S, class L, class D, class X, class Y, class Z>
AXIAL_INLINE constexpr auto to_parent(const MovingScrew<C, S, L, D>& x, const Vec3<X, Y, Z>& v) {
  return detail::turned_about_z(to_parent(x.at(), v), x.turn);
}
template <class C, class S, class L, class D, class X, class Y, class Z>
AXIAL_INLINE constexpr auto to_child(const MovingScrew<C, S, L, D>& x, const Vec3<X, Y, Z>& v) {
  return detail::turned_about_z(to_child(x.at(), v), -x.turn);
}
template <class C, class S, class L, class D, class N, class F, class Rounder = Plain>
AXIAL_INLINE constexpr auto to_parent(const MovingScrew<C, S, L, D>& x, const ForceVector<N, F>& f,
                                      const Rounder& = {}) {
  return ForceVector{to_parent(x, f.moment - cross_shift(x.at(), f.force)), to_parent(x, f.force)};
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
