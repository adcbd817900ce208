// Poses that a robot's author wrote down, as kernels over a scalar see them.
#pragma once

#include <axial/scalar/structural.hpp>
#include <axial/spatial/pose.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

template <class Scalar, int K, class Get>
AXIAL_INLINE constexpr auto constant_row(Get get) {
  return Vec3{literal<Scalar>([get] { return get().rotation[3 * K]; }),
              literal<Scalar>([get] { return get().rotation[3 * K + 1]; }),
              literal<Scalar>([get] { return get().rotation[3 * K + 2]; })};
}

/// A constant pose with its zeros and ones as types.
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
