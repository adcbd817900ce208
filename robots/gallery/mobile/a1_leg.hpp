// a leg of the Unitree A1.
//
// data:     PickNikRobotics/mujoco_menagerie, commit d43f1b4e2247,
//           unitree_a1/a1.xml;
//           BSD-3-Clause, Unitree Robotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   a1.xml (MJCF), bodies of 'trunk' to 'FL_calf', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, keyframe
// read:     joint 'joint0' is free: body 'trunk' is the base, fixed unless a scene names FloatingBase
// assumed:  speed limit of half a turn a second: FL_hip_joint, FL_thigh_joint, FL_calf_joint
// assumed:  acceleration limits that reach full speed in 0.25 s: FL_hip_joint, FL_thigh_joint, FL_calf_joint
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 2.2e-16 (bound 1e-12), torques within 5.1e-16 of the largest, mass matrix within
//           3.1e-16 of its largest entry (bound 1e-09), bodies within 4e-17 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 3.3e-16, torques with
//           rotors within 7.9e-16 of the largest, mass matrix within 5.5e-16, bodies within 1.6e-09, what joints have
//           within 0 (bound of each 1e-06)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// a leg of the Unitree A1.
struct A1Leg {
  static constexpr const char* name = "a1_leg";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::base(axial::FixedPose{{0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 0.0}}),
      axial::tool(axial::FixedPose{{0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
                                   {0.0, 0.0, 0.08505}}),
      axial::base_body().mass(4.713).com(0.0041, 0.0, -5e-04).inertia_com(0.0377999, 0.0158533, 0.0456542, 3.66e-05, -2.75e-05, 6.11e-05),
      // 0: FL_hip_joint moves FL_hip
      axial::revolute().a(0.047).alpha_deg(90).d(0.183).theta_deg(90)
          .mass(0.696).com(3.1e-05, -0.000635, -0.003311).inertia_com(0.0005529293170165985, 0.0008074896437284401, 0.00046924603925496136, 4.6604885485929237e-07, -3.420672663343238e-07, 9.409159588038486e-06)
          .rotor_inertia(0.01, 1.0)
          .viscous(1.0).coulomb(0.2)
          .position_limits(-0.802851, 0.802851).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(33.5),
      // 1: FL_thigh_joint moves FL_thigh
      axial::revolute().alpha_deg(90)
          .mass(1.013).com(-0.027326, -0.003237, 0.062723).inertia_com(0.0013677914153622107, 0.005529060040858994, 0.005139338543778796, 0.00034386846681079276, 2.2447390122089957e-05, 4.824976022508131e-06)
          .rotor_inertia(0.01, 1.0)
          .viscous(2.0).coulomb(0.2)
          .position_limits(-1.0472, 4.18879).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(33.5),
      // 2: FL_calf_joint moves FL_calf
      axial::revolute().a(-0.2)
          .mass(0.226).com(-0.131975, 0.00472659, 0.08505).inertia_com(4.385088989898844e-05, 0.0033855625101010113, 0.00340344, -0.00016742685899992981, 0.0, 0.0)
          .rotor_inertia(0.01, 1.0)
          .viscous(2.0).coulomb(0.2)
          .position_limits(-2.69653, -0.916298).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(33.5)
  );
  // clang-format on
};

}  // namespace robots
