// the thumb of the Unitree Dex3-1 hand.
//
// data:     unitreerobotics/unitree_ros, commit d6f13aad6032,
//           robots/dexterous_hand_description/dex3_1/dex3_1_r.urdf;
//           BSD-3-Clause, Unitree Robotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   dex3_1_r.urdf (URDF), links of 'right_hand_palm_link' to 'right_hand_thumb_2_link', whose frame is the
//           tool's
// assumed:  gravity of 9.81 m/s^2 along -z of link 'right_hand_palm_link'
// assumed:  no rotor inertias: a URDF has none
// assumed:  acceleration limits that reach full speed in 0.25 s: right_hand_thumb_0_joint, right_hand_thumb_1_joint,
//           right_hand_thumb_2_joint
// verified: against Orocos KDL, built from the text by another reader, on 100 random states (seed 1), axial::Model in
//           double:
// verified: frames and tool within 2.2e-16 (bound 1e-12), torques within 3.5e-16 of the largest, mass matrix within
//           2.1e-16 of its largest entry (bound 1e-09), bodies within 8.9e-17 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// the thumb of the Unitree Dex3-1 hand.
struct Dex3Thumb {
  static constexpr const char* name = "dex3_thumb";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(axial::FixedPose{{0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 0.0}}),
      // 0: right_hand_thumb_0_joint moves right_hand_thumb_0_link
      axial::revolute().a(0.0255).alpha_deg(-90).d(0.0193)
          .mass(0.08623657).com(-0.0008842458, -0.00094429336, -0.01066592921).inertia_com(1.602919238e-05, 1.637877663e-05, 1.451795012e-05, -1.6728875e-07, -1.0683177e-07, -5.1094752e-07)
          .position_limits(-1.04719755, 1.04719755).speed_limit(3.14).acceleration_limit(12.56).effort_limit(2.45),
      // 1: right_hand_thumb_1_joint moves right_hand_thumb_1_link
      axial::revolute().a(-0.0025).alpha_deg(90).theta_deg(90)
          .mass(0.0588507).com(0.03547435774, 0.00082788768, -0.0003808996).inertia_com(6.01573947e-06, 1.274699945e-05, 1.234543582e-05, -5.0770784e-07, 2.7839003e-07, -1.608885e-07)
          .position_limits(-1.04719755, 0.61086523).speed_limit(12.0).acceleration_limit(48.0).effort_limit(1.4),
      // 2: right_hand_thumb_2_joint moves right_hand_thumb_2_link
      axial::revolute().a(0.0458)
          .mass(0.02030626).com(0.02628192939, 0.00171735242, 0.00010778879).inertia_com(1.53561368e-06, 4.61267817e-06, 3.86625776e-06, -3.42213e-08, 2.549885e-08, 8.23881e-09)
          .position_limits(-1.74532925, 0.0).speed_limit(12.0).acceleration_limit(48.0).effort_limit(1.4)
  );
  // clang-format on
};

}  // namespace robots
