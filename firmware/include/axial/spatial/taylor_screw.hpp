// Axial screws that turn and shift in time or along a direction: what they carry comes out with its derivatives.
#pragma once

#include <axial/scalar/taylor.hpp>
#include <axial/spatial/screw.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// How the angle of a joint changes; the last two are cut off where no second derivative is asked for.
template <class L, class Q, class H>
struct TurnRates {
  L linear{};       ///< rad/s
  Q quadratic{};    ///< half of the angular acceleration, rad/s^2
  H half_square{};  ///< half of the squared rate, rad^2/s^2: shared by all that the screw carries
};
template <class L, class Q, class H>
TurnRates(L, Q, H) -> TurnRates<L, Q, H>;

/// A z-screw whose angle changes by `rates` and whose shift may be a Taylor number. With u = R v for the turn R of an
/// angle q about z, u' = R v' + q' z x u and u'' = R v'' + 2 q' z x u' + q'^2 u + q'' z x u, u in the last two of
/// across z alone: no sine or cosine has derivatives of its own, and two derivatives take three turns and 8M 8A.
template <class C, class S, class L, class Rates>
struct TaylorScrew : AxialScrew<ZAxis, C, S, L> {
  Rates rates{};  ///< of the angle

  /// The screw at time 0.
  AXIAL_INLINE constexpr const AxialScrew<ZAxis, C, S, L>& at() const { return *this; }
  /// This screw as numbers: cosine and sine as values, for the rates that matter are those of what they turn.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    using V = std::decay_t<decltype(value_at_0(T{}))>;
    using Q = std::decay_t<decltype(quadratic_of(T{}))>;
    using N = Holding<V>;
    return TaylorScrew<V, V, T, TurnRates<V, Q, Q>>{
        {N::of(this->cos), N::of(this->sin), Holding<T>::of(this->shift)},
        {N::of(rates.linear), Holding<Q>::of(rates.quadratic), Holding<Q>::of(rates.half_square)}};
  }
};
/// Taylor screw of a screw at time 0.
template <class C, class S, class L, class M, class Turn, class Rates>
AXIAL_INLINE constexpr auto taylor_screw(const AxialScrew<ZAxis, C, S, L, Turn>& at, const M& shift,
                                         const Rates& rates) {
  return TaylorScrew<C, S, M, Rates>{{at.cos, at.sin, shift}, rates};
}

namespace detail {

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
template <class L, class Q, class H>
AXIAL_INLINE constexpr auto reversed(const TurnRates<L, Q, H>& r) {
  return TurnRates{-r.linear, -r.quadratic, r.half_square};
}

}  // namespace detail

/// Free vectors and forces, as an axial screw carries them.
///@{
template <class C, class S, class L, class R, class X, class Y, class Z>
AXIAL_INLINE constexpr auto to_parent(const TaylorScrew<C, S, L, R>& x, const Vec3<X, Y, Z>& v) {
  return detail::turned_about_z(to_parent(x.at(), v), x.rates);
}
template <class C, class S, class L, class R, class X, class Y, class Z>
AXIAL_INLINE constexpr auto to_child(const TaylorScrew<C, S, L, R>& x, const Vec3<X, Y, Z>& v) {
  return detail::turned_about_z(to_child(x.at(), v), detail::reversed(x.rates));
}
template <class C, class S, class L, class R, class N, class F, class Rounder = Plain>
AXIAL_INLINE constexpr auto to_parent(const TaylorScrew<C, S, L, R>& x, const ForceVector<N, F>& f,
                                      const Rounder& = {}) {
  return ForceVector{to_parent(x, f.moment - cross_shift(x.at(), f.force)), to_parent(x, f.force)};
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
