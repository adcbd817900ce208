// The inertia of an articulated body about a frame's origin.
#pragma once

#include <axial/spatial/inertia.hpp>

#include <axial/options/begin.hpp>

namespace axial {

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
