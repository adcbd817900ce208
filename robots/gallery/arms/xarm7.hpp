// UFACTORY xArm 7.
//
// data:     PickNikRobotics/mujoco_menagerie, commit d43f1b4e2247,
//           ufactory_xarm7/xarm7_nohand.xml;
//           BSD-3-Clause, UFACTORY; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   xarm7_nohand.xml (MJCF), bodies of 'world' to 'attachment_site', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, keyframe
// read:     tool: frame of link 'attachment_site', the chain's only end
// assumed:  no rotor inertias, where a joint has no armature: joint1, joint2, joint3, joint4, joint5, joint6, joint7
// assumed:  speed limit of half a turn a second: joint1, joint2, joint3, joint4, joint5, joint6, joint7
// assumed:  acceleration limits that reach full speed in 0.25 s: joint1, joint2, joint3, joint4, joint5, joint6, joint7
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 3.3e-16 (bound 1e-12), torques within 5.8e-16 of the largest, mass matrix within
//           6.3e-16 of its largest entry (bound 1e-09), bodies within 9.8e-17 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 1.6e-15, torques with
//           rotors within 1.1e-15 of the largest, mass matrix within 1.8e-15, bodies within 9.1e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// UFACTORY xArm 7.
struct Xarm7 {
  static constexpr const char* name = "xarm7";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(0.0, 0.0, 0.097),
      // 0: joint1 moves link1
      axial::revolute().d(0.387)
          .mass(2.382).com(-2e-04, 0.02905, -0.01233).inertia_com(0.005690503314580237, 0.00495660167273971, 0.0033166550126800527, -1.579002325009015e-05, 5.124998206228802e-06, -0.000873380619068175)
          .viscous(10.0).coulomb(1.0)
          .position_limits(-6.28319, 6.28319).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(50.0),
      // 1: joint2 moves link2
      axial::revolute().alpha_deg(-90)
          .mass(1.869).com(0.00022, -0.12856, 0.01735).inertia_com(0.009598903317188852, 0.003824724876840115, 0.007565671805971033, 1.5410386376582429e-06, 5.560025362889086e-06, -0.0031715599822888414)
          .viscous(10.0).coulomb(1.0)
          .position_limits(-2.059, 2.0944).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(50.0),
      // 2: joint3 moves link3
      axial::revolute().alpha_deg(90).d(0.293)
          .mass(1.6383).com(0.0466, -0.02463, -0.00768).inertia_com(0.003109546682150449, 0.0026448329841877575, 0.0026624003336617936, 0.0003083707289060394, -0.0005845279733870445, 0.00033889451379534894)
          .viscous(5.0).coulomb(1.0)
          .position_limits(-6.28319, 6.28319).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(30.0),
      // 3: joint4 moves link4
      axial::revolute().a(0.0525).alpha_deg(90)
          .mass(1.7269).com(0.07047, -0.11575, 0.012).inertia_com(0.005889000110315926, 0.003597034863925584, 0.00543244502575849, 0.0013711227205710139, 0.0008814299573430202, -0.0017621539270987585)
          .viscous(5.0).coulomb(1.0)
          .position_limits(-0.19198, 3.927).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(30.0),
      // 4: joint5 moves link5
      axial::revolute().a(0.0775).alpha_deg(90).d(0.3425)
          .mass(1.3203).com(-0.00032, 0.01604, -0.026).inertia_com(0.005346648293023585, 0.004977904092120912, 0.0013623976148555033, 1.5116791931582078e-05, -3.6898100624832413e-07, -0.0002213201798292796)
          .viscous(5.0).coulomb(1.0)
          .position_limits(-6.28319, 6.28319).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(30.0),
      // 5: joint6 moves link6
      axial::revolute().alpha_deg(90)
          .mass(1.325).com(0.06469, 0.03278, 0.02141).inertia_com(0.0014745013346270162, 0.0019036978893514217, 0.002365200776021562, -0.0004879984802427241, 0.0002953008654932392, 0.00014748986780209925)
          .viscous(2.0).coulomb(1.0)
          .position_limits(-1.69297, 3.14159).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(20.0),
      // 6: joint7 moves link7
      axial::revolute().a(0.076).alpha_deg(-90)
          .mass(0.17).com(0.0, -0.00677, 0.08602).inertia_com(9.3e-05, 5.869998753593383e-05, 0.00013199961246406617, 0.0, 0.0, -3.600035109381531e-06)
          .viscous(2.0).coulomb(1.0)
          .position_limits(-6.28319, 6.28319).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(20.0)
  );
  // clang-format on
};

}  // namespace robots
