// A tool that changes at run time, and a payload as a tool holds it, for the last link, which carries it.
#pragma once

#include <axial/scene/features.hpp>
#include <axial/scene/scene.hpp>
#include <axial/spatial/pose.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

/// The tool's pose in the last link's frame as numbers: what the robot declares; NaN for a run-time model. Number
/// systems with formats have their own.
template <class Robot, class T>
struct DeclaredTool {
  using PoseOf = Pose<Mat3<Vec3<T>>, Vec3<T>>;
  static constexpr PoseOf pose() { return of<Robot>(0); }

 private:
  template <class R>
  static constexpr auto of(int) -> decltype(R::chain.tool, PoseOf{}) {
    const auto& axes = R::chain.tool.pose.rotation;
    const auto& origin = R::chain.tool.pose.position;
    return {{row(axes), row(axes + 3), row(axes + 6)}, row(origin)};
  }
  template <class R>
  static constexpr PoseOf of(...) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    constexpr double none[3] = {unknown, unknown, unknown};
    return {{row(none), row(none), row(none)}, row(none)};
  }
  static constexpr Vec3<T> row(const double* x) {
    using N = NumberTraits<T>;
    return {N::constant(x[0]), N::constant(x[1]), N::constant(x[2])};
  }
};

}  // namespace detail

/// A tool that changes at run time: its pose in the last link's frame, input `tool`. Poses and Jacobians see it; what
/// it weighs is a payload (mounted_payload()). Starts as the robot declares it; for a run-time model as NaN. In fixed
/// point its words have the formats InputFormats::tool and sine_cosine, by the robot's tool_limit(reach).
struct RuntimeTool : Feature<RuntimeTool> {
  /// Run-time input of the feature.
  template <class Robot, class T>
  struct Input {
    Pose<Mat3<Vec3<T>>, Vec3<T>> tool = detail::DeclaredTool<Robot, T>::pose();  ///< m; axes as columns
  };
};

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
