// Vectors of three elements, each of its own type, so that a known zero costs nothing.
#pragma once

#include <axial/scalar/structural.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A Cartesian vector. Elements are numbers or structural scalars.
template <class X, class Y = X, class Z = X>
struct Vec3 {
  /// Element along an axis of the frame that the context names.
  ///@{
  X x{};
  Y y{};
  Z z{};
  ///@}

  /// Structural elements become numbers where the target has numbers.
  template <class A, class B, class C>
  AXIAL_INLINE constexpr operator Vec3<A, B, C>() const {
    return {x, y, z};
  }  // NOLINT(google-explicit-constructor): zeros become numbers
  /// This vector as plain numbers.
  template <class T>
  AXIAL_INLINE constexpr Vec3<T, T, T> dense() const {
    return {Holding<T>::of(x), Holding<T>::of(y), Holding<T>::of(z)};
  }
};
template <class X, class Y, class Z>
Vec3(X, Y, Z) -> Vec3<X, Y, Z>;

/// True for a vector whose elements the type system knows.
template <class V>
inline constexpr bool is_structural_vector = false;
/// True where all three elements are structural.
template <class X, class Y, class Z>
inline constexpr bool is_structural_vector<Vec3<X, Y, Z>> =
    is_structural_v<X>&& is_structural_v<Y>&& is_structural_v<Z>;

using ZeroVec3 = Vec3<Zero, Zero, Zero>;  ///< the zero vector, known to the type system

/// Sum, element by element; a structural zero adds nothing.
template <class A, class B, class C, class D, class E, class F>
AXIAL_INLINE constexpr auto operator+(const Vec3<A, B, C>& u, const Vec3<D, E, F>& v) {
  return Vec3{u.x + v.x, u.y + v.y, u.z + v.z};
}
/// Difference, element by element.
template <class A, class B, class C, class D, class E, class F>
AXIAL_INLINE constexpr auto operator-(const Vec3<A, B, C>& u, const Vec3<D, E, F>& v) {
  return Vec3{u.x - v.x, u.y - v.y, u.z - v.z};
}
/// The opposite vector.
template <class A, class B, class C>
AXIAL_INLINE constexpr auto operator-(const Vec3<A, B, C>& v) {
  return Vec3{-v.x, -v.y, -v.z};
}
/// A multiple of a vector; s is a number or a structural scalar.
template <class S, class A, class B, class C, std::enable_if_t<is_scalar_v<S>, int> = 0>
AXIAL_INLINE constexpr auto operator*(const S& s, const Vec3<A, B, C>& v) {
  return Vec3{s * v.x, s * v.y, s * v.z};
}

/// Scalar product.
template <class A, class B, class C, class D, class E, class F>
AXIAL_INLINE constexpr auto dot(const Vec3<A, B, C>& u, const Vec3<D, E, F>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
/// Cross product u x v.
template <class A, class B, class C, class D, class E, class F>
AXIAL_INLINE constexpr auto cross(const Vec3<A, B, C>& u, const Vec3<D, E, F>& v) {
  return Vec3{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// The vector (0, 0, s): a quantity about or along the joint axis.
template <class S>
AXIAL_INLINE constexpr auto along_z(const S& s) {
  return Vec3{Zero{}, Zero{}, s};
}
/// v x z s, the cross product with a multiple of the joint axis.
template <class A, class B, class C, class S>
AXIAL_INLINE constexpr auto cross_z(const Vec3<A, B, C>& v, const S& s) {
  return Vec3{v.y * s, -(v.x * s), Zero{}};
}

}  // namespace axial

#include <axial/options/end.hpp>
