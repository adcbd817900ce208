// What resists a joint's drive in fixed point.
#pragma once

#include <axial/dynamics/resistance.hpp>
#include <axial/fixed/links/fixed_links.hpp>

namespace axial {

/// A lower bound of D is proved: a reciprocal of fixed length.
template <int E, class S, class Scale>
AXIAL_INLINE constexpr auto resistance(const Fx<E, S>& d, const Scale&) {
  return Resistance{inverse_of(d), std::false_type{}, std::true_type{}};
}

}  // namespace axial
