// Poses in bounds: rows of a rotation are vectors in a link's frame, positions in the world are known by their norms.
#pragma once

#include <axial/fixed/balls/vector.hpp>
#include <axial/spatial/pose.hpp>

#include <axial/options/begin.hpp>

namespace axial::bounds {

/// A rotation by its rows.
using Rotation = Mat3<BoundedVector, BoundedVector, BoundedVector>;
/// A pose in the world.
using BoundedPose = Pose<Rotation, BoundedVector>;

namespace detail {
// A direction in the world of which each component is one of three rows' components, each off by `error` at most.
constexpr BoundedVector direction(const Rotation& r, double x, double y, double z) {
  const Ball any{1.0, hypotenuse(hypotenuse(x, y), z)};
  const bool literal = r.x.is_literal && r.y.is_literal && r.z.is_literal;
  return {{any, any, any}, r.x.exponent, literal, r.x.rounding};
}
constexpr BoundedVector anywhere(const Ball& norm, int exponent, const WordRounding* rounding) {
  return {{norm, norm, norm}, exponent, false, rounding};
}
}  // namespace detail

/// A constant pose of the model: directions and a point that are literals.
constexpr BoundedPose constant_pose(double offset, const WordRounding& r) {
  const SplitBall unit{{1.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}};
  const BoundedVector row{unit, r.bits - 2, true, &r};
  BoundedVector position = detail::anywhere({offset, 0.0}, 0, &r);
  position.is_literal = true;
  return {{row, row, row}, position};
}

/// A run-time pose: words, taken for what they say; its origin within `reach` (m), in the format of that.
constexpr BoundedPose given_pose(double reach, int exponent, const WordRounding& r) {
  BoundedPose pose = constant_pose(reach, r);
  for (BoundedVector* v : {&pose.rotation.x, &pose.rotation.y, &pose.rotation.z, &pose.position})
    v->is_literal = false;
  pose.position.exponent = exponent;
  return pose;
}

}  // namespace axial::bounds

#include <axial/options/end.hpp>
