// The tool as kinematics sees it: declared by the robot, or given at run time.
#pragma once

#include <axial/links/links.hpp>
#include <axial/scene/runtime_tool.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A constant pose as plain numbers.
template <class T>
AXIAL_INLINE constexpr auto pose_of(const FixedPose& p) {
  using N = NumberTraits<T>;
  const auto& r = p.rotation;
  return Pose<Mat3<Vec3<T>>, Vec3<T>>{
      {{N::constant(r[0]), N::constant(r[1]), N::constant(r[2])},
       {N::constant(r[3]), N::constant(r[4]), N::constant(r[5])},
       {N::constant(r[6]), N::constant(r[7]), N::constant(r[8])}},
      {N::constant(p.position[0]), N::constant(p.position[1]), N::constant(p.position[2])}};
}

/// A tool's pose as a kernel over a scene and its Scalar computes with it.
template <class Scene, class Scalar, class T>
AXIAL_INLINE constexpr const Pose<Mat3<Vec3<T>>, Vec3<T>>& read_tool(const Pose<Mat3<Vec3<T>>, Vec3<T>>& tool) {
  return tool;
}

namespace kinematics {

/// Pose of the tool in the last link's frame.
template <class Links, class Input>
AXIAL_INLINE constexpr auto tool_of(const Links& links, const Input& in) {
  if constexpr (Links::Scene::template has<RuntimeTool>)
    return read_tool<typename Links::Scene, typename Links::Scalar>(in.tool);
  else
    return links.tool_pose();
}

}  // namespace kinematics
}  // namespace axial

#include <axial/options/end.hpp>
