// Forward kinematics and the geometric Jacobian.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/recursion/joint_screws.hpp>
#include <axial/recursion/position_soundness.hpp>
#include <axial/recursion/tool_pose.hpp>
#include <axial/recursion/walks.hpp>
#include <axial/scene/joints.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A pose in the world as plain numbers.
template <class T>
using WorldPose = Pose<Mat3<Vec3<T>>, Vec3<T>>;

/// Poses in the world (m, rotation matrices): of every link's frame, and of the tool.
template <class S, class T>
struct ForwardKinematics {
  WorldPose<T> frames[link_count<S>];  ///< of every link
  WorldPose<T> tool;                   ///< of the tool
  StatusOf<T> status{};                ///< whether they are poses, see forward_kinematics()
};

/// Geometric Jacobian of the tool's origin: column j is the motion (angular; linear), in world axes, that a unit speed
/// of joint j gives the tool.
template <class S, class T>
struct Jacobian {
  MotionVector<Vec3<T>, Vec3<T>> columns[joint_count<S>];  ///< one per joint, from the base outwards
  StatusOf<T> status{};                                    ///< whether they are numbers, see forward_kinematics()
  /// Column of joint j; the index is not checked.
  AXIAL_INLINE constexpr auto& operator[](int j) { return columns[j]; }
  /// Column of joint j; the index is not checked.
  AXIAL_INLINE constexpr const auto& operator[](int j) const { return columns[j]; }
};

