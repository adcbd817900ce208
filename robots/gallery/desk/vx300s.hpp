// Trossen ViperX 300 S, up to its wrist.
//
// data:     PickNikRobotics/mujoco_menagerie, commit d43f1b4e2247,
//           trossen_vx300s/vx300s.xml;
//           BSD-3-Clause, Trossen Robotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   vx300s.xml (MJCF), bodies of 'world' to 'gripper_link', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact, keyframe
// read:     joints beside the chain are held where the file draws them (or at their nearest limit), their bodies
//           carried along: left_finger, right_finger
// assumed:  no rotor inertias, where a joint has no armature: waist, wrist_angle, wrist_rotate
// assumed:  speed limit of half a turn a second: waist, shoulder, elbow, forearm_roll, wrist_angle, wrist_rotate
// assumed:  acceleration limits that reach full speed in 0.25 s: waist, shoulder, elbow, forearm_roll, wrist_angle,
//           wrist_rotate
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 3.3e-16 (bound 1e-12), torques within 4.5e-16 of the largest, mass matrix within
//           4.8e-16 of its largest entry (bound 1e-09), bodies within 1.2e-15 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 8.9e-16, torques with
//           rotors within 5.9e-16 of the largest, mass matrix within 6.3e-16, bodies within 3.7e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Trossen ViperX 300 S, up to its wrist.
struct Vx300s {
  static constexpr const char* name = "vx300s";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(axial::FixedPose{{0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0},
                                   {0.0, 0.0, 0.069744}}),
      // 0: waist moves shoulder_link
      axial::revolute().d(0.12705)
          .mass(0.798614).com(0.000259233, -3.3552e-06, -0.0364371).inertia_com(0.0011379983013311515, 0.0009388000013614218, 0.0012010016973074268, 1.09832444e-09, -5.9570613863739985e-06, -1.887794493e-08)
          .viscous(2.86)
          .position_limits(-3.14158, 3.14158).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0),
      // 1: shoulder moves upper_arm_link
      axial::revolute().alpha_deg(-90).theta(-1.3748434898066828)
          .mass(0.792592).com(0.22615448508666858, -0.023792991451135385, 4e-10).inertia_com(0.000780295031060718, 0.009092401968939283, 0.008925, 0.0004181049094545654, 0.0, 0.0)
          .rotor_inertia(0.004, 1.0)
          .viscous(6.25).coulomb(0.06)
          .position_limits(-1.85005, 1.25664).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(57.0),
      // 2: elbow moves upper_forearm_link
      axial::revolute().a(0.30585323686369575).theta(-0.19595283698821372)
          .mass(0.322228).com(0.0, 0.105723, 0.0).inertia_com(0.0014409958976592113, 0.00015239955059755895, 0.0013420015517432297, -8.407288365164505e-06, 1.2563131753444506e-06, -1.8830120735808207e-05)
          .rotor_inertia(0.072, 1.0)
          .viscous(8.15).coulomb(1.74)
          .position_limits(-1.76278, 1.6057).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(25.0),
      // 3: forearm_roll moves lower_forearm_link
      axial::revolute().alpha_deg(-90).d(0.3)
          .mass(0.414823).com(0.0, -0.00680462, -0.0486523).inertia_com(0.0005911, 0.0005269002277857088, 0.00017529977221429123, 0.0, 0.0, -8.528015220139389e-05)
          .rotor_inertia(0.06, 1.0)
          .viscous(3.07)
          .position_limits(-3.14158, 3.14158).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(10.0),
      // 4: wrist_angle moves wrist_link
      axial::revolute().alpha_deg(90)
          .mass(0.115395).com(0.010565, 0.046743, -7.6652e-06).inertia_com(5.2700015529656866e-05, 4.5139965958002424e-05, 4.631001851234072e-05, -4.200213084894991e-06, 2.2999041835130207e-09, -1.9500189788167238e-08)
          .viscous(1.18)
          .position_limits(-1.8675, 2.23402).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0),
      // 5: wrist_rotate moves gripper_link
      axial::revolute().alpha_deg(-90)
          .mass(0.329253).com(0.003062208154458729, 1.95208303e-07, 0.11940905791108965).inertia_com(0.0008421927657534952, 0.0006375696363736783, 0.0007075438657447959, -7.896224795396581e-07, 2.7977183119205505e-05, -4.801643580658685e-06)
          .viscous(0.78)
          .position_limits(-3.14158, 3.14158).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0)
  );
  // clang-format on
};

}  // namespace robots
