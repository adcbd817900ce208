// I2RT YAM, its fingers held.
//
// data:     google-deepmind/mujoco_menagerie, commit 1f2300db40ca,
//           i2rt_yam/yam.xml;
//           MIT, I2RT Robotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   yam.xml (MJCF), bodies of 'world' to 'link_6', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, keyframe
// read:     gravcomp of body 'link_2' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link_3' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link_4' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link_5' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link_6' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link_left_finger' is not taken over: its weight is held by the joints, as that of the
//           others
// read:     gravcomp of body 'lf_rot' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'lf_down' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link_right_finger' is not taken over: its weight is held by the joints, as that of the
//           others
// read:     gravcomp of body 'rf_rot' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'rf_down' is not taken over: its weight is held by the joints, as that of the others
// read:     joints beside the chain are held where the file draws them (or at their nearest limit), their bodies
//           carried along: left_finger, right_finger
// assumed:  speed limit of half a turn a second: joint1, joint2, joint3, joint4, joint5, joint6
// assumed:  acceleration limits that reach full speed in 0.25 s: joint1, joint2, joint3, joint4, joint5, joint6
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 4.4e-16 (bound 1e-12), torques within 5.6e-16 of the largest, mass matrix within
//           6.7e-16 of its largest entry (bound 1e-09), bodies within 1.5e-16 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 1.2e-15, torques with
//           rotors within 1.4e-12 of the largest, mass matrix within 2.5e-12, bodies within 1.5e-08, what joints have
//           within 0 (bound of each 1e-06)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// I2RT YAM, its fingers held.
struct Yam {
  static constexpr const char* name = "yam";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(axial::FixedPose{{-1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 0.0353}}),
      // 0: joint1 moves link_1
      axial::revolute().d(0.104)
          .mass(0.12415).com(0.00795735, -0.00192861, -0.0200824).inertia_com(0.0001692149109581771, 5.980377664112822e-05, 0.00015618221240069465, 4.590113693336891e-06, -1.683384920180454e-05, 7.411121999226119e-06)
          .rotor_inertia(0.032, 1.0)
          .coulomb(0.1)
          .position_limits(-2.61799, 3.05433).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(28.0),
      // 1: joint2 moves link_2
      axial::revolute().a(0.02).alpha_deg(-90)
          .mass(1.24434).com(-0.132008, -2.10599e-06, 0.000318073).inertia_com(0.000683304, 0.0121902, 0.0121318)
          .rotor_inertia(0.032, 1.0)
          .coulomb(0.1)
          .position_limits(0.0, 3.66519).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(28.0),
      // 2: joint3 moves link_3
      axial::revolute().a(-0.264).alpha_deg(180).theta(0.2401710078601731)
          .mass(0.853698).com(0.13136570164529518, 0.024295555215703403, -0.000136108).inertia_com(0.0011395630349705305, 0.0066460009650294695, 0.00696112, 0.001434552726129666, 0.0, 0.0)
          .rotor_inertia(0.032, 1.0)
          .coulomb(0.1)
          .position_limits(0.0, 3.66519).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(28.0),
      // 3: joint4 moves link_4
      axial::revolute().a(0.2522399651125888).theta(-0.2401710078601731)
          .mass(0.463511).com(0.0769778, 0.0527104, 0.000129878).inertia_com(0.0005900424240923443, 0.0004836055759076556, 0.000744733, -0.00024908625935833427, 0.0, 0.0)
          .rotor_inertia(0.0018, 1.0)
          .coulomb(0.1)
          .position_limits(-1.5708, 1.5708).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(10.0),
      // 4: joint5 moves link_5
      axial::revolute().a(0.074).alpha_deg(90).theta_deg(90)
          .mass(0.350962).com(-3.64861e-05, -0.00025665, -0.0041474).inertia_com(0.000197802, 0.0001775, 0.000147402)
          .rotor_inertia(0.0018, 1.0)
          .coulomb(0.1)
          .position_limits(-1.5708, 1.5708).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(10.0),
      // 5: joint6 moves link_6
      axial::revolute().alpha_deg(90)
          .mass(0.7246144943644873).com(0.0001104368553408306, 0.0031316105901022877, 0.08905004547353973).inertia_com(0.00124748052332192, 0.0009834639716995099, 0.0006463162577278925, -1.4520393921249539e-06, 2.136288230980173e-06, -0.00017925952971917504)
          .rotor_inertia(0.0018, 1.0)
          .coulomb(0.1)
          .position_limits(-2.0944, 2.0944).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(10.0)
  );
  // clang-format on
};

}  // namespace robots