namespace kinematics {

/// Way from the parent's origin to the joint's axis in world axes, `rotation` being the parent's.
template <class Axis, class C, class S, class L, class Turn, class R>
AXIAL_INLINE constexpr auto way(const AxialScrew<Axis, C, S, L, Turn>& x, const R& rotation) {
  return x.shift * x_column(rotation);
}
/// Overload for a branch: the way across both of its screws.
template <class Z, class X, class R>
AXIAL_INLINE constexpr auto way(const BranchScrew<Z, X>& branch, const R& rotation) {
  auto row = [&](const auto& r) AXIAL_INLINE { return to_child(branch.z, r); };
  Mat3 turned{row(rotation.x), row(rotation.y), row(rotation.z)};
  return branch.z.shift * z_column(rotation) + way(branch.x, turned);
}

/// Pose of a link's frame from its parent's: Rx(alpha) Tx(a) Rz(theta) Tz(d), 24M+ for the axes, 6M 6A for the origin.
template <class Link, class Screw, class P>
AXIAL_INLINE constexpr auto place(const Link& link, const Screw& screw, const P& parent) {
  auto x = link.x();
  auto row = [&](const auto& r) AXIAL_INLINE { return to_child(screw, to_child(x, r)); };
  Mat3 rotation{row(parent.rotation.x), row(parent.rotation.y), row(parent.rotation.z)};
  return Pose{rotation,
              link.sum(quantity::Length{}, parent.position, way(x, parent.rotation), screw.shift * z_column(rotation))};
}

/// Poses of all links' frames in the world, each with its structural zeros.
template <class Links, class Input, class Q>
AXIAL_INLINE constexpr auto frames(const Links& links, const Input& in, const Q& q) {
  return outward(links, links.base_pose(), [&](auto i, const auto& parent) AXIAL_INLINE {
    auto link = links.link(i);
    return link.shape(place(link, joint_screw(links, in, q, i), parent));
  });
}

/// Status of an answer at q. The slides of a type tell whether something overflows; of a run-time model `numbers(i)` of
/// each link, and `more`, are looked at.
template <class Links, class Input, class Q, class Numbers, class... More>
AXIAL_INLINE constexpr auto status_at(const Links& links, const Input& in, const Q& q, const Numbers& numbers,
                                      const More&... more) {
  Soundness<typename Links::Scalar> all;
  detail::judge_positions(all, links, in, q);
  if constexpr (!detail::is_described<typename Links::Scene::Robot>) {
    for_each_link(links, [&](auto i) AXIAL_INLINE { detail::collect(all, numbers(i)); });
    (detail::collect(all, more), ...);
  }
  auto status = all.status();
  if constexpr (Links::Scene::template has<RuntimeTool> && is_number_v<typename Links::Scalar>) {
    Soundness<typename Links::Scalar> tool;  // what is not finite behind a tool that is none is the tool's fault
    detail::collect_tool<void>(tool, in.tool);
    put_where(status, tool.is_beyond(), Status::Code::input_limit);
  }
  return status;
}

/// Writes the poses of all frames and of the tool.
struct Poses {
  using Roles = axial::Roles<role::Position, role::None>;  ///< of its arguments
  /// the algorithm
  template <class Links, class Input, class Q, class Result>
  AXIAL_INLINE static constexpr void run(const Links& links, const Input& in, const Q& q, Result& result) {
    auto poses = frames(links, in, links.read(q));
    for_each_link(links, [&](auto i) AXIAL_INLINE { result.frames[i] = links.stored(poses[i]); });
    result.tool = links.stored(poses[links.last()] * tool_of(links, in));
    result.status = status_at(
        links, in, q, [&](auto i) { return result.frames[i].position; }, result.tool.position);
  }
};

/// Motion of a point at `arm` (m) from a revolute joint's axis, at 1 rad/s.
template <class Axis, class Arm>
AXIAL_INLINE constexpr auto column(Revolute, const Axis& axis, const Arm& arm) {
  return MotionVector{axis, cross(axis, arm)};
}
/// Motion of any point beyond a prismatic joint, at 1 m/s.
template <class Axis, class Arm>
AXIAL_INLINE constexpr auto column(Prismatic, const Axis& axis, const Arm&) {
  return MotionVector{ZeroVec3{}, axis};
}

/// Columns of the joints that carry link k, for a point of it in the world; the rest stay as they are.
template <class Links, class Poses, class K, class Point, class Result>
AXIAL_INLINE constexpr void columns(const Links& links, const Poses& poses, K k, const Point& point, Result& jacobian) {
  auto write = [&](auto i) AXIAL_INLINE {
    auto link = links.link(i);
    jacobian[i] = link.on_joint([&](auto joint) AXIAL_INLINE {
      auto arm = link.sum(quantity::Length{}, point, -poses[i].position);
      return links.stored(column(joint, z_column(poses[i].rotation), arm));
    });
  };
  write(k);
  for_each_ancestor(links, k, write);
}
/// Columns for the tool's origin.
struct ToolColumns {
  using Roles = axial::Roles<TwistByRate, role::Position>;  ///< of its arguments
  /// the algorithm
  template <class Links, class Input, class Result, class Q>
  AXIAL_INLINE static constexpr void run(const Links& links, const Input& in, Result& jacobian, const Q& q) {
    auto poses = frames(links, in, links.read(q));
    auto tool = poses[links.last()] * tool_of(links, in);
    columns(links, poses, links.last(), links.link(links.last()).sum(quantity::Length{}, tool.position), jacobian);
    jacobian.status = status_at(links, in, q, [&](auto i) { return jacobian[i]; });
  }
};
/// Columns for the origin of link k's frame.
struct LinkColumns {
  using Roles = axial::Roles<TwistByRate, role::Position, role::None>;  ///< of its arguments
  /// the algorithm
  template <class Links, class Input, class Result, class Q, class K>
  AXIAL_INLINE static constexpr void run(const Links& links, const Input& in, Result& jacobian, const Q& q, K k) {
    auto poses = frames(links, in, links.read(q));
    columns(links, poses, k, poses[k].position, jacobian);
    jacobian.status = status_at(links, in, q, [&](auto i) { return jacobian[i]; });
  }
};

}  // namespace kinematics

