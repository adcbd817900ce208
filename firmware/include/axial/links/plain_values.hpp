// How kernels over plain numbers read and write joint values and read run-time inputs: as they are. A number system
// with formats overloads the reading of inputs for its own numbers.
#pragma once

#include <axial/scene/features.hpp>
#include <axial/scene/joints.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Joint values, poses and motions over numbers T that carry their own scale. Links of such numbers inherit it; links
/// of a number system with formats have the same members.
template <class SceneType, class T>
struct PlainValues {
  /// Joint values as kernels index them.
  template <class Values>
  AXIAL_INLINE static constexpr const Values& read(const Values& values) {
    return values;
  }
  /// Efforts to fill, all 0.
  AXIAL_INLINE static constexpr auto no_efforts() { return EffortsOf<SceneType, T>{}; }
  /// values[i] = x, in the format of the values.
  template <class Values, class I, class X>
  AXIAL_INLINE static constexpr void write(Values& values, I i, const X& x) {
    values[i] = static_cast<T>(x);
  }
  /// values[i] = x where a format may be too small for x: then the largest value that fits, and `lost` is set.
  template <class Values, class I, class X, class Lost>
  AXIAL_INLINE static constexpr void write_limited(Values& values, I i, const X& x, Lost&) {
    write(values, i, x);
  }
  /// values[i] = x - y, rounded once.
  template <class Values, class I, class X, class Y>
  AXIAL_INLINE static constexpr void write_difference(Values& values, I i, const X& x, const Y& y) {
    write(values, i, x - y);
  }
  /// A pose, or a motion, as results of kinematics hold it.
  template <class V>
  AXIAL_INLINE static constexpr auto stored(const V& v) {
    return v.template dense<T>();
  }
};

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
