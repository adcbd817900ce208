// The z-screws of all joints: the only place where an algorithm looks at q.
#pragma once

#include <axial/links/run_time_model.hpp>
#include <axial/recursion/passes.hpp>
#include <axial/scalar/sincos.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// z-screw of joint i at q (rad or m): one sine-cosine pair for a revolute joint; none where the scene names
/// SineCosines and hands it in.
template <class Links, class Input, class Q, class I>
AXIAL_INLINE constexpr auto joint_screw(const Links& links, const Input& in, const Q& q, I i) {
  if constexpr (Links::Scene::template has<SineCosines>)
    return links.link(i).z(q[i], read_turn<typename Links::Scene, typename Links::Scalar>(in.turns[i]));
  else
    return links.link(i).z(q[i]);
}

namespace detail {

template <class Links>
constexpr int revolute_joints() {
  int count = 0;
  if constexpr (Links::unrolled)
    for (const auto& link : Links::Scene::Robot::chain.links)
      count += link.type == JointType::revolute ? 1 : 0;
  return count;
}

// Each revolute joint's place among the angles of packed_screws.
template <class Links>
constexpr int angles_before(int joint) {
  int count = 0;
  for (int i = 0; i < joint; ++i)
    count += Links::Scene::Robot::chain.links[i].type == JointType::revolute ? 1 : 0;
  return count;
}

template <class Links, class Q>
AXIAL_INLINE constexpr auto packed_screws(const Links& links, const Q& q) {
  using T = typename Links::Scalar;
  T angles[revolute_joints<Links>()] = {};
  SinCos<T> pairs[revolute_joints<Links>()] = {};
  for_each_link(links, [&](auto i) AXIAL_INLINE {
    if constexpr (Links::Scene::Robot::chain.links[i].type == JointType::revolute)
      angles[angles_before<Links>(i)] = q[i];
  });
  sincos(angles, pairs);
  return map_links(links, [&](auto i) AXIAL_INLINE {
    if constexpr (Links::Scene::Robot::chain.links[i].type == JointType::revolute)
      return links.link(i).z(q[i], pairs[angles_before<Links>(i)]);
    else
      return links.link(i).z(q[i]);
  });
}

}  // namespace detail

/// z-screws of all joints, shared by all that follows.
template <class Links, class Input, class Q>
AXIAL_INLINE constexpr auto joint_screws(const Links& links, const Input& in, const Q& q) {
  static_cast<void>(Walkable<Links>{});
  if constexpr (packing_pays<typename Links::Scalar>(detail::revolute_joints<Links>()) &&
                !Links::Scene::template has<SineCosines>)
    return detail::packed_screws(links, q);
  else
    return map_links(links, [&](auto i) AXIAL_INLINE { return joint_screw(links, in, q, i); });
}

namespace detail {
template <class Links, class Q, class Turns>
AXIAL_INLINE constexpr void fill_turns(const Links& links, const Q& q, Turns& turns) {
  if constexpr (!is_refused<Links>) {
    using T = typename Links::Scalar;
    for_each_link(links, [&](auto i) AXIAL_INLINE {
      turns[i] = links.link(i).on_joint([&](auto joint) AXIAL_INLINE {
        if constexpr (std::is_same_v<decltype(joint), Revolute>)
          return sincos(T(q[i]));
        else
          return SinCos<T>{T(Zero{}), T(One{})};
      });
    });
  }
}
/// How sine_cosines() finds the pairs of a scene's joints; a number system may have its own way.
template <class S, class T>
struct PairsOf {
  AXIAL_INLINE static constexpr void fill(const Positions<robot_of<S>, T>& q, Joints<robot_of<S>, SinCos<T>>& turns) {
    fill_turns(links_of<S, T>(), q, turns);
  }
};
}  // namespace detail

/// Sine and cosine of every revolute joint's position (rad), for the input `turns` of scenes that name SineCosines:
/// computed once, shared by several algorithms. A prismatic joint's pair is that of 0, and ignored.
template <class S, class T>
[[nodiscard]] constexpr Joints<robot_of<S>, SinCos<T>> sine_cosines(const Positions<robot_of<S>, T>& q) {
  Joints<robot_of<S>, SinCos<T>> turns{};
  detail::PairsOf<S, T>::fill(q, turns);
  return turns;
}
/// Overload for a run-time model.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr Joints<M, SinCos<T>> sine_cosines(const Model<N, F...>& model, const Positions<M, T>& q) {
  Joints<M, SinCos<T>> turns{};
  static_cast<void>(sizeof(Inputs<M, T>));  // which say what they refuse
  detail::fill_turns(model.template links<T>(), q, turns);
  return turns;
}

}  // namespace axial

#include <axial/options/end.hpp>
