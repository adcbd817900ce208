// What composite bodies make of axial masses: what is beyond such a slide, and what the links inboard feel of it.
#pragma once

#include <axial/spatial/inertia.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// What such a slide carries has given its mass up, so that nothing else adds to it.
template <class M>
AXIAL_INLINE constexpr AxialMass<M> operator+(const AxialMass<M>& mass, Zero) {
  return mass;
}

/// A body as the links inboard feel it: none of an axial mass, which acts along axes that they turn about.
template <class Body>
AXIAL_INLINE constexpr const Body& inboard_part(const Body& body) {
  return body;
}
/// Axial overload.
template <class M, class H, class J>
AXIAL_INLINE constexpr auto inboard_part(const RigidInertia<AxialMass<M>, H, J>& body) {
  return RigidInertia{Zero{}, body.first_moment, body.inertia};
}

}  // namespace axial

#include <axial/options/end.hpp>
