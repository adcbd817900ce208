// Which of the three forms of forward dynamics a scene takes, decided by the compiler.
#pragma once

#include <axial/dynamics/reach.hpp>

namespace axial {

/// Ways from efforts to accelerations. All take the same arguments and agree to rounding.
enum class Route {
  articulated_body,        ///< ABA: linear in N; its error does not grow with the condition number of M
  split_articulated_body,  ///< bias torque, then ABA of the structure at rest
  composite_body,          ///< bias torque, M(q), elimination: the cheapest for short arms
};

namespace detail {

/// Operations of both forms, fitted to our own counts of chains of 2 to 16 joints (doc/counts.md): ABA is linear; with
/// composite bodies each joint's force climbs to the base, `depth` joints, and is eliminated on the way. A joint
/// parallel to the one before costs a fraction, the joints on the base nothing that differs.
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
template <class Robot>
constexpr RouteCost route_cost() {
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

// How far a prismatic joint moves its link, as far as its limits say.
constexpr double travel(const LinkParameters& link) {
  const double down = magnitude(link.position_min), up = magnitude(link.position_max);
  const double far = down > up ? down : up;
  return link.type == JointType::prismatic && far < LinkParameters::unlimited ? far : 0.0;
}

/// Largest ratio of a bound of the composite inertia about a joint to what its own link and rotor alone resist with:
/// the elimination loses at most the logarithm of that (the articulated inertia lies between the two). Infinite for
/// massless links.
template <class S>
constexpr double elimination_loss() {
  using Scene = scene_of<S>;
  using Robot = typename Scene::Robot;
  constexpr int n = Robot::chain.size;
  Reach<double, double, double> carried[n] = {};
  double worst = 1.0;
  for (int i = n; i-- > 0;) {
    const auto& c = robot_constants<Robot>.links[i];
    const double rotor = Scene::template has<RotorInertia> ? c.rotor : 0.0;
    const Vec3<double> h{c.hx, c.hy, c.hz};
    carried[i] = carried[i] + reach(RigidInertia{c.mass, h, Sym3<double>{c.jxx, c.jyy, c.jzz, 0.0, 0.0, 0.0}});
    const double own = (c.prismatic ? c.mass : c.jzz) + rotor;
    const double all = (c.prismatic ? carried[i].mass : 0.5 * carried[i].polar) + rotor;
    worst = all > worst * own ? (own > 0.0 ? all / own : 1e300) : worst;
    if (c.parent >= 0)
      carried[c.parent] = carried[c.parent] + seen_from(carried[i], magnitude(c.branch.b) + magnitude(c.a) +
                                                                        magnitude(c.d) + travel(Robot::chain.links[i]));
  }
  return worst;
}

template <class Scene>
constexpr Route chosen_route() {
  if (Scene::template has<ArticulatedBody>) return Route::articulated_body;
  if (Scene::template has<FloatingBase>) return Route::articulated_body;
  if (Scene::template has<SplitArticulatedBody>) return Route::split_articulated_body;
  if (Scene::template has<CompositeBody>) return Route::composite_body;
  if (Scene::template has<Underwater>) return Route::articulated_body;  // composites with added mass are 6x6 too
  constexpr double ten_bits = 1024.0;
  constexpr auto cost = route_cost<typename Scene::Robot>();
  return cost.composite < cost.articulated && elimination_loss<Scene>() <= ten_bits ? Route::composite_body
                                                                                    : Route::articulated_body;
}

}  // namespace detail

/// The form that `forward_dynamics<S>` takes: the one that the scene names (ArticulatedBody, SplitArticulatedBody,
/// CompositeBody), else composite bodies where they are cheaper and the elimination can lose at most ten bits, else
/// ABA. A floating base, an underwater scene and a run-time Model take ABA.
template <class S>
inline constexpr Route forward_dynamics_route = detail::chosen_route<scene_of<S>>();
}  // namespace axial
