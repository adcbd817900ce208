// Poses of frames.
#pragma once

#include <axial/scalar/rounding.hpp>
#include <axial/scalar/structural.hpp>
#include <axial/spatial/mat3.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Pose of a frame in the one that the context names: its axes as columns of `rotation` and its origin `position` (m).
template <class R, class P>
struct Pose {
  R rotation{};  ///< axes of the frame as columns
  P position{};  ///< m, origin of the frame

  /// Structural elements become numbers where the target has numbers.
  template <class A, class B>
  AXIAL_INLINE constexpr operator Pose<A, B>() const {
    return {rotation, position};
  }  // NOLINT(google-explicit-constructor)
  /// This pose as numbers, each quantity in the form in which T keeps it.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return axial::Pose{rotation.template dense<Kept<T, quantity::Turn>>(),
                       position.template dense<Kept<T, quantity::Length>>()};
  }
};
template <class R, class P>
Pose(R, P) -> Pose<R, P>;

/// Column z of a matrix: the axis of a joint, in the axes of the frame that the pose is given in.
template <class A, class B, class C>
AXIAL_INLINE constexpr auto z_column(const Mat3<A, B, C>& m) {
  return Vec3{m.x.z, m.y.z, m.z.z};
}
/// Column x of a matrix.
template <class A, class B, class C>
AXIAL_INLINE constexpr auto x_column(const Mat3<A, B, C>& m) {
  return Vec3{m.x.x, m.y.x, m.z.x};
}

/// Pose of C in A from the poses of B in A and of C in B.
template <class R, class P, class S, class Q>
AXIAL_INLINE constexpr auto operator*(const Pose<R, P>& ab, const Pose<S, Q>& bc) {
  auto row = [&](const auto& r) { return transpose_times(bc.rotation, r); };
  return Pose{Mat3{row(ab.rotation.x), row(ab.rotation.y), row(ab.rotation.z)},
              ab.position + ab.rotation * bc.position};
}

namespace detail {

template <class Scalar, int K, class Get>
AXIAL_INLINE constexpr auto constant_row(Get get) {
  return Vec3{literal<Scalar>([get] { return get().rotation[3 * K]; }),
              literal<Scalar>([get] { return get().rotation[3 * K + 1]; }),
              literal<Scalar>([get] { return get().rotation[3 * K + 2]; })};
}

/// A pose that a robot's author wrote down, with its zeros and ones as types.
template <class Scalar, class Get>
AXIAL_INLINE constexpr auto constant_pose(Get get) {
  return Pose{
      Mat3{constant_row<Scalar, 0>(get), constant_row<Scalar, 1>(get), constant_row<Scalar, 2>(get)},
      Vec3{literal<Scalar>([get] { return get().position[0]; }), literal<Scalar>([get] { return get().position[1]; }),
           literal<Scalar>([get] { return get().position[2]; })}};
}

}  // namespace detail

}  // namespace axial

#include <axial/options/end.hpp>
