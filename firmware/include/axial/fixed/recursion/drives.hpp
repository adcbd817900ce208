// Friction in fixed point, which takes the format of the link's effort, and what resists a joint's drive.
#pragma once

#include <axial/fixed/links/fixed_links.hpp>
#include <axial/recursion/drives.hpp>
#include <axial/recursion/resistance.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// What belongs to the direction of a speed, 0 at rest.
template <class Link, int E, class S, class F, class B>
AXIAL_INLINE constexpr auto effort_by_direction(const Link& link, const Fx<E, S>& qd, const F& forward,
                                                const B& backward) {
  if constexpr (is_zero_v<F> && is_zero_v<B>) {
    return Zero{};
  } else {
    const quantity::JointEffort effort;
    using Effort = decltype(link.sum(effort, qd));
    const Fx<E, S> still{};
    return select(qd > still, Effort(link.sum(effort, forward)),
                  select(qd < still, Effort(link.sum(effort, backward)), Effort{}));
  }
}

/// A lower bound of D is proved: a reciprocal of fixed length.
template <int E, class S, class Scale>
AXIAL_INLINE constexpr auto resistance(const Fx<E, S>& d, const Scale&) {
  return Resistance{inverse_of(d), std::false_type{}, std::true_type{}};
}

/// Resistance of a link's joint: formats may be made for a usual resistance rather than the least. A joint that feels
/// less than that has a status.
template <class Link, int E, class S, class Scale>
AXIAL_INLINE constexpr auto resistance_at(const Link& link, const Fx<E, S>& d, const Scale& scale) {
  if constexpr (Link::usually_resisted) {
    bool lost = false;
    const auto inverse = inverse_of(link.resisting(lost, d));
    return Resistance{inverse, lost, std::true_type{}};
  } else {
    return resistance(d, scale);
  }
}

}  // namespace axial

#include <axial/options/end.hpp>
