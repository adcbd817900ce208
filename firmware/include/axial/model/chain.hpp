// A robot's chain: gravity, links, base and tool, checked while it compiles.
#pragma once

#include <axial/model/base_body.hpp>

namespace axial {

/// Acceleration of free fall in m/s^2, in axes of frame 0 (the fixed frame that the first link's MDH row starts from).
struct GravityVector {
  double x = 0.0, y = 0.0, z = -9.81;  ///< m/s^2 along an axis of frame 0
};
constexpr GravityVector gravity(double x, double y, double z) { return {x, y, z}; }  ///< m/s^2, axes of frame 0

/// A constant pose: rotation (row major, columns are the child's axes in the parent) and position in m.
struct FixedPose {
  double rotation[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< row major
  double position[3] = {0, 0, 0};                    ///< m
};

/// Pose of frame 0 in the user's world frame. Only poses and Jacobians see it.
struct Base {
  FixedPose pose;  ///< of frame 0, in the world
};
/// Pose of the tool in the last link's frame. Only poses and Jacobians see it.
struct Tool {
  FixedPose pose;  ///< in the last link's frame
};

/// The largest run-time payload: mass in kg, distance of its centre of mass from the origin of the last link's frame in
/// m, and inertia about that centre in kg m^2, which no entry of the tensor exceeds.
struct PayloadLimit {
  double mass = 0.0, com_reach = 0.0, inertia = 0.0;  ///< kg, m, kg m^2
  bool declared = false;                              ///< whether the robot declares one
};
/// Of a robot: kg, m, kg m^2.
constexpr PayloadLimit payload_limit(double mass, double com_reach, double inertia) {
  return {mass, com_reach, inertia, true};
}

/// The largest force (N) and moment (N m) that the environment exerts at the tip, about the origin of the last link's
/// frame: what fixed point leaves room for in scenes that name TipWrench.
struct TipWrenchLimit {
  double force = 0.0, moment = 0.0;  ///< N, N m
  bool declared = false;             ///< whether the robot declares one
};
constexpr TipWrenchLimit tip_wrench_limit(double force, double moment) { return {force, moment, true}; }  ///< N, N m

/// m, in the world; axes as the world's
constexpr Base base(double x, double y, double z) { return {{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {x, y, z}}}; }
constexpr Base base(const FixedPose& pose) { return {pose}; }  ///< in the world
/// m, in the last link's frame; axes as its
constexpr Tool tool(double x, double y, double z) { return {{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {x, y, z}}}; }
constexpr Tool tool(const FixedPose& pose) { return {pose}; }  ///< in the last link's frame

/// N links, from the base outwards: a link's parent has a smaller index.
template <int N>
struct Chain {
  static constexpr int size = N;      ///< number of links and of joints
  LinkParameters links[N] = {};       ///< from the base outwards
  GravityVector gravity{};            ///< m/s^2, axes of frame 0
  Base base{};                        ///< pose of frame 0 in the world
  Tool tool{};                        ///< pose of the tool in the last link's frame
  PayloadLimit payload_limit{};       ///< of a run-time payload
  TipWrenchLimit tip_wrench_limit{};  ///< of a run-time wrench at the tip
  LinkParameters base_body{};         ///< inertia of the body that is fixed to frame 0; only a FloatingBase sees it
  bool has_base_body = false;         ///< whether the robot declares one

