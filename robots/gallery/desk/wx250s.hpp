// Trossen WidowX 250 S, up to its wrist.
//
// data:     google-deepmind/mujoco_menagerie, commit 1f2300db40ca,
//           trossen_wx250s/wx250s.xml;
//           BSD-3-Clause, Trossen Robotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   wx250s.xml (MJCF), bodies of 'world' to 'wx250s/gripper_link', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact, keyframe
// read:     joints beside the chain are held where the file draws them (or at their nearest limit), their bodies
//           carried along: left_finger, right_finger
// assumed:  speed limit of half a turn a second: waist, shoulder, elbow, forearm_roll, wrist_angle, wrist_rotate
// assumed:  acceleration limits that reach full speed in 0.25 s: waist, shoulder, elbow, forearm_roll, wrist_angle,
//           wrist_rotate
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 5.6e-16 (bound 1e-12), torques within 1.1e-15 of the largest, mass matrix within
//           1.2e-15 of its largest entry (bound 1e-09), bodies within 1.8e-15 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 6.7e-16, torques with
//           rotors within 3.2e-16 of the largest, mass matrix within 7.9e-16, bodies within 4.2e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Trossen WidowX 250 S, up to its wrist.
struct Wx250s {
  static constexpr const char* name = "wx250s";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(axial::FixedPose{{0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0},
                                   {0.0, 0.0, 0.065}}),
      // 0: waist moves wx250s/shoulder_link
      axial::revolute().d(0.11065)
          .mass(0.480879).com(2.23482e-05, 4.14609e-05, -0.0320213).inertia_com(0.000378999604035322, 0.0005557001022413746, 0.0005889002937233034, 2.20179105e-09, -3.5604219657231425e-07, 1.2245331385252121e-06)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-3.14158, 3.14158).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0),
      // 1: shoulder moves wx250s/upper_arm_link
      axial::revolute().alpha_deg(-90).theta(-1.3743624900568607)
          .mass(0.430811).com(0.1909929013928827, -0.020510599863938404, 2.725e-07).inertia_com(0.0005711212242925432, 0.003348478708603209, 0.0035869980671042476, 0.0005754838763657839, 0.00041898362725225474, -8.33777418231987e-05)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-1.88496, 1.98968).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0),
      // 2: elbow moves wx250s/upper_forearm_link
      axial::revolute().a(0.2549020645267511).theta(-0.196433836738036)
          .mass(0.234589).com(0.0, 0.107963, 0.000115876).inertia_com(0.000888, 3.971002716703866e-05, 0.0008878004728329614, 0.0, 0.0, 2.3528005879525303e-06)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-2.14675, 1.6057).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0),
      // 3: forearm_roll moves wx250s/lower_forearm_link
      axial::revolute().alpha_deg(-90).d(0.25)
          .mass(0.220991).com(0.0, -0.00522252, -0.0375605).inertia_com(0.0001834, 0.00016770025034792318, 6.369004965207682e-05, 0.0, 0.0, 2.292005044115176e-05)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-3.14158, 3.14158).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0),
      // 4: wrist_angle moves wx250s/wrist_link
      axial::revolute().alpha_deg(90)
          .mass(0.084957).com(0.010577, 0.04236, -1.0663e-05).inertia_com(3.1519980497804606e-05, 3.081999785082013e-05, 2.8220021651375263e-05, 2.298741521305578e-09, 2.5480726740293827e-06, 1.9099694703112084e-08)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-1.74533, 2.14675).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0),
      // 5: wrist_rotate moves wx250s/gripper_link
      axial::revolute().alpha_deg(-90)
          .mass(0.142576).com(0.007023012678150601, -3.2475614e-07, 0.1083058155538099).inertia_com(0.0031437510771427615, 0.0031367970212523317, 0.003052851784003883, 9.55042432110533e-07, 1.6433237268168342e-05, 6.1915112e-10)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-3.14158, 3.14158).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0)
  );
  // clang-format on
};

}  // namespace robots
