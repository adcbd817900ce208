// Kinova Gen3 Lite with its gripper, fingers held.
//
// data:     Kinovarobotics/ros2_kortex, commit 1fdbef345954,
//           kortex_description/robots/gen3_lite.urdf;
//           BSD-3-Clause, Kinova; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   gen3_lite.urdf (URDF), links of 'world' to 'gripper_base_link', whose frame is the tool's
// read:     joints beside the chain are held at 0 (or their nearest limit), their bodies carried along:
//           left_finger_bottom_joint, left_finger_tip_joint, right_finger_bottom_joint, right_finger_tip_joint
// read:     6 angles were read as the multiples of 90 degrees that they are within 1e-05 rad of; the farthest by
//           7.3e-06 (--right-angles 0 reads what is written)
// assumed:  gravity of 9.81 m/s^2 along -z of link 'world'
// assumed:  no rotor inertias: a URDF has none
// assumed:  acceleration limits that reach full speed in 0.25 s: joint_1, joint_2, joint_3, joint_4, joint_5, joint_6
// verified: against Orocos KDL, built from the text by another reader, on 100 random states (seed 1), axial::Model in
//           double:
// verified: frames and tool within 2e-15 (bound 1e-12), torques within 2.8e-16 of the largest, mass matrix within 6e-16
//           of its largest entry (bound 1e-09), bodies within 1.7e-16 (bound 1e-11)
// verified: no angle is read more than 7.3e-06 rad, no origin more than 0 m from what is written
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Kinova Gen3 Lite with its gripper, fingers held.
struct Gen3Lite {
  static constexpr const char* name = "gen3_lite";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(axial::FixedPose{{0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 0.105}}),
      // 0: joint_1 moves shoulder_link
      axial::revolute().d(0.24325)
          .mass(0.95974404).com(2.477e-05, 0.02213531, -0.01562314).inertia_com(0.00165947, 0.00140355, 0.00089493, 2e-08, 3.6e-07, 0.00034927)
          .position_limits(-2.69, 2.69).speed_limit(1.6).acceleration_limit(6.4).effort_limit(10.0),
      // 1: joint_2 moves arm_link
      axial::revolute().alpha_deg(90).theta_deg(90)
          .mass(1.17756164).com(0.21154808, -0.02998299, 0.0753031).inertia_com(0.00102851, 0.01149277, 0.01133492, -1e-06, 0.00140765, -1.6e-07)
          .position_limits(-2.69, 2.69).speed_limit(1.6).acceleration_limit(6.4).effort_limit(14.0),
      // 2: joint_3 moves forearm_link
      axial::revolute().a(0.28).alpha_deg(180).d(-0.01).theta_deg(90)
          .mass(0.59767669).com(0.0301559, 0.09502206, -0.0126445).inertia_com(0.00163256, 0.00029798, 0.00169091, 7.11e-06, 1.54e-06, 9.587e-05)
          .position_limits(-2.69, 2.69).speed_limit(1.6).acceleration_limit(6.4).effort_limit(10.0),
      // 3: joint_4 moves lower_wrist_link
      axial::revolute().alpha_deg(90).d(0.245).theta_deg(90)
          .mass(0.52693412).com(0.01000443, -0.00575149, -0.01780793).inertia_com(0.00078519, 0.00069098, 0.00034115, -2.4e-07, 7.4e-07, -0.00016483)
          .position_limits(-2.59, 2.59).speed_limit(1.6).acceleration_limit(6.4).effort_limit(7.0),
      // 4: joint_5 moves upper_wrist_link
      axial::revolute().alpha_deg(90).d(0.057)
          .mass(0.58097325).com(0.00980409, -0.08056517, -0.00977201).inertia_com(0.00106371, 0.00021268, 0.00108465, -5.21e-06, 1.1e-07, -2.91e-06)
          .position_limits(-2.57, 2.57).speed_limit(1.6).acceleration_limit(6.4).effort_limit(7.0),
      // 5: joint_6 moves end_effector_link
      axial::revolute().alpha_deg(-90)
          .mass(0.197766).com(0.0023997242334899732, -2.003074630503459e-05, 0.1573281622862117).inertia_com(0.00021132470114836207, 0.0003084494869729698, 0.00018718510391870112, 5.0049789806735895e-08, -2.9195651533873806e-05, 3.507906799912242e-08)
          .position_limits(-2.59, 2.59).speed_limit(3.2).acceleration_limit(12.8).effort_limit(7.0)
  );
  // clang-format on
};

}  // namespace robots
