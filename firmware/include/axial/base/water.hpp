// What the water exerts on links and base body: added mass with its Coriolis terms, weight less buoyancy, drag.
#pragma once

#include <axial/base/water_view.hpp>
#include <axial/recursion/gyration.hpp>
#include <axial/recursion/immersion.hpp>
#include <axial/recursion/joint_axis.hpp>
#include <axial/recursion/moving_base.hpp>
#include <axial/recursion/passes.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {
template <>
inline constexpr bool water_included<Underwater> = true;
}  // namespace detail

/// A frame's velocity through the water (angular rad/s, linear m/s at its origin) and gravity (m/s^2), in its axes.
template <class V, class G>
struct Immersion {
  V velocity{};  ///< through the water
  G gravity{};   ///< in the frame's axes
  /// This immersion as plain numbers.
  template <class T>
  AXIAL_INLINE constexpr Immersion<MotionVector<Vec3<T>, Vec3<T>>, Vec3<T>> dense() const {
    return {velocity.template dense<T>(), gravity.template dense<T>()};
  }
};
template <class V, class G>
Immersion(V, G) -> Immersion<V, G>;

/// Immersion of frame 0.
template <class Links, class Input>
AXIAL_INLINE constexpr auto base_immersion(const Links& links, const Input& in) {
  using Scene = typename Links::Scene;
  if constexpr (!Scene::template has<Underwater>) {
    return Dry{};
  } else {
    auto w = base_angular_velocity(links, in);
    auto g = gravity_at_base(links, in);
    if constexpr (Scene::template has<VelocityThroughWater>)
      return Immersion{MotionVector{w, in.velocity_through_water}, g};
    else
      return Immersion{MotionVector{w, ZeroVec3{}}, g};
  }
}

/// Immersions of all links, from the base outwards: immersions() of a scene that is under water.
template <class Links, class Input, class Screws, class V>
AXIAL_INLINE constexpr auto immersions_in_water(const Links& links, const Input& in, const Screws& screws,
                                                const V& qd) {
  return outward(links, base_immersion(links, in), [&](auto i, const auto& parent) AXIAL_INLINE {
    auto link = links.link(i);
    auto x = link.x();
    auto carried = to_child(screws[i], to_child(x, parent.velocity));
    auto gravity = to_child(screws[i], to_child(x, parent.gravity));
    return link.on_joint([&](auto joint) AXIAL_INLINE {
      return link.shape(Immersion{carried + along_axis(joint, qd[i]), gravity});
    });
  });
}

namespace detail {

template <class A, class B>
AXIAL_INLINE constexpr auto each(const A& by, const B& v) {
  return Vec3{by.x * v.x, by.y * v.y, by.z * v.z};
}
template <class V, class L, class Q>
AXIAL_INLINE constexpr auto drag(const V& v, const L& linear, const Q& quadratic) {
  auto one = [](const auto& speed, const auto& l, const auto& q)
                 AXIAL_INLINE { return speed * (l + q * absolute(speed)); };
  return Vec3{one(v.x, linear.x, quadratic.x), one(v.y, linear.y, quadratic.y), one(v.z, linear.z, quadratic.z)};
}
// w x (A v) - A (w x v) for a diagonal A of the given differences.
template <class D, class W, class V>
AXIAL_INLINE constexpr auto turned_momentum(const D& d, const W& w, const V& v) {
  return Vec3{-(d.y * (w.y * v.z)) - d.z * (w.z * v.y), -(d.z * (w.z * v.x)) - d.x * (w.x * v.z),
              -(d.x * (w.x * v.y)) - d.y * (w.y * v.x)};
}

}  // namespace detail

/// Force that a body must exert on the water, and against its weight less buoyancy, to move as it does: Kirchhoff's
/// equations (Lamb, Hydrodynamics, chapter VI; Fossen 2011, eqs. (6.43) to (6.52)) about the centre of buoyancy c with
/// added mass A and added inertia I, both diagonal, u the velocity of c through the water:
///   f = A (a + U c) + w x (A u) - A (w x u) + D(u) - (m - m_displaced) g
///   n = I dw + w x (I w) + u x (A u) + D(w) + c x f', weight apart, at the frame's origin.
/// `a` and `dw` are without gravity; `rate` is U = dw~ + w~ w~, `p` the products of w.
template <class Round, class Water, class Body, class State, class P, class U, class DW, class A>
AXIAL_INLINE constexpr auto water_force(const Round& round, const Water& water, const Body& body, const State& state,
                                        const P& p, const U& rate, const DW& dw, const A& a) {
  using namespace quantity;
  const auto& w = state.velocity.angular;
  auto c = water.centre();
  auto u = state.velocity.linear + cross(w, c);
  auto force = round.sum(Force{}, detail::each(water.added_mass(), a + rate * c),
                         detail::turned_momentum(water.mass_differences(), w, u),
                         detail::drag(u, water.linear_drag(), water.quadratic_drag()));
  auto moment =
      round.sum(Moment{}, detail::each(water.added_inertia(), dw), detail::each(water.inertia_differences(), p),
                detail::each(water.mass_differences(), products(u, round)),
                detail::drag(w, water.linear_turning_drag(), water.quadratic_turning_drag()), cross(c, force));
  auto mass = body.mass - water.displaced();
  auto weight = mass * state.gravity;
  auto tipping = cross(body.first_moment - water.displaced_moment(), state.gravity);
  return ForceVector{moment - tipping, force - weight};
}

}  // namespace axial

#include <axial/options/end.hpp>
