// The two sets of coordinates of a robot whose joints share drives, as robots of their own.
#pragma once

#include <axial/robot/drive_matrix.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A robot's joints as if each had a drive of its own, without rotors: what kernels compute with inside, and a robot
/// that one may name where joints are meant, not drives: `inverse_dynamics<JointCoordinates<Palletiser>>(q, qd, qdd)`.
template <class R>
struct JointCoordinates {
  /// Chain of the tree.
  static constexpr auto chain = [] {
    auto joints = R::chain;
    for (LinkParameters& link : joints.links) {
      link.drives = {}, link.rotor_inertia = link.viscous = link.coulomb_forward = link.coulomb_backward = 0.0;
      link.static_friction = link.stribeck_speed = link.smooth_speed = 0.0;
      link.effort_limit = link.drive_max = LinkParameters::unlimited, link.drive_min = -LinkParameters::unlimited;
      link.drive_speed_limit = link.drive_acceleration_limit = LinkParameters::unlimited;
    }
    return joints;
  }();
};

/// A robot's joints as in JointCoordinates, with the rotors of joints whose drive is theirs alone: what articulated
/// bodies are made of.
template <class R>
struct ClusterCoordinates {
  /// Chain of the tree.
  static constexpr auto chain = [] {
    auto joints = JointCoordinates<R>::chain;
    const auto g = drive_matrix_of(R::chain.links);
    for (int i = 0; i < R::chain.size; ++i)
      if (g.is_alone(i)) joints.links[i].rotor_inertia = R::chain.links[i].rotor_inertia;
    return joints;
  }();
};

namespace detail {

template <class R>
inline constexpr auto drive_matrix = drive_matrix_of(R::chain.links);

/// What a drive is by itself: rotor, friction, limits; those of its joint too where nothing else moves that.
constexpr LinkParameters drive_by_itself(const LinkParameters& joint, bool alone) {
  LinkParameters drive;
  drive.type = JointType::prismatic;  // a number: what it makes of angles is told by the joints
  drive.rotor_inertia = joint.rotor_inertia, drive.gear = joint.gear;
  drive.viscous = joint.viscous;
  drive.coulomb_forward = joint.coulomb_forward, drive.coulomb_backward = joint.coulomb_backward;
  drive.static_friction = joint.static_friction, drive.stribeck_speed = joint.stribeck_speed;
  drive.smooth_speed = joint.smooth_speed, drive.effort_limit = joint.effort_limit;
  drive.position_min = joint.drive_min, drive.position_max = joint.drive_max;
  drive.speed_limit = joint.drive_speed_limit, drive.acceleration_limit = joint.drive_acceleration_limit;
  if (!alone) return drive;
  const auto smaller = [](double x, double y) { return x < y ? x : y; };
  drive.position_min = -smaller(-drive.position_min, -joint.position_min);
  drive.position_max = smaller(drive.position_max, joint.position_max);
  drive.speed_limit = smaller(drive.speed_limit, joint.speed_limit);
  drive.acceleration_limit = smaller(drive.acceleration_limit, joint.acceleration_limit);
  return drive;
}

}  // namespace detail

/// The drives of a robot whose joints share them: what its joint values, efforts and limits belong to. Its links are
/// drives by themselves, without geometry or mass.
template <class R>
struct DriveCoordinates {
  /// Chain of the drives, in the order of the joints that own them
  static constexpr auto chain = [] {
    constexpr auto& g = detail::drive_matrix<R>;
    constexpr auto& whole = R::chain;
    Chain<(g.drives > 0 ? g.drives : 1)> drives;
    for (int k = 0; k < g.drives; ++k)
      drives.links[k] = detail::drive_by_itself(whole.links[g.owner[k]], g.is_alone(g.owner[k]));
    drives.gravity = whole.gravity, drives.base = whole.base, drives.tool = whole.tool;
    drives.payload_limit = whole.payload_limit, drives.tip_wrench_limit = whole.tip_wrench_limit;
    drives.tool_limit = whole.tool_limit;
    drives.base_body = whole.base_body, drives.has_base_body = whole.has_base_body;
    return drives;
  }();
};

}  // namespace axial

#include <axial/options/end.hpp>