  /// Index of the link that carries joint i, or LinkParameters::base.
  constexpr int parent(int i) const { return links[i].parent == LinkParameters::previous ? i - 1 : links[i].parent; }
};

namespace detail {

// Not constexpr: reaching it while a chain is built stops the compiler at the line that says what to mend.
inline void malformed_robot(const char*) {}

constexpr bool finite(double x) {
  return x >= -std::numeric_limits<double>::max() && x <= std::numeric_limits<double>::max();
}
constexpr bool finite(const double* values, int count) {
  for (int i = 0; i < count; ++i)
    if (!finite(values[i])) return false;
  return true;
}

constexpr void check_geometry(const LinkParameters& p, int index) {
  if (!finite(p.a) || !finite(p.d)) malformed_robot("axial: a or d of a link is not finite; give it in metres");
  if (!finite(p.alpha.radians) || !finite(p.theta.radians))
    malformed_robot(
        "axial: alpha or theta of a link is not finite; give radians, or degrees with alpha_deg and theta_deg");
  if (!finite(p.gamma.radians) || !finite(p.b))
    malformed_robot(
        "axial: gamma or b of a link's branch is not finite; give branch(radians, metres) or branch_deg(degrees, "
        "metres)");
  if (p.parent != LinkParameters::previous && (p.parent < LinkParameters::base || p.parent >= index))
    malformed_robot(
        "axial: parent() of a link must name an earlier link or LinkParameters::base; list links from the base "
        "outwards");
}

constexpr void check_inertia(const LinkParameters& p) {
  if (!finite(p.mass) || !finite(p.com, 3) || !finite(p.inertia_com, 6))
    malformed_robot("axial: mass, com or inertia of a link is not finite; give kg, m and kg m^2");
  if (p.mass < 0.0)
    malformed_robot("axial: the mass of a link is negative; give kg >= 0, a massless link has mass(0.0)");
  if (!finite(p.rotor_inertia) || !finite(p.gear))
    malformed_robot("axial: rotor_inertia of a link is not finite; give kg m^2 on the motor side and the gear ratio");
  if (p.rotor_inertia < 0.0)
    malformed_robot("axial: rotor_inertia of a link is negative; give kg m^2 >= 0 on the motor side");
}

constexpr void check_friction(const LinkParameters& p) {
  if (!finite(p.viscous) || !finite(p.coulomb_forward) || !finite(p.coulomb_backward))
    malformed_robot("axial: friction of a link is not finite; give viscous() and coulomb() on the joint side");
  if (p.viscous < 0.0)
    malformed_robot("axial: viscous friction of a link is negative and would feed energy in; give a value >= 0");
  if (p.coulomb_forward < 0.0 || p.coulomb_backward > 0.0)
    malformed_robot("axial: coulomb friction of a link feeds energy in; give coulomb(forward >= 0, backward <= 0)");
}

constexpr void check_stribeck(const LinkParameters& p) {
  constexpr double least_speed = 1e-9;  // its inverse square is still a float
  if (!finite(p.static_friction) || !finite(p.stribeck_speed) || !finite(p.smooth_speed))
    malformed_robot("axial: stribeck or smooth_speed of a link is not finite; give stribeck(static_effort, speed)");
  if (p.static_friction != 0.0 && (p.static_friction < p.coulomb_forward || p.static_friction < -p.coulomb_backward))
    malformed_robot(
        "axial: the static effort of stribeck() is below the Coulomb friction of the link; give the larger");
  if (p.static_friction != 0.0 && p.stribeck_speed < least_speed)
    malformed_robot("axial: the speed of stribeck() must be at least 1e-9 rad/s or m/s");
  if (p.smooth_speed != 0.0 && p.smooth_speed < least_speed)
    malformed_robot("axial: smooth_speed of a link must be at least 1e-9 rad/s or m/s; leave it out for a step");
}

constexpr void check_spring(const LinkParameters& p) {
  if (!finite(p.spring_stiffness) || !finite(p.spring_rest))
    malformed_robot("axial: spring of a link is not finite; give spring(stiffness, rest_position)");
}

constexpr void check_limits(const LinkParameters& p) {
  if (!(p.position_min < p.position_max))
    malformed_robot("axial: position_limits of a link are upside down; give position_limits(min, max) with min < max");
  if (!(p.speed_limit > 0.0)) malformed_robot("axial: speed_limit of a link must be > 0");
  if (!(p.acceleration_limit > 0.0)) malformed_robot("axial: acceleration_limit of a link must be > 0");
  if (!(p.effort_limit > 0.0)) malformed_robot("axial: effort_limit of a link must be > 0");
}

constexpr bool not_negative(const double* values, int count) {
  for (int i = 0; i < count; ++i)
    if (!(values[i] >= 0.0) || !finite(values[i])) return false;
  return true;
}

constexpr void check_water(const WaterParameters& w) {
  if (!not_negative(w.added_mass, 3) || !not_negative(w.added_inertia, 3))
    malformed_robot("axial: added_mass of a link must be finite and >= 0; give kg and kg m^2 along the link's axes");
  if (!not_negative(&w.displaced_mass, 1) || !finite(w.centre, 3))
    malformed_robot("axial: buoyancy of a link must be finite and >= 0; give buoyancy(kg of water, x, y, z)");
  if (!not_negative(w.drag_linear, 6) || !not_negative(w.drag_quadratic, 6))
    malformed_robot("axial: drag of a link is negative and would feed energy in; give finite values >= 0");
}

constexpr void check_link(const LinkParameters& p, int index) {
  check_geometry(p, index);
  check_inertia(p);
  check_friction(p);
  check_stribeck(p);
  check_spring(p);
  check_limits(p);
  check_water(p.water);
}

constexpr void check_pose(const FixedPose& pose) {
  if (!finite(pose.rotation, 9) || !finite(pose.position, 3))
    malformed_robot("axial: base or tool pose is not finite; give metres and a rotation matrix");
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      double dot = i == j ? -1.0 : 0.0;
      for (int k = 0; k < 3; ++k)
        dot += pose.rotation[3 * i + k] * pose.rotation[3 * j + k];
      if (dot > 1e-6 || dot < -1e-6)
        malformed_robot("axial: base or tool rotation is not orthonormal; give a rotation matrix, row major");
    }
}

template <class T>
inline constexpr bool is_link = std::is_same_v<T, Link>;
template <class T>
inline constexpr bool is_foreign_link = std::is_base_of_v<LinkBuilder<T>, T> && !is_link<T>;

template <int N>
struct ChainBuilder {
  Chain<N> chain{};
  int next = 0;

