// Which of the three forms of forward dynamics a scene takes, decided by the compiler.
#pragma once

#include <axial/dynamics/elimination_loss.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Ways from efforts to accelerations. All take the same arguments and agree to rounding.
enum class Route {
  articulated_body,        ///< ABA: linear in N; its error does not grow with the condition number of M
  split_articulated_body,  ///< bias torque, then ABA of the structure at rest
  composite_body,          ///< bias torque, M(q), elimination: the cheapest for short arms
};

namespace detail {

/// Operations of both forms, fitted to our own counts of chains of 2 to 16 joints (doc/measurements/counts.md): ABA is
/// linear; with composite bodies each joint's force climbs to the base, `depth` joints, and is eliminated on the way. A
/// joint parallel to the one before costs a fraction, the joints on the base nothing that differs.
struct RouteCost {
  int articulated = 0;
  int composite = 0;
};
/// What a branch adds (tests/unit/dynamics/tree_counts_test.cpp); with composite bodies each joint outboard crosses it.
constexpr RouteCost branch_cost(const TreeLinkConstants<double>& link) {
  const bool turned = link.branch.sin_gamma != 0.0 && link.branch.cos_gamma != 0.0;
  const bool shifted = link.branch.b != 0.0;
  return turned ? RouteCost{134, 77} : shifted ? RouteCost{38, 25} : RouteCost{};
}
constexpr int crossing_cost(const TreeLinkConstants<double>& link) {
  const bool turned = link.branch.sin_gamma != 0.0 && link.branch.cos_gamma != 0.0;
  return turned ? 16 : link.branch.b != 0.0 ? 4 : 0;
}
/// Cost of loops over a table, in nanoseconds per joint of general twist on a host: ABA took 135 to 145, composite
/// bodies 75 and 10 more for each joint on the way to the base, which made them the faster ones up to 12 joints.
template <class Robot>
constexpr RouteCost looped_cost() {
  RouteCost cost;
  for (int i = 0; i < Robot::chain.size; ++i) {
    int depth = 0;
    for (int j = i; Robot::chain.parent(j) >= 0; j = Robot::chain.parent(j))
      ++depth;
    cost.articulated += 135, cost.composite += 75 + 10 * depth;
  }
  return cost;
}
template <class Robot>
constexpr RouteCost unrolled_cost() {
  RouteCost cost;
  for (int i = 0; i < Robot::chain.size; ++i) {
    int depth = 0, crossings = 0;
    for (int j = i; Robot::chain.parent(j) >= 0; j = Robot::chain.parent(j))
      ++depth, crossings += crossing_cost(robot_constants<Robot>.links[j]);
    if (depth == 0) continue;
    const bool parallel = robot_constants<Robot>.links[i].sin_alpha == 0.0;
    const auto branch = branch_cost(robot_constants<Robot>.links[i]);
    cost.articulated += (parallel ? 80 : 390) + branch.articulated;
    cost.composite +=
        (parallel ? 32 + depth * (15 + depth) : 220 + depth * (23 + 2 * depth)) + branch.composite + crossings;
  }
  return cost;
}

template <class Scene>
constexpr Route chosen_route() {
  if constexpr (Scene::template has<ArticulatedBody> || Scene::template has<FloatingBase>) {
    return Route::articulated_body;
  } else if constexpr (Scene::template has<SplitArticulatedBody>) {
    return Route::split_articulated_body;
  } else if constexpr (Scene::template has<CompositeBody> || Scene::template has<RotorDynamics>) {
    return Route::composite_body;
  } else if constexpr (Scene::template has<Underwater>) {
    return Route::articulated_body;  // composites with added mass are 6x6 too
  } else {
    using Robot = typename Scene::Robot;
    constexpr auto cost = Scene::template has<Looped> ? looped_cost<Robot>() : unrolled_cost<Robot>();
    if constexpr (cost.composite < cost.articulated)
      return elimination_loses_little<Scene> ? Route::composite_body : Route::articulated_body;
    else
      return Route::articulated_body;
  }
}

/// Route of a scene; couplings have one of their own.
template <class Scene>
inline constexpr Route scene_route = chosen_route<Scene>();

}  // namespace detail

/// The form that `forward_dynamics<S>` takes: the one that the scene names (ArticulatedBody, SplitArticulatedBody,
/// CompositeBody), else composite bodies where they are cheaper and the elimination loses little over the whole chain
/// or tree (elimination_loss.hpp), else ABA. A floating base, an underwater scene and a run-time Model take ABA. Where
/// joints share drives, ABA is its split form over clusters (clustered_dynamics.hpp).
template <class S>
inline constexpr Route forward_dynamics_route = detail::scene_route<scene_of<S>>;
}  // namespace axial

#include <axial/options/end.hpp>
