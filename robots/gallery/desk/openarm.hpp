// OpenArm v1, one arm, its fingers held.
//
// data:     enactic/openarm_mujoco, commit 396c88d87fc7,
//           v1/openarm.xml;
//           Apache-2.0, Enactic; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   openarm.xml (MJCF), bodies of 'world' to 'openarm_link7', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact
// read:     joints beside the chain are held where the file draws them (or at their nearest limit), their bodies
//           carried along: openarm_finger_joint1, openarm_finger_joint2
// assumed:  no rotor inertias, where a joint has no armature: openarm_joint1, openarm_joint2, openarm_joint3,
//           openarm_joint4, openarm_joint5, openarm_joint6, openarm_joint7
// assumed:  speed limit of half a turn a second: openarm_joint1, openarm_joint2, openarm_joint3, openarm_joint4,
//           openarm_joint5, openarm_joint6, openarm_joint7
// assumed:  acceleration limits that reach full speed in 0.25 s: openarm_joint1, openarm_joint2, openarm_joint3,
//           openarm_joint4, openarm_joint5, openarm_joint6, openarm_joint7
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 3.3e-16 (bound 1e-12), torques within 4e-16 of the largest, mass matrix within 5e-16
//           of its largest entry (bound 1e-09), bodies within 2.2e-16 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 5.6e-16, torques with
//           rotors within 7.1e-16 of the largest, mass matrix within 5e-16, bodies within 3.1e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// OpenArm v1, one arm, its fingers held.
struct Openarm {
  static constexpr const char* name = "openarm";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(axial::FixedPose{{0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
                                   {0.0, 0.0, 0.0}}),
      // 0: openarm_joint1 moves openarm_link1
      axial::revolute().d(0.1225).theta_deg(-90)
          .mass(1.14167).com(3.31999e-05, 0.00114677, -0.0060472).inertia_com(0.001273000274775716, 0.0015670041305204541, 0.00101599559470383, 9.99999831380943e-07, -1.0000146652059255e-06, -2.9000419283275434e-05)
          .viscous(0.25).coulomb(0.02)
          .position_limits(-1.396263, 3.490659).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(10.0),
      // 1: openarm_joint2 moves openarm_link2
      axial::revolute().alpha_deg(90)
          .mass(0.277509).com(-2.01451e-08, 0.0325665, 0.02170371).inertia_com(0.0003759999583045435, 0.00023199981615528223, 0.0003590002255401743, -9.99983897167815e-07, 9.999936712838267e-07, 0.00010900019334094412)
          .viscous(0.25).coulomb(0.02)
          .position_limits(-1.74533, 1.74533).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(12.0),
      // 2: openarm_joint3 moves openarm_link3
      axial::revolute().alpha_deg(-90).d(0.22).theta_deg(-90)
          .mass(1.07386).com(0.00210475, 0.000554909, -0.0652753).inertia_com(0.004372002251969833, 0.004319000885172767, 0.0006609998628573997, 1.0000167543995547e-06, -1.1000018874029806e-05, 3.599733963492206e-05)
          .viscous(0.25).coulomb(0.02)
          .position_limits(-1.570796, 1.570796).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(10.0),
      // 3: openarm_joint4 moves openarm_link4
      axial::revolute().alpha_deg(90)
          .mass(1.3699337287025453).com(0.0029006831074562967, 0.06339637422196209, 0.0011942417336533104).inertia_com(0.001577, 0.001104, 0.001346)
          .viscous(0.25).coulomb(0.02)
          .position_limits(0.0, 2.443461).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(10.0),
      // 4: openarm_joint5 moves openarm_link5
      axial::revolute().alpha_deg(-90).d(0.216).theta_deg(-90)
          .mass(0.550659).com(-0.00088669, 0.00304967, -0.0774202).inertia_com(0.0004449997370335299, 0.0004230001589296392, 0.0003240001040368309, 7.999848056224933e-06, -6.000003892040947e-06, -5.9999251852664886e-06)
          .viscous(0.25).coulomb(0.02)
          .position_limits(-1.570796, 1.570796).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(10.0),
      // 5: openarm_joint6 moves openarm_link6
      axial::revolute().alpha_deg(90).theta_deg(90)
          .mass(0.3540202773187987).com(-9.498374522309838e-05, -0.00033230528343419053, 0.0003634129945525935).inertia_com(0.000159, 0.000157, 0.000143)
          .viscous(0.25).coulomb(0.02)
          .position_limits(-0.785398, 0.785398).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(10.0),
      // 6: openarm_joint7 moves openarm_link7
      axial::revolute().alpha_deg(90)
          .mass(0.6220280396036005).com(0.07469130876231406, 0.0008083492141277238, -0.015442203616880345).inertia_com(0.0004076691983161263, 0.001022392937382535, 0.0008214180988602464, -2.869651924239428e-05, -8.611930039617714e-05, -7.794231552488308e-06)
          .viscous(0.25).coulomb(0.02)
          .position_limits(-1.570796, 1.570796).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(10.0)
  );
  // clang-format on
};

}  // namespace robots
