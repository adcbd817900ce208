// Kinova Gen3, 7 joints.
//
// data:     PickNikRobotics/mujoco_menagerie, commit d43f1b4e2247,
//           kinova_gen3_7dof/gen3_7dof.xml;
//           BSD-3-Clause, Kinova; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   gen3_7dof.xml (MJCF), bodies of 'world' to 'wrist_camera_optical_frame', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact
// read:     gravcomp of body 'base_link' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'shoulder_link' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'half_arm_1_link' is not taken over: its weight is held by the joints, as that of the
//           others
// read:     gravcomp of body 'half_arm_2_link' is not taken over: its weight is held by the joints, as that of the
//           others
// read:     gravcomp of body 'forearm_link' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'spherical_wrist_1_link' is not taken over: its weight is held by the joints, as that of
//           the others
// read:     gravcomp of body 'spherical_wrist_2_link' is not taken over: its weight is held by the joints, as that of
//           the others
// read:     gravcomp of body 'bracelet_link' is not taken over: its weight is held by the joints, as that of the others
// read:     tool: frame of link 'wrist_camera_optical_frame', the chain's only end
// read:     axes were turned by up to 7.3e-06 rad onto axes of their frames or of their neighbours', joints 'joint_1',
//           'joint_2', 'joint_3', 'joint_4', 'joint_5', 'joint_6', 'joint_7' (--right-angles 0 reads what is written)
// assumed:  position limits of a turn either way (fixed point needs limits; wrap the angle): joint_1, joint_3, joint_5,
//           joint_7
// assumed:  speed limit of half a turn a second: joint_1, joint_2, joint_3, joint_4, joint_5, joint_6, joint_7
// assumed:  acceleration limits that reach full speed in 0.25 s: joint_1, joint_2, joint_3, joint_4, joint_5, joint_6,
//           joint_7
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 4.4e-16 (bound 1e-12), torques within 4.2e-16 of the largest, mass matrix within
//           6.3e-16 of its largest entry (bound 1e-09), bodies within 8.9e-17 (bound 1e-11)
// verified: no angle is read more than 7.3e-06 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 1.1e-15, torques with
//           rotors within 7.3e-16 of the largest, mass matrix within 2.1e-15, bodies within 5.9e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Kinova Gen3, 7 joints.
struct Gen3 {
  static constexpr const char* name = "gen3";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(axial::FixedPose{{-1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0},
                                   {0.0, -0.056, -0.16393}}),
      // 0: joint_1 moves shoulder_link
      axial::revolute().alpha_deg(180).d(-0.28481)
          .mass(1.3773).com(-2.3e-05, -0.010364, 0.05502).inertia_com(0.004570003811842713, 0.004830996090870019, 0.0014090000972872684, 1.0001014699125045e-06, 1.999891163483883e-06, 0.0004480003018140217)
          .rotor_inertia(1.5e-06, 1.0)
          .viscous(1.0)
          .position_limits(-6.283185307179586, 6.283185307179586).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(87.0),
      // 1: joint_2 moves half_arm_1_link
      axial::revolute().alpha_deg(90).d(-0.01175)
          .mass(1.1636).com(-4.4e-05, -0.09958, -0.006903).inertia_com(0.011087998061732671, 0.0010719990921477895, 0.01125502284611954, 4.9973852276531154e-06, -4.5964257e-10, -0.0006910049592641929)
          .rotor_inertia(1.5e-06, 1.0)
          .viscous(1.0)
          .position_limits(-2.41, 2.41).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(87.0),
      // 2: joint_3 moves half_arm_2_link
      axial::revolute().alpha_deg(-90).d(-0.42076)
          .mass(1.1636).com(-4.4e-05, -0.006641, 0.092488).inertia_com(0.010931995836211465, 0.01112701206084157, 0.001043002102946966, 1.8009665e-10, -7.000635873392001e-06, 0.0006060008846876071)
          .rotor_inertia(1.5e-06, 1.0)
          .viscous(1.0)
          .position_limits(-6.283185307179586, 6.283185307179586).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(87.0),
      // 3: joint_4 moves forearm_link
      axial::revolute().alpha_deg(90).d(-0.01275)
          .mass(0.9302).com(-1.8e-05, -0.075478, -0.008631).inertia_com(0.008146999890314388, 0.0006310004646524832, 0.008315995645033129, -9.943266546343458e-07, 3.437317e-10, -0.0004999996952901609)
          .rotor_inertia(1.5e-06, 1.0)
          .viscous(1.0)
          .position_limits(-2.66, 2.66).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(87.0),
      // 4: joint_5 moves spherical_wrist_1_link
      axial::revolute().alpha_deg(-90).d(-0.31436)
          .mass(0.6781).com(1e-06, -0.009432, 0.042047).inertia_com(0.001596, 0.0016069978053526255, 0.00039900019464737444, 0.0, 0.0, 0.0002559997563545738)
          .rotor_inertia(1.928e-06, 1.0)
          .viscous(1.0)
          .position_limits(-6.283185307179586, 6.283185307179586).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(87.0),
      // 5: joint_6 moves spherical_wrist_2_link
      axial::revolute().alpha_deg(90).d(-0.0003501)
          .mass(0.6781).com(1e-06, -0.045483, -0.00947495).inertia_com(0.001641, 0.0004100000007405778, 0.0016409999992594221, 0.0, 0.0, -0.00027800069750209496)
          .rotor_inertia(1.928e-06, 1.0)
          .viscous(1.0)
          .position_limits(-2.23, 2.23).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(87.0),
      // 6: joint_7 moves bracelet_link
      axial::revolute().alpha_deg(-90)
          .mass(0.364).com(-9.3e-05, 0.000132, -0.128835).inertia_com(0.00021400006905573392, 0.00022299962760460797, 0.00024000030333965809, -8.083995e-12, 1.0000217017057637e-06, -2.0000780499117954e-06)
          .rotor_inertia(1.928e-06, 1.0)
          .viscous(1.0)
          .position_limits(-6.283185307179586, 6.283185307179586).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(87.0)
  );
  // clang-format on
};

}  // namespace robots