  constexpr void add(const Link& link) {
    check_link(link.parameters(), next);
    chain.links[next++] = link.parameters();
  }
  constexpr void add(const GravityVector& g) {
    if (!finite(g.x) || !finite(g.y) || !finite(g.z))
      malformed_robot("axial: gravity is not finite; give gravity(x, y, z) in m/s^2");
    chain.gravity = g;
  }
  constexpr void add(const Base& base) {
    check_pose(base.pose);
    chain.base = base;
  }
  constexpr void add(const Tool& tool) {
    check_pose(tool.pose);
    chain.tool = tool;
  }
  constexpr void add(const PayloadLimit& limit) {
    if (!finite(limit.mass) || !finite(limit.com_reach) || !finite(limit.inertia) || limit.mass < 0.0 ||
        limit.com_reach < 0.0 || limit.inertia < 0.0)
      malformed_robot("axial: payload_limit must be finite and >= 0; give payload_limit(kg, m, kg m^2)");
    chain.payload_limit = limit;
  }
  constexpr void add(const TipWrenchLimit& limit) {
    if (!finite(limit.force) || !finite(limit.moment) || limit.force < 0.0 || limit.moment < 0.0)
      malformed_robot("axial: tip_wrench_limit must be finite and >= 0; give tip_wrench_limit(N, N m)");
    chain.tip_wrench_limit = limit;
  }
  constexpr void add(const BaseBody& body) {
    check_link(body.parameters(), 0);
    chain.base_body = body.parameters();
    chain.has_base_body = true;
  }
};

}  // namespace detail

/// Builds a robot from links (from the base outwards) and, in any order, gravity(), base(), base_body(),
/// tool(), payload_limit() and tip_wrench_limit().
/// A malformed robot (not finite, negative mass, limits upside down, no link, ...) does not compile.
template <class... Parts>
constexpr auto chain(const Parts&... parts) {
  constexpr int count = (0 + ... + static_cast<int>(detail::is_link<Parts>));
  static_assert(!(false || ... || detail::is_foreign_link<Parts>),
                "axial: a link of chain() is revolute() or prismatic(), in MDH frames; classical links make a "
                "classical_chain()");
  static_assert(count > 0, "axial: a chain needs at least one link; add axial::revolute() or axial::prismatic()");
  detail::ChainBuilder<(count > 0 ? count : 1)> builder;
  (builder.add(parts), ...);
  return builder.chain;
}

}  // namespace axial
