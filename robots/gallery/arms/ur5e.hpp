// Universal Robots UR5e.
//
// data:     PickNikRobotics/mujoco_menagerie, commit d43f1b4e2247,
//           universal_robots_ur5e/ur5e.xml;
//           BSD-3-Clause, ROS Industrial Consortium; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   ur5e.xml (MJCF), bodies of 'world' to 'attachment_site', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, keyframe
// read:     tool: frame of link 'attachment_site', the chain's only end
// assumed:  speed limit of half a turn a second: shoulder_pan_joint, shoulder_lift_joint, elbow_joint, wrist_1_joint,
//           wrist_2_joint, wrist_3_joint
// assumed:  acceleration limits that reach full speed in 0.25 s: shoulder_pan_joint, shoulder_lift_joint, elbow_joint,
//           wrist_1_joint, wrist_2_joint, wrist_3_joint
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 3.3e-16 (bound 1e-12), torques within 3.2e-16 of the largest, mass matrix within
//           3.7e-16 of its largest entry (bound 1e-09), bodies within 8.2e-17 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 1.2e-15, torques with
//           rotors within 1.3e-15 of the largest, mass matrix within 2e-15, bodies within 8.2e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Universal Robots UR5e.
struct Ur5e {
  static constexpr const char* name = "ur5e";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(0.0, 0.0, 0.1),
      // 0: shoulder_pan_joint moves shoulder_link
      axial::revolute().d(0.163).theta_deg(-90)
          .mass(3.7).inertia_com(0.0102675, 0.0102675, 0.00666)
          .rotor_inertia(0.1, 1.0)
          .position_limits(-6.28319, 6.28319).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(150.0),
      // 1: shoulder_lift_joint moves upper_arm_link
      axial::revolute().alpha_deg(90)
          .mass(8.393).com(-0.2125, 0.0, 0.138).inertia_com(0.0151074, 0.133886, 0.133886)
          .rotor_inertia(0.1, 1.0)
          .position_limits(-6.28319, 6.28319).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(150.0),
      // 2: elbow_joint moves forearm_link
      axial::revolute().a(-0.425)
          .mass(2.275).com(-0.196, 0.0, 0.007).inertia_com(0.004095, 0.0311796, 0.0311796)
          .rotor_inertia(0.1, 1.0)
          .position_limits(-3.1415, 3.1415).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(150.0),
      // 3: wrist_1_joint moves wrist_1_link
      axial::revolute().a(-0.392).d(0.134)
          .mass(1.219).inertia_com(0.0025599, 0.0021942, 0.0025599)
          .rotor_inertia(0.1, 1.0)
          .position_limits(-6.28319, 6.28319).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(28.0),
      // 4: wrist_2_joint moves wrist_2_link
      axial::revolute().alpha_deg(90).d(0.1)
          .mass(1.219).inertia_com(0.0025599, 0.0025599, 0.0021942)
          .rotor_inertia(0.1, 1.0)
          .position_limits(-6.28319, 6.28319).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(28.0),
      // 5: wrist_3_joint moves wrist_3_link
      axial::revolute().alpha_deg(-90)
          .mass(0.1889).com(0.0, 0.0, 0.0771683).inertia_com(9.90863e-05, 9.90863e-05, 0.000132134)
          .rotor_inertia(0.1, 1.0)
          .position_limits(-6.28319, 6.28319).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(28.0)
  );
  // clang-format on
};

}  // namespace robots
