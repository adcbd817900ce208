// Run-time inputs as kernels read them. A number system with formats overloads these for its own numbers.
#pragma once

#include <axial/scene/features.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A payload as a kernel over a scene and its Scalar computes with it.
template <class Scene, class Scalar, class T>
AXIAL_INLINE constexpr const PayloadBody<T>& read_payload(const PayloadBody<T>& load) {
  return load;
}
/// A wrench as a kernel over a scene and its Scalar computes with it.
template <class Scene, class Scalar, class T>
AXIAL_INLINE constexpr const ForceVector<Vec3<T>, Vec3<T>>& read_wrench(const ForceVector<Vec3<T>, Vec3<T>>& wrench) {
  return wrench;
}
/// A gravity vector as a kernel over a scene and its Scalar computes with it.
template <class Scene, class Scalar, class T>
AXIAL_INLINE constexpr const Vec3<T>& read_gravity(const Vec3<T>& g) {
  return g;
}
/// The sine and cosine of a joint's angle as a kernel over a scene and its Scalar computes with them.
template <class Scene, class Scalar, class T>
AXIAL_INLINE constexpr const SinCos<T>& read_turn(const SinCos<T>& turn) {
  return turn;
}

}  // namespace axial

#include <axial/options/end.hpp>
