// Kinova Gen3, 6 joints.
//
// data:     Kinovarobotics/ros_kortex, commit 6cd75d45f4d0,
//           kortex_description/arms/gen3/6dof/urdf/GEN3-6DOF_VISION_URDF_ARM_V01.urdf;
//           BSD-3-Clause, Kinova; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   GEN3-6DOF_VISION_URDF_ARM_V01.urdf (URDF), links of 'base_link'
// read:     8 angles were read as the multiples of 90 degrees that they are within 1e-05 rad of; the farthest by
//           7.3e-06 (--right-angles 0 reads what is written)
// assumed:  gravity of 9.81 m/s^2 along -z of link 'base_link'
// assumed:  no rotor inertias: a URDF has none
// assumed:  position limits of a turn either way (fixed point needs limits; wrap the angle): joint_1, joint_4, joint_6
// assumed:  acceleration limits that reach full speed in 0.25 s: joint_1, joint_2, joint_3, joint_4, joint_5, joint_6
// verified: against Orocos KDL, built from the text by another reader, on 100 random states (seed 1), axial::Model in
//           double:
// verified: frames and tool within 4.6e-15 (bound 1e-12), torques within 4.1e-16 of the largest, mass matrix within
//           4.7e-16 of its largest entry (bound 1e-09), bodies within 8.9e-17 (bound 1e-11)
// verified: no angle is read more than 7.3e-06 rad, no origin more than 0 m from what is written
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Kinova Gen3, 6 joints.
struct Gen36 {
  static constexpr const char* name = "gen3_6";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      // 0: joint_1 moves shoulder_link
      axial::revolute().alpha_deg(180).d(-0.28481)
          .mass(1.377).com(-2.3e-05, -0.010364, 0.05502).inertia_com(0.00457, 0.004831, 0.001409, 1e-06, 2e-06, 0.000448)
          .position_limits(-6.283185307179586, 6.283185307179586).speed_limit(1.3963).acceleration_limit(5.5852).effort_limit(39.0),
      // 1: joint_2 moves bicep_link
      axial::revolute().alpha_deg(90).theta_deg(-90)
          .mass(1.262).com(0.208207, 3.5e-05, -0.024265).inertia_com(0.00085, 0.046752, 0.047188, 9e-06, 9.8e-05, 0.0)
          .position_limits(-2.24, 2.24).speed_limit(1.3963).acceleration_limit(5.5852).effort_limit(39.0),
      // 2: joint_3 moves forearm_link
      axial::revolute().a(0.41).alpha_deg(180).d(-0.001).theta_deg(-90)
          .mass(0.93).com(1.8e-05, 0.076168, -0.007595).inertia_com(0.008292, 0.000628, 0.008464, -1e-06, 0.0, 0.000432)
          .position_limits(-2.57, 2.57).speed_limit(1.3963).acceleration_limit(5.5852).effort_limit(39.0),
      // 3: joint_4 moves spherical_wrist_1_link
      axial::revolute().alpha_deg(90).d(-0.31436)
          .mass(0.6781).com(-1e-06, 0.008486, 0.042993).inertia_com(0.001645, 0.001666, 0.000389, 0.0, 0.0, -0.000234)
          .position_limits(-6.283185307179586, 6.283185307179586).speed_limit(1.2218).acceleration_limit(4.8872).effort_limit(9.0),
      // 4: joint_5 moves spherical_wrist_2_link
      axial::revolute().alpha_deg(-90).d(-0.0003501)
          .mass(0.678).com(-1e-06, 0.046429, -0.00852895).inertia_com(0.001685, 4e-04, 0.001696, 0.0, 0.0, 0.000255)
          .position_limits(-2.09, 2.09).speed_limit(1.2218).acceleration_limit(4.8872).effort_limit(9.0),
      // 5: joint_6 moves bracelet_link
      axial::revolute().alpha_deg(90)
          .mass(0.5).com(0.000281, 0.011402, -0.135728).inertia_com(0.000587, 0.000369, 0.000609, 3e-06, 3e-06, -0.000118)
          .position_limits(-6.283185307179586, 6.283185307179586).speed_limit(1.2218).acceleration_limit(4.8872).effort_limit(9.0)
  );
  // clang-format on
};

}  // namespace robots
