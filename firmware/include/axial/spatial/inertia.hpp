// Inertias about a frame's origin: of one rigid body, and of an articulated body. And the mass of a slide whose parent
// bears it across the slide's direction: accelerations along z alone meet it.
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
/// What such a slide carries has given its mass up, so that nothing else adds to it.
template <class M>
AXIAL_INLINE constexpr AxialMass<M> operator+(const AxialMass<M>& mass, Zero) {
  return mass;
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

/// Two bodies of one frame as one.
template <class A, class B, class C, class D, class E, class F>
AXIAL_INLINE constexpr auto operator+(const RigidInertia<A, B, C>& a, const RigidInertia<D, E, F>& b) {
  return RigidInertia{a.mass + b.mass, a.first_moment + b.first_moment, a.inertia + b.inertia};
}

/// Articulated-body or reflected inertia, 6x6 symmetric in 3x3 blocks: angular (kg m^2), coupling (kg m, row = moment,
/// column = linear acceleration) and linear (kg).
template <class A11, class A12, class A22>
struct ArticulatedInertia {
  A11 angular{};   ///< kg m^2, a Sym3
  A12 coupling{};  ///< kg m, a Mat3
  A22 linear{};    ///< kg, a Sym3

  /// Structural elements become numbers where the target has numbers.
  template <class A, class B, class C>
  AXIAL_INLINE constexpr operator ArticulatedInertia<A, B, C>() const {
    return {angular, coupling, linear};
  }  // NOLINT(google-explicit-constructor)
  /// This inertia as numbers, each quantity in the form in which T keeps it.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return axial::ArticulatedInertia{angular.template dense<Kept<T, quantity::RotationalInertia>>(),
                                     coupling.template dense<Kept<T, quantity::FirstMoment>>(),
                                     linear.template dense<Kept<T, quantity::Mass>>()};
  }
};
template <class A11, class A12, class A22>
ArticulatedInertia(A11, A12, A22) -> ArticulatedInertia<A11, A12, A22>;

/// Sum of inertias about the origin of one frame.
template <class A, class B, class C, class D, class E, class F>
AXIAL_INLINE constexpr auto operator+(const ArticulatedInertia<A, B, C>& a, const ArticulatedInertia<D, E, F>& b) {
  return ArticulatedInertia{a.angular + b.angular, a.coupling + b.coupling, a.linear + b.linear};
}

/// The 6x6 form of a rigid body's inertia.
template <class M, class H, class J>
AXIAL_INLINE constexpr auto articulated(const RigidInertia<M, H, J>& body) {
  const auto& h = body.first_moment;
  const Zero o{};
  return ArticulatedInertia{body.inertia, Mat3{Vec3{o, -h.z, h.y}, Vec3{h.z, o, -h.x}, Vec3{-h.y, h.x, o}},
                            Sym3{body.mass, body.mass, body.mass, o, o, o}};
}

}  // namespace axial

#include <axial/options/end.hpp>
