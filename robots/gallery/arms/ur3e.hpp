// Universal Robots UR3e.
//
// data:     RobotLocomotion/models, commit 4723170e1c8e,
//           ur_description/urdf/ur3e_cylinders_collision.urdf;
//           BSD-3-Clause, ROS Industrial Consortium; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   ur3e_cylinders_collision.urdf (URDF), links of 'ur_base_link'
// assumed:  gravity of 9.81 m/s^2 along -z of link 'ur_base_link'
// assumed:  no rotor inertias: a URDF has none
// assumed:  acceleration limits that reach full speed in 0.25 s: ur_shoulder_pan_joint, ur_shoulder_lift_joint,
//           ur_elbow_joint, ur_wrist_1_joint, ur_wrist_2_joint, ur_wrist_3_joint
// verified: against Orocos KDL, built from the text by another reader, on 100 random states (seed 1), axial::Model in
//           double:
// verified: frames and tool within 4.4e-16 (bound 1e-12), torques within 3.7e-16 of the largest, mass matrix within
//           4.4e-16 of its largest entry (bound 1e-09), bodies within 1.4e-16 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Universal Robots UR3e.
struct Ur3e {
  static constexpr const char* name = "ur3e";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      // 0: ur_shoulder_pan_joint moves ur_shoulder_link
      axial::revolute().d(0.152)
          .mass(2.0).inertia_com(0.008093163429399999, 0.008093163429399999, 0.005625)
          .position_limits(-3.141592653589793, 3.141592653589793).speed_limit(3.14).acceleration_limit(12.56).effort_limit(330.0),
      // 1: ur_shoulder_lift_joint moves ur_upper_arm_link
      axial::revolute().alpha_deg(-90)
          .mass(3.42).com(0.122, 0.0, 0.12).inertia_com(0.00961875, 0.021777126289145996, 0.021777126289145996)
          .position_limits(-3.141592653589793, 3.141592653589793).speed_limit(3.14).acceleration_limit(12.56).effort_limit(330.0),
      // 2: ur_elbow_joint moves ur_forearm_link
      axial::revolute().a(0.244)
          .mass(1.26).com(0.1065, 0.0, 0.027).inertia_com(0.00354375, 0.006535617385751999, 0.006535617385751999)
          .position_limits(-3.141592653589793, 3.141592653589793).speed_limit(3.14).acceleration_limit(12.56).effort_limit(150.0),
      // 3: ur_wrist_1_joint moves ur_wrist_1_link
      axial::revolute().a(0.213).d(0.131)
          .mass(0.8).inertia_com(0.002084999166, 0.00225, 0.002084999166)
          .position_limits(-3.141592653589793, 3.141592653589793).speed_limit(6.28).acceleration_limit(25.12).effort_limit(54.0),
      // 4: ur_wrist_2_joint moves ur_wrist_2_link
      axial::revolute().alpha_deg(-90).d(0.085)
          .mass(0.8).inertia_com(0.002084999166, 0.002084999166, 0.00225)
          .position_limits(-3.141592653589793, 3.141592653589793).speed_limit(6.28).acceleration_limit(25.12).effort_limit(54.0),
      // 5: ur_wrist_3_joint moves ur_wrist_3_link
      axial::revolute().alpha_deg(90)
          .mass(0.35).com(0.0, 0.0, 0.071).inertia_com(0.00014104994358, 0.00014104994358, 0.0001792)
          .position_limits(-3.141592653589793, 3.141592653589793).speed_limit(6.28).acceleration_limit(25.12).effort_limit(54.0)
  );
  // clang-format on
};

}  // namespace robots
