// 3x3 matrices, general and symmetric, with one type an element.
#pragma once

#include <axial/spatial/vec3.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A general 3x3 matrix, rows of Vec3.
template <class R1, class R2 = R1, class R3 = R1>
struct Mat3 {
  R1 x{};  ///< first row
  R2 y{};  ///< second row
  R3 z{};  ///< third row

  /// Structural elements become numbers where the target has numbers.
  template <class A, class B, class C>
  AXIAL_INLINE constexpr operator Mat3<A, B, C>() const {
    return {x, y, z};
  }  // NOLINT(google-explicit-constructor)
  /// This matrix as plain numbers.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return axial::Mat3{x.template dense<T>(), y.template dense<T>(), z.template dense<T>()};
  }
};
template <class R1, class R2, class R3>
Mat3(R1, R2, R3) -> Mat3<R1, R2, R3>;

/// A symmetric 3x3 matrix, six elements.
template <class XX, class YY = XX, class ZZ = XX, class XY = XX, class XZ = XX, class YZ = XX>
struct Sym3 {
  /// Element: row and column by name, one of each pair of equal ones.
  ///@{
  XX xx{};
  YY yy{};
  ZZ zz{};
  XY xy{};
  XZ xz{};
  YZ yz{};
  ///@}

  /// Structural elements become numbers where the target has numbers.
  template <class A, class B, class C, class D, class E, class F>
  AXIAL_INLINE constexpr operator Sym3<A, B, C, D, E, F>() const {
    return {xx, yy, zz, xy, xz, yz};
  }  // NOLINT(google-explicit-constructor)
  /// This matrix as plain numbers.
  template <class T>
  AXIAL_INLINE constexpr Sym3<T> dense() const {
    using N = Holding<T>;
    return {N::of(xx), N::of(yy), N::of(zz), N::of(xy), N::of(xz), N::of(yz)};
  }
};
template <class A, class B, class C, class D, class E, class F>
Sym3(A, B, C, D, E, F) -> Sym3<A, B, C, D, E, F>;

/// Matrix times vector.
template <class A, class B, class C, class V>
AXIAL_INLINE constexpr auto operator*(const Mat3<A, B, C>& m, const V& v)
    -> decltype(Vec3{dot(m.x, v), dot(m.y, v), dot(m.z, v)}) {
  return Vec3{dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}
/// Sum, element by element.
template <class A, class B, class C, class D, class E, class F>
AXIAL_INLINE constexpr auto operator+(const Mat3<A, B, C>& m, const Mat3<D, E, F>& n) {
  return Mat3{m.x + n.x, m.y + n.y, m.z + n.z};
}

/// Symmetric matrix times vector.
template <class A, class B, class C, class D, class E, class F, class X, class Y, class Z>
AXIAL_INLINE constexpr auto operator*(const Sym3<A, B, C, D, E, F>& s, const Vec3<X, Y, Z>& v) {
  return Vec3{s.xx * v.x + s.xy * v.y + s.xz * v.z, s.xy * v.x + s.yy * v.y + s.yz * v.z,
              s.xz * v.x + s.yz * v.y + s.zz * v.z};
}
/// Sum, element by element.
template <class A, class B, class C, class D, class E, class F, class G, class H, class I, class J, class K, class L>
AXIAL_INLINE constexpr auto operator+(const Sym3<A, B, C, D, E, F>& s, const Sym3<G, H, I, J, K, L>& t) {
  return Sym3{s.xx + t.xx, s.yy + t.yy, s.zz + t.zz, s.xy + t.xy, s.xz + t.xz, s.yz + t.yz};
}

/// Transpose of m times v.
template <class A, class B, class C, class V>
AXIAL_INLINE constexpr auto transpose_times(const Mat3<A, B, C>& m, const V& v) {
  return Vec3{m.x.x * v.x + m.y.x * v.y + m.z.x * v.z, m.x.y * v.x + m.y.y * v.y + m.z.y * v.z,
              m.x.z * v.x + m.y.z * v.y + m.z.z * v.z};
}

}  // namespace axial

#include <axial/options/end.hpp>
