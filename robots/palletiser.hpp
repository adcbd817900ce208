// A palletiser: both drives of its arm stand on the column, two parallelograms carry the motion on and keep the flange
// level. Every rod is a branch of the tree; the loops are linear, so that no constraint force is needed.
//
// assumed: everything. Of the size of palletisers of 2 m reach and 60 kg payload; no particular product.
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Four drives, ten joints.
struct Palletiser {
  static constexpr const char* name = "palletiser";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description. In the arm's vertical plane, angles from the horizontal: the upper arm stands at u1, the forearm at
  /// u2 by its crank, the flange level.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81), axial::payload_limit(60.0, 0.3, 3.0),
      // 0, the column; 1, the upper arm; 2, the forearm's crank on the upper arm's axis
      axial::revolute().d(0.75).mass(180.0).com(0.05, 0.0, -0.2).inertia_com(9.0, 9.0, 11.0)
          .rotor_inertia(1.1e-3, 120.0).viscous(40.0).coulomb(60.0)
          .position_limits(-3.1, 3.1).speed_limit(2.2).acceleration_limit(6.0).effort_limit(3000.0),
      axial::revolute().a(0.25).alpha_deg(90).mass(70.0).com(0.42, 0.0, 0.0).inertia_com(0.6, 6.5, 6.8)
          .rotor_inertia(1.4e-3, 140.0).viscous(50.0).coulomb(80.0)
          .position_limits(0.35, 2.4).speed_limit(2.0).acceleration_limit(6.0).effort_limit(6000.0)
          .drive_limits(0.35, 2.4, 2.0, 6.0),
      axial::revolute().parent(0).a(0.25).alpha_deg(90).mass(18.0).com(-0.1, 0.0, 0.0).inertia_com(0.1, 0.3, 0.35)
          .rotor_inertia(1.4e-3, 140.0).viscous(50.0).coulomb(80.0)
          .position_limits(-2.0, 0.5).speed_limit(2.0).acceleration_limit(6.0).effort_limit(6000.0)
          .drive_limits(-2.0, 0.5, 2.0, 6.0),
      // 3, the rod from the crank to the forearm: parallel to the upper arm; 4, the forearm: parallel to the crank
      axial::revolute().parent(2).a(-0.3).mass(9.0).com(0.48, 0.0, 0.0).inertia_com(0.02, 0.8, 0.8)
          .passive().driven_by(1, 1.0).driven_by(2, -1.0),
      axial::revolute().parent(1).a(0.96).mass(55.0).com(0.45, 0.0, 0.0).inertia_com(0.5, 6.0, 6.2)
          .passive().driven_by(2, 1.0).driven_by(1, -1.0).position_limits(-2.9, -0.25),
      // 5 to 7, the flange's rods: beside the upper arm, the corner at the elbow, beside the forearm
      axial::revolute().parent(0).a(0.10).alpha_deg(90).mass(6.0).com(0.48, 0.0, 0.0).inertia_com(0.01, 0.5, 0.5)
          .mimic(1),
      axial::revolute().parent(1).a(0.96).mass(8.0).com(0.05, 0.09, 0.0).inertia_com(0.05, 0.06, 0.09)
          .mimic(1, -1.0),
      axial::revolute().parent(6).a(0.15).mass(6.0).com(0.5, 0.0, 0.0).inertia_com(0.01, 0.6, 0.6)
          .passive().driven_by(2, 1.0),
      // 8, the flange, level; 9, the gripper's turn about the vertical
      axial::revolute().parent(4).a(1.05).mass(16.0).com(0.08, -0.05, 0.0).inertia_com(0.2, 0.25, 0.2)
          .passive().driven_by(2, -1.0),
      axial::revolute().a(0.2).alpha_deg(-90).mass(10.0).com(0.0, 0.0, -0.1).inertia_com(0.2, 0.2, 0.15)
          .rotor_inertia(3.0e-4, 80.0).viscous(4.0).coulomb(6.0)
          .position_limits(-6.2, 6.2).speed_limit(6.0).acceleration_limit(20.0).effort_limit(300.0));
  // clang-format on
};

}  // namespace robots
