// The tool as kinematics sees it: declared by the robot, or given at run time and checked.
#pragma once

#include <axial/links/links.hpp>
#include <axial/scalar/select.hpp>
#include <axial/scene/decisions.hpp>
#include <axial/scene/runtime_tool.hpp>

#include <axial/options/begin.hpp>

namespace axial {

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

/// Whether axes are a right-handed frame to a thousandth and the origin within a kilometre; NaN is neither.
template <class T>
constexpr Truth<T> is_pose(const Pose<Mat3<Vec3<T>>, Vec3<T>>& tool) {
  const auto& r = tool.rotation;
  const T off[] = {dot(r.x, r.x) - T(1), dot(r.y, r.y) - T(1), dot(r.z, r.z) - T(1),
                   dot(r.x, r.y),        dot(r.y, r.z),        dot(cross(r.x, r.y), r.z) - T(1)};
  const T allowed = T(1e-6), largest = T(1e6);
  T sum = T(0);
  for (const T& x : off)
    sum = sum + x * x;
  return (sum < allowed) & (dot(tool.position, tool.position) < largest);
}

/// input_limit where a run-time tool is no pose; words are judged with the other inputs, by what the robot declares.
template <class Answer, class Links, class Input>
AXIAL_INLINE constexpr void judge_tool(Answer& status, const Links&, const Input& in) {
  if constexpr (Links::Scene::template has<RuntimeTool>)
    if constexpr (is_number_v<std::decay_t<decltype(in.tool.position.x)>>)
      put_where(status, !is_pose(in.tool), Status::Code::input_limit);
}

}  // namespace kinematics
}  // namespace axial

#include <axial/options/end.hpp>
