// Koch v1.1, the low-cost arm, with its jaw.
//
// data:     google-deepmind/mujoco_menagerie, commit 1f2300db40ca,
//           low_cost_robot_arm/low_cost_robot_arm.xml;
//           Apache-2.0, Alexander Koch; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   low_cost_robot_arm.xml (MJCF), bodies of 'world' to 'gripper_moving_finger', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact, keyframe
// read:     tool: frame of link 'gripper_moving_finger', the chain's only end
// assumed:  speed limit of half a turn a second: base_rotation, pitch, elbow, wrist_pitch, wrist_roll, gripper
// assumed:  acceleration limits that reach full speed in 0.25 s: base_rotation, pitch, elbow, wrist_pitch, wrist_roll,
//           gripper
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 4.4e-16 (bound 1e-12), torques within 1.7e-16 of the largest, mass matrix within
//           2.6e-18 of its largest entry (bound 1e-09), bodies within 1.8e-16 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 7.8e-16, torques with
//           rotors within 3.5e-16 of the largest, mass matrix within 2.2e-16, bodies within 3.1e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Koch v1.1, the low-cost arm, with its jaw.
struct Koch {
  static constexpr const char* name = "koch";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(axial::FixedPose{{0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0},
                                   {0.0, 0.0, -0.0145}}),
      // 0: base_rotation moves shoulder_rotation
      axial::revolute().a(0.012).alpha_deg(180).d(-0.0563)
          .mass(0.05014).com(0.011924, 0.00048792, 0.002019).inertia_com(7.604498636800072e-06, 1.235800584988655e-05, 1.4491975513313378e-05, 2.489302670640511e-07, 2.8341739035852796e-08, -5.11218822e-09)
          .rotor_inertia(0.5, 1.0)
          .coulomb(0.2)
          .position_limits(-2.2, 2.2).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(87.0),
      // 1: pitch moves shoulder_to_elbow
      axial::revolute().alpha_deg(90).theta(1.4349801908973276)
          .mass(0.050177).com(-0.07072908174850016, -0.01085127292551342, 7e-05).inertia_com(9.542115594326582e-06, 3.5713392494373233e-05, 3.377200191130019e-05, -6.6506836538719065e-06, 5.101729054e-10, -2.5507137197443307e-09)
          .rotor_inertia(0.5, 1.0)
          .coulomb(0.2)
          .position_limits(-1.57, 0.6).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(87.0),
      // 2: elbow moves elbow_to_wrist_extension
      axial::revolute().a(-0.109306587175705).alpha_deg(180).theta(1.4081166309148654)
          .mass(0.06379).com(-0.055427001314647, 0.0013776095514041263, -0.000105).inertia_com(7.344908903492638e-06, 2.450380154502018e-05, 2.2230999551487182e-05, -2.7161568981778053e-07, -2.6022257791265538e-09, -1.68032005e-10)
          .rotor_inertia(0.5, 1.0)
          .coulomb(0.2)
          .position_limits(-1.57, 1.45).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(87.0),
      // 3: wrist_pitch moves elbow_to_wrist
      axial::revolute().a(-0.10051626664381243).alpha_deg(180).d(-0.001253).theta(1.5439327668124345)
          .mass(0.019805).com(9.0614e-06, 0.02652, 0.006098).inertia_com(2.8758990981765972e-06, 2.957703741950554e-06, 1.0782971598728487e-06, -1.3309692353268787e-10, -1.3756924041545746e-09, -2.8302034203478402e-08)
          .rotor_inertia(0.5, 1.0)
          .coulomb(0.2)
          .position_limits(-2.0, 2.0).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(12.0),
      // 4: wrist_roll moves gripper_static_finger
      axial::revolute().alpha_deg(90).d(-0.05815).theta_deg(90)
          .mass(0.029277).com(0.0053379, 0.00018011, -0.005941).inertia_com(6.8334001872303265e-06, 8.112496747737226e-06, 3.5905030650324483e-06, -2.844394608162758e-09, 1.060099256115668e-06, 4.617750378007191e-08)
          .rotor_inertia(0.5, 1.0)
          .coulomb(0.2)
          .position_limits(-3.14, 3.14).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(10.0),
      // 5: gripper moves gripper_moving_finger
      axial::revolute().a(-0.0075).alpha_deg(90)
          .mass(0.012831).com(0.0010817, -0.02507, -0.00036).inertia_com(3.448997525620213e-06, 1.5159044344701102e-06, 2.456498039909677e-06, 3.1559849340359943e-07, 3.868924763134342e-09, -3.409016943732439e-08)
          .rotor_inertia(0.5, 1.0)
          .coulomb(0.1)
          .position_limits(-1.6, 0.032).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(5.0)
  );
  // clang-format on
};

}  // namespace robots
