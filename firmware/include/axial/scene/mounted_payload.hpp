// A payload as the tool holds it, for the last link, which carries it.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/scene/runtime_tool.hpp>
#include <axial/scene/scene.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A payload given in the frame of a tool, as in.payload takes it: in the last link's frame. `tool` is the tool's pose
/// there (in.tool of a scene with RuntimeTool). com becomes R com + p, the inertia R J R^T; exact to roundings. Fixed
/// point has its own, with a status (fixed/control/tool_border.hpp).
template <class T>
[[nodiscard]] constexpr PayloadBody<T> mounted_payload(const Pose<Mat3<Vec3<T>>, Vec3<T>>& tool,
                                                       const PayloadBody<T>& held) {
  const auto& j = held.inertia_com;
  const auto& r = tool.rotation;
  const Mat3<Vec3<T>> inertia{{j.xx, j.xy, j.xz}, {j.xy, j.yy, j.yz}, {j.xz, j.yz, j.zz}};
  const Vec3<T> x = inertia * r.x, y = inertia * r.y, z = inertia * r.z;  // columns of J R^T
  return {held.mass,
          r * held.com + tool.position,
          {dot(r.x, x), dot(r.y, y), dot(r.z, z), dot(r.x, y), dot(r.x, z), dot(r.y, z)}};
}
/// Overload for a payload given in the frame of the tool that the robot declares.
template <class S, class T>
[[nodiscard]] constexpr PayloadBody<T> mounted_payload(const PayloadBody<T>& held) {
  return mounted_payload(detail::DeclaredTool<robot_of<S>, T>::pose(), held);
}

}  // namespace axial

#include <axial/options/end.hpp>
