// A torso that turns, with two arms of three joints, as on a bench robot with two hands: a tree of seven joints.
//
// assumed: everything. The values are of the size usual for arms of 0.8 m reach and 3 kg payload; they describe no
//          particular product.
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// The arms stand on the torso's sides: `side` is 1 for the left one, -1 for the right one.
struct TwoArmLinks {
  // A line a group of values.
  // clang-format off
  /// First link of an arm, on the torso.
  static constexpr axial::Link shoulder(double side) {
    return axial::revolute().parent(0).branch_deg(75.0 * side, 0.480).a(0.270).alpha_deg(0).theta_deg(-30.0 * side)
        .mass(4.6).com(0.052, 0.004 * side, 0.061).inertia_com(0.018, 0.020, 0.013, 0.0, -0.002, 0.0)
        .rotor_inertia(2.4e-5, 100.0).viscous(2.0).coulomb(1.8)
        .position_limits(-1.6, 1.6).speed_limit(2.5).acceleration_limit(12.0).effort_limit(120.0);
  }
  /// Second link of an arm.
  static constexpr axial::Link upper_arm(double side) {
    return axial::revolute().a(0.070).alpha_deg(-90)
        .mass(4.1).com(0.171, -0.006, 0.009 * side).inertia_com(0.008, 0.047, 0.046, 0.001, 0.0, 0.0)
        .rotor_inertia(2.4e-5, 100.0).viscous(2.0).coulomb(1.8)
        .position_limits(-2.0, 1.0).speed_limit(2.5).acceleration_limit(12.0).effort_limit(120.0);
  }
  /// Third link of an arm.
  static constexpr axial::Link forearm() {
    return axial::revolute().a(0.370)
        .mass(2.3).com(0.148, 0.0, 0.012).inertia_com(0.003, 0.024, 0.024, 0.0, 0.0004, 0.0)
        .rotor_inertia(1.1e-5, 80.0).viscous(0.8).coulomb(0.9)
        .position_limits(0.0, 2.5).speed_limit(3.5).acceleration_limit(20.0).effort_limit(60.0);
  }
  // clang-format on
};

/// A torso that turns, with two arms of three joints: a tree of seven joints.
struct TwoArm : TwoArmLinks {
  static constexpr const char* name = "two_arm";  ///< on the command line, in files and in JSON

  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81), axial::payload_limit(3.0, 0.20, 0.03),
      axial::revolute().d(0.350)                                                          // 0: torso, about the vertical
          .mass(24.0).com(-0.021, 0.0, 0.270).inertia_com(0.92, 0.81, 0.34, 0.0, 0.03, 0.0)
          .rotor_inertia(6.0e-5, 120.0).viscous(5.5).coulomb(4.0)
          .position_limits(-2.6, 2.6).speed_limit(1.8).acceleration_limit(6.0).effort_limit(300.0),
      shoulder(1.0), upper_arm(1.0), forearm(),                                           // 1 to 3: left arm
      shoulder(-1.0), upper_arm(-1.0), forearm(),                                         // 4 to 6: right arm
      axial::tool(0.320, 0.0, 0.0));                                                      // the right hand
  // clang-format on
};

}  // namespace robots
