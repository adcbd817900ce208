// What a joint's drive works against besides its link: friction and springs.
#pragma once

#include <axial/links/links.hpp>
#include <axial/scalar/select.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// What belongs to the direction of a speed; at rest the speed itself, which is 0 (or NaN). Neither way is branched on.
template <class V, class F, class B>
AXIAL_INLINE constexpr auto by_direction(const V& qd, const F& forward, const B& backward) {
  if constexpr (is_zero_v<F> && is_zero_v<B>)
    return Zero{};
  else
    return select(qd > V(Zero{}), V(forward), select(qd < V(Zero{}), V(backward), qd));
}
/// by_direction() for an effort of a link; a number system with formats overloads it for its speeds.
template <class Link, class V, class F, class B>
AXIAL_INLINE constexpr auto effort_by_direction(const Link&, const V& qd, const F& forward, const B& backward) {
  return by_direction(qd, forward, backward);
}

namespace detail {

// x (3 - x^2) / 2, held at +-1 outside: the smooth sign.
template <class V>
AXIAL_INLINE constexpr V smooth_sign(const V& x) {
  const V one(One{}), half = NumberTraits<V>::constant(0.5), three_halves = NumberTraits<V>::constant(1.5);
  const V held = select(one > x, select(x > -one, x, V(-one)), one);
  return held * (three_halves - half * (held * held));
}

// The sign of a speed as the link smooths it; one table may hold links that do and links that do not.
template <class Link, class V>
AXIAL_INLINE constexpr V sign_of_speed(const Link& link, const V& qd) {
  const V smooth = smooth_sign(V(qd * link.inverse_smooth_speed()));
  if constexpr (Link::unrolled)
    return smooth;
  else
    return select(link.inverse_smooth_speed() > V(Zero{}), smooth, by_direction(qd, One{}, MinusOne{}));
}

// Coulomb and Stribeck effort, with the amounts for either direction of motion.
template <class Link, class V, class CF, class CB, class SF, class SB>
AXIAL_INLINE constexpr auto dry_friction(const Link& link, const V& qd, const CF& coulomb_forward,
                                         const CB& coulomb_backward, const SF& stribeck_forward,
                                         const SB& stribeck_backward) {
  auto coulomb = effort_by_direction(link, qd, coulomb_forward, coulomb_backward);
  auto breakaway = effort_by_direction(link, qd, stribeck_forward, stribeck_backward);
  if constexpr (is_zero_v<decltype(breakaway)>)
    return coulomb;
  else
    return coulomb + breakaway * reciprocal(V(One{} + qd * qd * link.inverse_stribeck_speed2()));
}

}  // namespace detail

/// Friction effort of a joint at speed v: viscous v + s(v) (C + (S - C) / (1 + (v/vs)^2)), with Coulomb effort C and
/// static effort S of the direction of motion and the Stribeck speed vs (the form of Hess and Soom 1990, which needs no
/// exponential). s is the sign, 0 at rest; with a smooth speed v0 it is x (3 - x^2) / 2 of x = v/v0 inside +-v0.
/// A link that declares none of them pays for none.
template <class Link, class V>
AXIAL_INLINE constexpr auto friction_effort(const Link& link, const V& qd) {
  if constexpr (!Link::Scene::template has<Friction> || is_zero_v<V>) {
    return Zero{};
  } else {
    auto viscous = link.viscous() * qd;
    auto cf = link.coulomb_forward();  // a declaration each: of several by one auto clang 14 compares types too early
    auto cb = link.coulomb_backward();
    auto sf = link.stribeck_forward();
    auto sb = link.stribeck_backward();
    if constexpr (is_zero_v<decltype(link.inverse_smooth_speed())>)
      return viscous + detail::dry_friction(link, qd, cf, cb, sf, sb);
    else
      return viscous + detail::dry_friction(link, qd, cf, -cb, sf, -sb) * detail::sign_of_speed(link, qd);
  }
}

/// Spring effort of a joint at position q: stiffness (q - rest position).
template <class Link, class Q>
AXIAL_INLINE constexpr auto spring_effort(const Link& link, const Q& q) {
  if constexpr (!Link::Scene::template has<JointSprings>)
    return Zero{};
  else
    return link.spring_stiffness() * (q - link.spring_rest());
}

/// Effort that the drive spends on friction and springs.
template <class Link, class Q, class V>
AXIAL_INLINE constexpr auto passive_effort(const Link& link, const Q& q, const V& qd) {
  return spring_effort(link, q) + friction_effort(link, qd);
}

}  // namespace axial

#include <axial/options/end.hpp>
