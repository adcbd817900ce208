// The upper body of a humanoid: a waist and a neck of two joints each, two arms of four: a tree of twelve joints.
//
// assumed: everything. The values are of the size usual for a humanoid of 1.4 m; they describe no particular product.
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// The arms leave the chest, link 1, whose z axis points to its left: `side` is 1 for the left arm, -1 for the right.
struct TorsoLinks {
  // A line a group of values.
  // clang-format off
  /// First link of an arm, on the chest.
  static constexpr axial::Link shoulder_pitch(double side) {
    return axial::revolute().parent(1).branch_deg(-90.0, 0.145 * side).a(0.310).alpha_deg(12.0 * side).theta_deg(180)
        .mass(1.6).com(0.004, 0.0, 0.021 * side).inertia_com(0.0021, 0.0024, 0.0018)
        .rotor_inertia(1.2e-5, 100.0).viscous(0.7).coulomb(0.6)
        .position_limits(-2.6, 1.0).speed_limit(4.0).acceleration_limit(25.0).effort_limit(45.0);
  }
  /// Second link of an arm.
  static constexpr axial::Link shoulder_roll() {
    return axial::revolute().alpha_deg(90)
        .mass(1.1).com(0.0, -0.012, 0.008).inertia_com(0.0014, 0.0011, 0.0013, 0.0, 0.0, 0.0001)
        .rotor_inertia(1.2e-5, 100.0).viscous(0.7).coulomb(0.6)
        .position_limits(-1.8, 1.8).speed_limit(4.0).acceleration_limit(25.0).effort_limit(45.0);
  }
  /// Third link of an arm, down to the elbow.
  static constexpr axial::Link upper_arm() {
    return axial::revolute().alpha_deg(-90).d(0.240)
        .mass(1.4).com(0.003, 0.006, -0.085).inertia_com(0.0062, 0.0061, 0.0012, 0.0, 0.0002, 0.0)
        .rotor_inertia(0.8e-5, 100.0).viscous(0.5).coulomb(0.5)
        .position_limits(-1.6, 1.6).speed_limit(5.0).acceleration_limit(30.0).effort_limit(30.0);
  }
  /// Fourth link of an arm, from the elbow on.
  static constexpr axial::Link forearm() {
    return axial::revolute().alpha_deg(90).a(0.020)
        .mass(1.2).com(0.021, -0.110, 0.0).inertia_com(0.0074, 0.0009, 0.0075, 0.0003, 0.0, 0.0)
        .rotor_inertia(0.8e-5, 100.0).viscous(0.5).coulomb(0.5)
        .position_limits(-2.3, 0.1).speed_limit(5.0).acceleration_limit(30.0).effort_limit(30.0);
  }
  // clang-format on
};

/// Upper body of a humanoid: waist, neck and two arms, a tree of twelve joints.
struct Torso : TorsoLinks {
  static constexpr const char* name = "torso";  ///< on the command line, in files and in JSON

  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81), axial::payload_limit(1.5, 0.15, 0.01),
      axial::revolute().d(0.120)                                                          // 0: waist, about the vertical
          .mass(3.1).com(0.0, 0.002, 0.041).inertia_com(0.011, 0.010, 0.009)
          .rotor_inertia(3.0e-5, 120.0).viscous(2.2).coulomb(1.5)
          .position_limits(-1.4, 1.4).speed_limit(2.5).acceleration_limit(12.0).effort_limit(120.0),
      axial::revolute().alpha_deg(-90)                                                    // 1: waist, nods; the chest
          .mass(11.5).com(0.014, -0.190, 0.0).inertia_com(0.190, 0.086, 0.165, 0.004, 0.0, 0.0)
          .rotor_inertia(3.0e-5, 120.0).viscous(2.2).coulomb(1.5)
          .position_limits(-0.4, 0.9).speed_limit(2.5).acceleration_limit(12.0).effort_limit(150.0),
      axial::revolute().alpha_deg(90).d(0.400)                                            // 2: neck, about the vertical
          .mass(0.6).com(0.0, 0.0, 0.025).inertia_com(0.0006, 0.0006, 0.0004)
          .rotor_inertia(0.3e-5, 80.0).viscous(0.1).coulomb(0.15)
          .position_limits(-1.5, 1.5).speed_limit(5.0).acceleration_limit(40.0).effort_limit(8.0),
      axial::revolute().alpha_deg(-90)                                                    // 3: neck, nods; the head
          .mass(2.4).com(0.018, -0.075, 0.0).inertia_com(0.0121, 0.0087, 0.0112, 0.0006, 0.0, 0.0)
          .rotor_inertia(0.3e-5, 80.0).viscous(0.1).coulomb(0.15)
          .position_limits(-0.7, 0.7).speed_limit(5.0).acceleration_limit(40.0).effort_limit(8.0),
      shoulder_pitch(1.0), shoulder_roll(), upper_arm(), forearm(),                       // 4 to 7: left arm
      shoulder_pitch(-1.0), shoulder_roll(), upper_arm(), forearm(),                      // 8 to 11: right arm
      axial::tool(0.0, -0.240, 0.0));                                                     // the right hand
  // clang-format on
};

}  // namespace robots
