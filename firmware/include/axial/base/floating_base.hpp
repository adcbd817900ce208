// A base that is free: its 6x6 symmetric articulated inertia, factored and solved; what pushes it, and what the links
// that it carries add to it.
#pragma once

#include <axial/base/water.hpp>
#include <axial/recursion/moving_base.hpp>
#include <axial/recursion/reflection.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

/// L D L^T of a symmetric positive definite 3x3 block: the entries yx, zx, zy of L and the inverse of D.
template <class L, class D, class B>
struct Factors {
  L lower{};
  D inverse{};
  B singular{};
};
template <class L, class D, class B>
Factors(L, D, B) -> Factors<L, D, B>;

// A pivot is compared with `scale`, the composite inertia that it was subtracted from.
template <class T, class Round, class S, class Scale>
AXIAL_INLINE constexpr auto factored(const Round& round, const S& s, const Scale& scale) {
  using namespace quantity;
  auto x = resistance(T(s.xx), scale);
  auto yx = round.sum(AngularGain{}, x.inverse * s.xy);
  auto zx = round.sum(AngularGain{}, x.inverse * s.xz);
  auto y = resistance(T(round.sum(JointInertia{}, s.yy, -(yx * s.xy))), scale);
  auto yz = round.sum(JointInertia{}, s.yz, -(zx * s.xy));
  auto zy = round.sum(AngularGain{}, y.inverse * yz);
  auto z = resistance(T(round.sum(JointInertia{}, s.zz, -(zx * s.xz), -(zy * yz))), scale);
  return Factors{Vec3{yx, zx, zy}, Vec3{x.inverse, y.inverse, z.inverse},
                 Truth<T>(x.singular | y.singular | z.singular)};
}

// L y = v; then L^T x = y.
template <class Round, class F, class V>
AXIAL_INLINE constexpr auto forward(const Round& round, const F& factors, const V& v) {
  auto y = round.sum(quantity::Force{}, v.y, -(factors.lower.x * v.x));
  return Vec3{v.x, y, round.sum(quantity::Force{}, v.z, -(factors.lower.y * v.x), -(factors.lower.z * y))};
}
template <class Round, class F, class V>
AXIAL_INLINE constexpr auto backward(const Round& round, const F& factors, const V& v) {
  auto y = round.sum(quantity::LinearAcceleration{}, v.y, -(factors.lower.z * v.z));
  return Vec3{round.sum(quantity::LinearAcceleration{}, v.x, -(factors.lower.x * y), -(factors.lower.y * v.z)), y, v.z};
}

// s - W V^T, known to be symmetric.
template <class Round, class S, class W, class V>
AXIAL_INLINE constexpr auto complement(const Round& round, const S& s, const W& w, const V& v) {
  auto entry = [&](const auto& own, const auto& a, const auto& b)
                   AXIAL_INLINE { return round.sum(quantity::RotationalInertia{}, own, -dot(a, b)); };
  return Sym3{entry(s.xx, w.x, v.x), entry(s.yy, w.y, v.y), entry(s.zz, w.z, v.z),
              entry(s.xy, w.x, v.y), entry(s.xz, w.x, v.z), entry(s.yz, w.y, v.z)};
}

}  // namespace detail

/// Acceleration of a free body, and whether its inertia is lost in rounding.
template <class M, class B>
struct FreeMotion {
  M acceleration{};  ///< rad/s^2 and m/s^2, of the frame's origin
  B singular{};      ///< whether a pivot is lost in rounding
};
template <class M, class B>
FreeMotion(M, B) -> FreeMotion<M, B>;

/// Solves I a + p = 0 for an articulated inertia I and the force p: L D L^T without pivoting, the linear block first,
/// then the angular one (the inertia about the articulated centre of mass). 86M 65A 6D; known zeros cost nothing.
/// `scale` is the composite inertia: a pivot below 16 eps of it is singular, one below eps^2 of it moves nothing.
template <class T, class Round, class I, class P, class R>
AXIAL_INLINE constexpr auto free_motion(const Round& round, const I& inertia, const P& p, const R& scale) {
  using namespace quantity;
  const auto& c = inertia.coupling;
  auto linear = detail::factored<T>(round, inertia.linear, scale.mass);
  Mat3 w{detail::forward(round, linear, c.x), detail::forward(round, linear, c.y), detail::forward(round, linear, c.z)};
  Mat3 gain{detail::each(linear.inverse, w.x), detail::each(linear.inverse, w.y), detail::each(linear.inverse, w.z)};
  auto angular = detail::factored<T>(round, detail::complement(round, inertia.angular, gain, w), scale.polar);
  auto force = detail::forward(round, linear, p.force);
  auto moment = round.sum(Moment{}, p.moment, -(gain * force));
  auto turn = detail::backward(round, angular, detail::each(angular.inverse, detail::forward(round, angular, moment)));
  auto shift = round.sum(LinearAcceleration{}, detail::each(linear.inverse, force), -transpose_times(gain, turn));
  return FreeMotion{MotionVector{-turn, -detail::backward(round, linear, shift)},
                    Truth<T>(linear.singular | angular.singular)};
}

/// Force that the environment exerts on the base, N m and N at the origin of frame 0; zero by type unless the scene
/// names BaseWrench.
template <class Links, class Input>
AXIAL_INLINE constexpr auto base_load(const Links&, const Input& in) {
  if constexpr (Links::Scene::template has<BaseWrench>)
    return in.base_wrench;
  else
    return ForceVector<ZeroVec3, ZeroVec3>{};
}

/// force_on_water of the base body.
template <class Links, class Input, class Body, class P, class U, class DW, class A>
AXIAL_INLINE constexpr auto base_force_on_water(const Links& links, const Input& in, const Body& body, const P& p,
                                                const U& rate, const DW& dw, const A& a) {
  if constexpr (Links::Scene::template has<Underwater>)
    return water_force(body, water_of_base(links), body.body(), base_immersion(links, in), p, rate, dw, a);
  else
    return ForceVector<ZeroVec3, ZeroVec3>{};
}

namespace detail {
template <int I, class Links, class Left, class Sum>
AXIAL_INLINE constexpr auto with_roots_from(const Links& links, const Left& left, const Sum& sum) {
  if constexpr (I >= Links::capacity)
    return sum;
  else if constexpr (Links::template parent_of<I> < 0)
    return with_roots_from<I + 1>(links, left, sum + left[Index<I>{}].on_parent);
  else
    return with_roots_from<I + 1>(links, left, sum);
}
}  // namespace detail

/// own + what an inward pass left to frame 0: the sum over the links that the base carries.
template <class Links, class Left, class Own>
AXIAL_INLINE constexpr auto with_roots(const Links& links, const Left& left, const Own& own) {
  if constexpr (Links::unrolled) {
    return detail::with_roots_from<0>(links, left, own);
  } else {
    auto sum = own.template dense<typename Links::Scalar>();
    for (int i = 0; i < links.size(); ++i)
      if (links.parent_index(i) < 0) sum = sum + left[i].on_parent;
    return sum;
  }
}

}  // namespace axial

#include <axial/options/end.hpp>