/// Poses of all frames and of the tool in the world. In: q (rad or m). Source: Craig 2005, eq. (3.6), as two screws.
/// The status, which costs nothing where nobody reads it: not_finite where a position is NaN or infinite or a slide so
/// far out (some 1e15 m in float) that something might overflow, angle_range where sines are not exact, about no joint.
/// In fixed point position_limit names the first slide beyond its limits, where formats wrap; input_limit,
/// payload_limit. input_limit: a run-time tool is no frame, or more than a kilometre away.
template <class S, class T>
[[nodiscard]] constexpr ForwardKinematics<robot_of<S>, T> forward_kinematics(
    const Positions<robot_of<S>, T>& q, const Inputs<S, T>& in = no_inputs<S, T>()) {
  ForwardKinematics<robot_of<S>, T> result{};
  execute<kinematics::Poses>(links_of<S, T, FullParameters, recursion::Kinematics>(), in, q, result);
  detail::PositionCheck<S, T>::name(result.status, in, q);
  return result;
}
/// Overload for a run-time model.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr ForwardKinematics<M, T> forward_kinematics(const Model<N, F...>& model,
                                                                   const Positions<M, T>& q,
                                                                   const Inputs<M, T>& in = no_inputs<M, T>()) {
  ForwardKinematics<M, T> result{};
  execute<kinematics::Poses>(model.template links<T>(), in, q, result);
  return result;
}

/// Geometric Jacobian of the tool (m and dimensionless), in world axes, angular part first.
/// Source: Craig 2005, chapter 5; column j is (z_j; z_j x (p_tool - p_j)), or (0; z_j) for a prismatic joint. The
/// status is that of forward_kinematics().
template <class S, class T>
[[nodiscard]] constexpr Jacobian<robot_of<S>, T> jacobian(const Positions<robot_of<S>, T>& q,
                                                          const Inputs<S, T>& in = no_inputs<S, T>()) {
  Jacobian<robot_of<S>, T> result{};
  execute<kinematics::ToolColumns>(links_of<S, T, FullParameters, recursion::Kinematics>(), in, result, q);
  detail::PositionCheck<S, T>::name(result.status, in, q);
  return result;
}
/// Jacobian for the origin of one link's frame, such as the other hand of a tree: jacobian<Robot, 3>(q).
template <class S, int Link, class T>
[[nodiscard]] constexpr Jacobian<robot_of<S>, T> jacobian(const Positions<robot_of<S>, T>& q,
                                                          const Inputs<S, T>& in = no_inputs<S, T>()) {
  constexpr bool there = Link >= 0 && Link < link_count<S>;
  static_assert(there, "axial: the robot has no such link; links are counted from 0, base outwards");
  Jacobian<robot_of<S>, T> result{};
  if constexpr (!there)
    return result;  // the message alone
  else if constexpr (scene_of<S>::template has<Looped>)
    execute<kinematics::LinkColumns>(links_of<S, T, FullParameters, recursion::Kinematics>(), in, result, q, Link);
  else
    execute<kinematics::LinkColumns>(links_of<S, T, FullParameters, recursion::Kinematics>(), in, result, q,
                                     Index<Link>{});
  detail::PositionCheck<S, T>::name(result.status, in, q);
  return result;
}
/// Overload for a run-time model.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr Jacobian<M, T> jacobian(const Model<N, F...>& model, const Positions<M, T>& q,
                                                const Inputs<M, T>& in = no_inputs<M, T>()) {
  Jacobian<M, T> result{};
  execute<kinematics::ToolColumns>(model.template links<T>(), in, result, q);
  return result;
}
/// Jacobian for the origin of a link's frame of a run-time model, 0 <= link < model.size().
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr Jacobian<M, T> jacobian(const Model<N, F...>& model, int link, const Positions<M, T>& q,
                                                const Inputs<M, T>& in = no_inputs<M, T>()) {
  Jacobian<M, T> result{};
  execute<kinematics::LinkColumns>(model.template links<T>(), in, result, q, link);
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
