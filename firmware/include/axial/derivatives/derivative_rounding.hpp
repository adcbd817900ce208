// How derivatives of the dynamics round: names of what they keep, for number systems with exponents, and forces under
// other names than those of scalar/rounding.hpp.
#pragma once

#include <axial/spatial/spatial_vector.hpp>

#include <utility>

#include <axial/options/begin.hpp>

namespace axial {

/// Quantities besides those of scalar/rounding.hpp.
namespace quantity {
struct LinearVelocity {};    ///< m/s
struct AxisAcceleration {};  ///< m/s^2: linear part of how an axis' motion changes
struct FlowMoment {};        ///< kg m^2/s: a MassFlow's matrix, and what a joint's speed takes
struct FlowMomentum {};      ///< kg m/s: a MassFlow's vector, and what a joint's speed takes
struct UnitMoment {};        ///< kg m^2 or kg m: what a joint's unit acceleration takes
struct UnitForce {};         ///< kg m or kg: what a joint's unit acceleration takes
struct PositionMoment {};    ///< N m/rad or N: what a joint's position takes
struct PositionForce {};     ///< N/rad or N/m: what a joint's position takes
}  // namespace quantity

/// What 2 x is kept as, of x of a quantity.
template <class T, class Quantity>
using KeptTwice = std::decay_t<decltype(twice(std::declval<const Kept<T, Quantity>&>()))>;

/// a + b where the sum may fit no format of either: number systems with exponents leave it unrounded.
template <class A, class B>
AXIAL_INLINE constexpr auto unrounded_sum(const A& a, const B& b) {
  return a + b;
}

namespace derivatives {

/// Rounding of a link whose forces are those quantities.
template <class Link, class OfMoment, class OfForce>
struct ForceRounding {
  const Link& link;                             ///< referred to
  static constexpr bool ranged = Link::ranged;  ///< whether ranges of its results are proved

  /// The sum of a moment's terms in the format that the moment has here.
  template <class... Terms>
  AXIAL_INLINE constexpr auto sum(quantity::Moment, const Terms&... terms) const {
    return link.sum(OfMoment{}, terms...);
  }
  /// The sum of a force's terms in the format that the force has here.
  template <class... Terms>
  AXIAL_INLINE constexpr auto sum(quantity::Force, const Terms&... terms) const {
    return link.sum(OfForce{}, terms...);
  }
};
/// A link that rounds forces as those quantities; it is referred to.
template <class OfMoment, class OfForce, class Link>
AXIAL_INLINE constexpr ForceRounding<Link, OfMoment, OfForce> as_forces(const Link& link) {
  return {link};
}

/// A force as numbers, kept as those quantities.
template <class T, class OfMoment, class OfForce, class F>
AXIAL_INLINE constexpr auto dense_force(const F& f) {
  return ForceVector{f.moment.template dense<Kept<T, OfMoment>>(), f.force.template dense<Kept<T, OfForce>>()};
}

/// The sum of forces as those quantities.
template <class OfMoment, class OfForce, class Link, class... Forces>
AXIAL_INLINE constexpr auto sum_of(const Link& link, const Forces&... forces) {
  return ForceVector{link.sum(OfMoment{}, forces.moment...), link.sum(OfForce{}, forces.force...)};
}

}  // namespace derivatives
}  // namespace axial

#include <axial/options/end.hpp>
