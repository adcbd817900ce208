// Unitree Z1.
//
// data:     PickNikRobotics/mujoco_menagerie, commit d43f1b4e2247,
//           unitree_z1/z1.xml;
//           BSD-3-Clause, Unitree Robotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   z1.xml (MJCF), bodies of 'world' to 'link06', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, keyframe
// read:     tool: frame of link 'link06', the chain's only end
// assumed:  no rotor inertias, where a joint has no armature: joint1, joint2, joint3, joint4, joint5, joint6
// assumed:  speed limit of half a turn a second: joint1, joint2, joint3, joint4, joint5, joint6
// assumed:  acceleration limits that reach full speed in 0.25 s: joint1, joint2, joint3, joint4, joint5, joint6
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 4.4e-16 (bound 1e-12), torques within 3.3e-16 of the largest, mass matrix within
//           2.9e-16 of its largest entry (bound 1e-09), bodies within 6.3e-16 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 5e-16, torques with
//           rotors within 4.9e-16 of the largest, mass matrix within 7.8e-16, bodies within 4e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Unitree Z1.
struct Z1 {
  static constexpr const char* name = "z1";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(axial::FixedPose{{0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0},
                                   {0.0, 0.0, 0.0492}}),
      // 0: joint1 moves link01
      axial::revolute().d(0.1035)
          .mass(0.673326).com(2.47e-06, -0.00025198, -0.0218283).inertia_com(0.0012832796330965095, 0.0007193100888832623, 0.0008393602780202282, -5.999919868347796e-08, -3.999992100608588e-07, 5.00050848750951e-07)
          .viscous(1.0).coulomb(1.0)
          .position_limits(-2.61799, 2.61799).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(30.0),
      // 1: joint2 moves link02
      axial::revolute().alpha_deg(-90)
          .mass(1.19132).com(-0.110126, -0.00158266, 0.00240029).inertia_com(0.0010213773547193073, 0.02466118786050136, 0.024294614784779334, -5.133921068117437e-06, 0.0006235814158821844, 2.100136909e-06)
          .viscous(2.0).coulomb(1.0)
          .position_limits(0.0, 2.96706).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(60.0),
      // 2: joint3 moves link03
      axial::revolute().a(-0.35).theta(-0.2557425100544006)
          .mass(0.839409).com(0.11143541989140154, -0.006795693347041995, -0.00541815).inertia_com(0.0005602137965851985, 0.009386602343926891, 0.009542375859487912, -9.073305625684968e-05, -8.725580175133537e-05, -9.042779279586135e-06)
          .viscous(1.0).coulomb(1.0)
          .position_limits(-2.87979, 0.0).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(30.0),
      // 3: joint4 moves link04
      axial::revolute().a(0.22532864886649456).theta(0.2557425100544006)
          .mass(0.564046).com(0.0436668, 0.00170192, 0.00364738).inertia_com(0.00031576034035305786, 0.0009791202502386655, 0.0009299604094082765, -4.091077105544591e-05, 8.130001300010689e-05, 5.960101616052163e-06)
          .viscous(1.0).coulomb(1.0)
          .position_limits(-1.51844, 1.51844).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(30.0),
      // 4: joint5 moves link05
      axial::revolute().a(0.07).alpha_deg(90).theta_deg(90)
          .mass(0.389385).com(0.0, -0.0312153, 0.00646316).inertia_com(0.0005589601638547448, 0.00017604965006036172, 0.0005386001860848933, -4.00065138222988e-07, -1.3000512926823823e-07, -5.6889532488508985e-05)
          .viscous(1.0).coulomb(1.0)
          .position_limits(-1.3439, 1.3439).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(30.0),
      // 5: joint6 moves link06
      axial::revolute().alpha_deg(90)
          .mass(0.288758).com(-0.00017355, -0.00143876, 0.0733569).inertia_com(0.000147499909651046, 0.00014679969524822943, 0.00018328039510072456, 8.0020089052857e-08, 1.220013193878331e-06, 5.400096604465359e-07)
          .viscous(1.0).coulomb(1.0)
          .position_limits(-2.79253, 2.79253).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(30.0)
  );
  // clang-format on
};

}  // namespace robots
