// KUKA LBR iiwa 7.
//
// data:     RobotLocomotion/models, commit 4723170e1c8e,
//           iiwa_description/sdf/iiwa7_no_collision.sdf;
//           BSD-2-Clause, R. Krug, T. Stoyanov, AASS Research Center; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   iiwa7_no_collision.sdf (SDF), links of 'iiwa_link_0' to 'iiwa_link_7', whose frame is the tool's
// read:     not read: drake:acceleration, drake:gear_ratio, drake:rotor_inertia, visual
// read:     no joint fixes link 'iiwa_link_0' to the world: it is the base, fixed unless a scene names FloatingBase
// read:     tool: frame of link 'iiwa_link_7', the chain's only end
// read:     axes were turned by up to 2.7e-06 rad onto axes of their frames or of their neighbours', joints
//           'iiwa_joint_5', 'iiwa_joint_6' (--right-angles 0 reads what is written)
// assumed:  gravity of 9.81 m/s^2 along -z of the world: the file has a model alone
// assumed:  no rotor inertias: an SDF has none
// assumed:  acceleration limits that reach full speed in 0.25 s: iiwa_joint_1, iiwa_joint_2, iiwa_joint_3,
//           iiwa_joint_4, iiwa_joint_5, iiwa_joint_6, iiwa_joint_7
// verified: against Orocos KDL on the tree of the file's links, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 8.3e-16 (bound 1e-12), torques within 5.7e-16 of the largest, mass matrix within
//           9.7e-16 of its largest entry (bound 1e-09), bodies within 4.6e-16 (bound 1e-11)
// verified: no angle is read more than 2.7e-06 rad, no origin more than 0 m from what is written
// verified: the file as it is written against DART 6.12.1, built from the frames of libsdformat 12.3.0 on 20 of these
//           states: poses within 2e-15, torques with rotors within 1.4e-15 of the largest, mass matrix within 1.2e-15,
//           bodies within 1.4e-15, what joints have within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// KUKA LBR iiwa 7.
struct Iiwa7 {
  static constexpr const char* name = "iiwa7";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(0.0, 0.0, 0.0805),
      axial::base_body().mass(3.863).com(-0.013, 0.0, 0.07).inertia_com(0.0141, 0.0171, 0.0178),
      // 0: iiwa_joint_1 moves iiwa_link_1
      axial::revolute().d(0.3405)
          .mass(2.7025).com(0.0, -0.0347, -0.07).inertia_com(0.0171, 0.0163, 0.006)
          .position_limits(-2.96706, 2.96706).speed_limit(1.710422667).acceleration_limit(6.841690668).effort_limit(176.0),
      // 1: iiwa_joint_2 moves iiwa_link_2
      axial::revolute().alpha_deg(-90)
          .mass(2.7258).com(-9.128414e-08, -0.06679987364129379, 0.03440024536974772).inertia_com(0.016999999999994367, 0.006100000000136274, 0.016199999999869357, -9.845e-14, 2.1228718e-09, 3.709937154e-08)
          .position_limits(-2.0944, 2.0944).speed_limit(1.710422667).acceleration_limit(6.841690668).effort_limit(176.0),
      // 2: iiwa_joint_3 moves iiwa_link_3
      axial::revolute().alpha_deg(90).d(0.3995)
          .mass(3.175).com(0.0, 0.0296, -0.089).inertia_com(0.025, 0.0238, 0.0076)
          .position_limits(-2.96706, 2.96706).speed_limit(1.745329252).acceleration_limit(6.981317008).effort_limit(110.0),
      // 3: iiwa_joint_4 moves iiwa_link_4
      axial::revolute().alpha_deg(90)
          .mass(2.73).com(0.0, 0.0669998751105745, 0.034000246104512556).inertia_com(0.017, 0.006100000000136274, 0.016199999999863726, 0.0, 0.0, -3.709937154e-08)
          .position_limits(-2.0944, 2.0944).speed_limit(2.2689280276).acceleration_limit(9.0757121104).effort_limit(110.0),
      // 4: iiwa_joint_5 moves iiwa_link_5
      axial::revolute().alpha_deg(-90).d(0.3995)
          .mass(1.69).com(-1e-04, -0.021, -0.1395).inertia_com(0.01, 0.0087, 0.00449)
          .position_limits(-2.96706, 2.96706).speed_limit(2.4434609528).acceleration_limit(9.7738438112).effort_limit(110.0),
      // 5: iiwa_joint_6 moves iiwa_link_6
      axial::revolute().alpha_deg(-90)
          .mass(1.8).com(-1.32682e-09, -0.002599998163379908, 0.0005000095503281352).inertia_com(0.005099999999988734, 0.0048999999999811104, 0.003500000000030156, 1.365e-14, 4.24574367e-09, -5.14248714e-09)
          .position_limits(-2.0944, 2.0944).speed_limit(3.1415926536).acceleration_limit(12.5663706144).effort_limit(40.0),
      // 6: iiwa_joint_7 moves iiwa_link_7
      axial::revolute().alpha_deg(90)
          .mass(0.4).com(0.0, 0.0, 0.1099).inertia_com(4e-04, 4e-04, 5e-04)
          .position_limits(-3.05433, 3.05433).speed_limit(3.1415926536).acceleration_limit(12.5663706144).effort_limit(40.0)
  );
  // clang-format on
};

}  // namespace robots
