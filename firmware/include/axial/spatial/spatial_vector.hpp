// Spatial vectors, angular part first.
#pragma once

#include <axial/scalar/rounding.hpp>
#include <axial/spatial/vec3.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A motion: angular (rad/s or rad/s^2) and linear (m/s or m/s^2) part, both in the axes and at the origin of one
/// frame. Accelerations are classical ones: the linear part is that of the point, not Featherstone's spatial
/// acceleration.
template <class W, class V>
struct MotionVector {
  W angular{};  ///< rad/s or rad/s^2
  V linear{};   ///< m/s or m/s^2

  /// Structural elements become numbers where the target has numbers.
  template <class A, class B>
  AXIAL_INLINE constexpr operator MotionVector<A, B>() const {
    return {angular, linear};
  }  // NOLINT(google-explicit-constructor)
  /// This motion as numbers, each in the form in which T keeps it: an acceleration where T tells quantities apart.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return axial::MotionVector{angular.template dense<Kept<T, quantity::AngularAcceleration>>(),
                               linear.template dense<Kept<T, quantity::LinearAcceleration>>()};
  }
};
template <class W, class V>
MotionVector(W, V) -> MotionVector<W, V>;

/// A force: moment (N m) about the origin of a frame and force (N), in its axes.
template <class N, class F>
struct ForceVector {
  N moment{};  ///< N m, about the frame's origin
  F force{};   ///< N

  /// Structural elements become numbers where the target has numbers.
  template <class A, class B>
  AXIAL_INLINE constexpr operator ForceVector<A, B>() const {
    return {moment, force};
  }  // NOLINT(google-explicit-constructor)
  /// This force as numbers, each quantity in the form in which T keeps it.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return axial::ForceVector{moment.template dense<Kept<T, quantity::Moment>>(),
                              force.template dense<Kept<T, quantity::Force>>()};
  }
};
template <class N, class F>
ForceVector(N, F) -> ForceVector<N, F>;

/// Sum of motions in the same frame.
template <class A, class B, class C, class D>
AXIAL_INLINE constexpr auto operator+(const MotionVector<A, B>& u, const MotionVector<C, D>& v) {
  return MotionVector{u.angular + v.angular, u.linear + v.linear};
}
/// Sum of forces in the same frame.
template <class A, class B, class C, class D>
AXIAL_INLINE constexpr auto operator+(const ForceVector<A, B>& u, const ForceVector<C, D>& v) {
  return ForceVector{u.moment + v.moment, u.force + v.force};
}
/// Difference of forces in the same frame.
template <class A, class B, class C, class D>
AXIAL_INLINE constexpr auto operator-(const ForceVector<A, B>& u, const ForceVector<C, D>& v) {
  return ForceVector{u.moment - v.moment, u.force - v.force};
}

}  // namespace axial

#include <axial/options/end.hpp>
