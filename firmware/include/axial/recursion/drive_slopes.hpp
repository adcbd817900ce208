// How what a drive works against changes: friction with speed, springs with position.
#pragma once

#include <axial/recursion/drives.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

// Slope of the smooth sign at a speed: 3 (1 - x^2) / (2 v0) of x = v/v0 inside +-v0, 0 outside and of a link without.
template <class Link, class V>
AXIAL_INLINE constexpr V sign_slope(const Link& link, const V& qd) {
  const V scale(link.inverse_smooth_speed()), x = qd * scale, left = V(One{}) - x * x;
  return select(left > V(Zero{}), V(NumberTraits<V>::constant(1.5) * (left * scale)), V(Zero{}));
}

// Slope of dry_friction(): of what the Stribeck effect adds to Coulomb's.
template <class Link, class V, class SF, class SB>
AXIAL_INLINE constexpr auto dry_slope(const Link& link, const V& qd, const SF& stribeck_forward,
                                      const SB& stribeck_backward) {
  auto breakaway = effort_by_direction(link, qd, stribeck_forward, stribeck_backward);
  if constexpr (is_zero_v<decltype(breakaway)>) {
    return Zero{};
  } else {
    const V scaled(qd * link.inverse_stribeck_speed2()), inverse = reciprocal(V(One{} + qd * scaled));
    return -(breakaway * (scaled + scaled)) * (inverse * inverse);
  }
}

}  // namespace detail

/// d friction_effort() / d qd, N m s/rad or N s/m, at speed qd (rad/s or m/s). Without a smooth speed dry friction
/// jumps at rest: what viscous friction has there is the answer.
template <class Link, class V>
AXIAL_INLINE constexpr auto friction_slope(const Link& link, const V& qd) {
  if constexpr (!Link::Scene::template has<Friction> || is_zero_v<V>) {
    return Zero{};
  } else {
    auto viscous = link.viscous();
    auto cf = link.coulomb_forward();  // a declaration each, as in friction_effort()
    auto cb = link.coulomb_backward();
    auto sf = link.stribeck_forward();
    auto sb = link.stribeck_backward();
    if constexpr (is_zero_v<decltype(link.inverse_smooth_speed())>)
      return viscous + detail::dry_slope(link, qd, sf, sb);
    else
      return viscous + detail::dry_slope(link, qd, sf, -sb) * detail::sign_of_speed(link, qd) +
             detail::dry_friction(link, qd, cf, -cb, sf, -sb) * detail::sign_slope(link, qd);
  }
}

/// d spring_effort() / d q, N m/rad or N/m.
template <class Link>
AXIAL_INLINE constexpr auto spring_slope(const Link& link) {
  if constexpr (!Link::Scene::template has<JointSprings>)
    return Zero{};
  else
    return link.spring_stiffness();
}

}  // namespace axial

#include <axial/options/end.hpp>
