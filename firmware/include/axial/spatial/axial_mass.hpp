// The mass of a slide whose parent bears it across the slide's direction: accelerations along z alone meet it.
#pragma once

#include <axial/spatial/vec3.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A mass along z of its frame and none across, kg.
template <class M>
struct AxialMass {
  M along{};  ///< kg
};
template <class M>
AxialMass(M) -> AxialMass<M>;

/// An axial mass where `axial` says so, else the mass itself.
template <bool axial, class M>
AXIAL_INLINE constexpr auto mass_as(const M& mass) {
  if constexpr (axial)
    return AxialMass{mass};
  else
    return mass;
}

/// Mass that resists along z: of a body in general all of it.
template <class M>
AXIAL_INLINE constexpr const M& mass_along_z(const M& mass) {
  return mass;
}
/// Axial overload.
template <class M>
AXIAL_INLINE constexpr const M& mass_along_z(const AxialMass<M>& mass) {
  return mass.along;
}
/// Mass that resists across z: of a body in general all of it.
template <class M>
AXIAL_INLINE constexpr const M& mass_across_z(const M& mass) {
  return mass;
}
/// Axial overload: none.
template <class M>
AXIAL_INLINE constexpr Zero mass_across_z(const AxialMass<M>&) {
  return {};
}

/// Force that gives the mass an acceleration.
template <class M, class X, class Y, class Z>
AXIAL_INLINE constexpr auto operator*(const AxialMass<M>& mass, const Vec3<X, Y, Z>& a) {
  return along_z(mass.along * a.z);
}
/// What such a slide carries has given its mass up, so that nothing else adds to it.
template <class M>
AXIAL_INLINE constexpr AxialMass<M> operator+(const AxialMass<M>& mass, Zero) {
  return mass;
}

}  // namespace axial

#include <axial/options/end.hpp>
