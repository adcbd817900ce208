// What resists a joint's drive in fixed point.
#pragma once

#include <axial/fixed/links/fixed_links.hpp>
#include <axial/recursion/resistance.hpp>

#include <axial/options/begin.hpp>

namespace axial {

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
