// Friction in fixed point, which takes the format of the link's effort.
#pragma once

#include <axial/fixed/links/fixed_links.hpp>
#include <axial/recursion/drives.hpp>

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

}  // namespace axial

#include <axial/options/end.hpp>
