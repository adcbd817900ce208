// The inertia of a rigid body about a frame's origin. And the mass of a slide whose parent bears it across the slide's
// direction: accelerations along z alone meet it.
#pragma once

#include <axial/scalar/rounding.hpp>
#include <axial/spatial/mat3.hpp>

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
/// Rigid (or composite) body: mass m (kg), first moment m c (kg m) and inertia about the frame's origin (kg m^2).
/// As a 6x6 matrix: [ J, (m c)~ ; (m c)~^T, m 1 ], theory of McMillan and Orin 1995, eq. (2).
template <class M, class H, class J>
struct RigidInertia {
  M mass{};          ///< kg
  H first_moment{};  ///< kg m, m c in axes of the frame
  J inertia{};       ///< kg m^2, a Sym3 about the frame's origin

  /// Structural elements become numbers where the target has numbers.
  template <class A, class B, class C>
  AXIAL_INLINE constexpr operator RigidInertia<A, B, C>() const {
    return {mass, first_moment, inertia};
  }  // NOLINT(google-explicit-constructor)
  /// This body as numbers, each quantity in the form in which T keeps it.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    using Mass = Kept<T, quantity::Mass>;
    return axial::RigidInertia{Holding<Mass>::of(mass), first_moment.template dense<Kept<T, quantity::FirstMoment>>(),
                               inertia.template dense<Kept<T, quantity::RotationalInertia>>()};
  }
};
template <class M, class H, class J>
RigidInertia(M, H, J) -> RigidInertia<M, H, J>;

/// Two bodies of one frame as one.
template <class A, class B, class C, class D, class E, class F>
AXIAL_INLINE constexpr auto operator+(const RigidInertia<A, B, C>& a, const RigidInertia<D, E, F>& b) {
  return RigidInertia{a.mass + b.mass, a.first_moment + b.first_moment, a.inertia + b.inertia};
}

}  // namespace axial

#include <axial/options/end.hpp>
