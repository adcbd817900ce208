// What a chain is: links, gravity, base and tool, declared maxima. How a person writes one down is chain.hpp.
#pragma once

#include <axial/robot/link_parameters.hpp>

#include <axial/options/begin.hpp>

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
/// Payload limit of a robot: kg, m, kg m^2.
constexpr PayloadLimit payload_limit(double mass, double reach, double inertia) { return {mass, reach, inertia, true}; }

/// The largest force (N) and moment (N m) that the environment exerts at the tip, about the origin of the last link's
/// frame: what fixed point leaves room for in scenes that name TipWrench.
struct TipWrenchLimit {
  double force = 0.0, moment = 0.0;  ///< N, N m
  bool declared = false;             ///< whether the robot declares one
};
constexpr TipWrenchLimit tip_wrench_limit(double force, double moment) { return {force, moment, true}; }  ///< N, N m

/// The largest distance of a run-time tool's origin from that of the last link's frame.
struct ToolLimit {
  double reach = 0.0;     ///< m
  bool declared = false;  ///< whether the robot declares one
};
constexpr ToolLimit tool_limit(double reach) { return {reach, true}; }  ///< m

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
  bool says_gravity = true;           ///< whether it was declared, of what chain() built
  Base base{};                        ///< pose of frame 0 in the world
  Tool tool{};                        ///< pose of the tool in the last link's frame
  PayloadLimit payload_limit{};       ///< of a run-time payload
  TipWrenchLimit tip_wrench_limit{};  ///< of a run-time wrench at the tip
  ToolLimit tool_limit{};             ///< of a run-time tool
  LinkParameters base_body{};         ///< inertia of the body that is fixed to frame 0; only a FloatingBase sees it
  bool has_base_body = false;         ///< whether the robot declares one

  /// Index of the link that carries joint i, or LinkParameters::base.
  constexpr int parent(int i) const { return links[i].parent == LinkParameters::previous ? i - 1 : links[i].parent; }
  /// Whether some joint has other drives than one of its own, or some drive limits of its own.
  constexpr bool shares_drives() const {
    for (const LinkParameters& link : links)
      if (link.drives.count > 0 || link.drives.complete || link.has_drive_limits()) return true;
    return false;
  }
};

}  // namespace axial

#include <axial/options/end.hpp>
