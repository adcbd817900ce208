// KUKA LBR iiwa 14.
//
// data:     PickNikRobotics/mujoco_menagerie, commit d43f1b4e2247,
//           kuka_iiwa_14/iiwa14.xml;
//           BSD-3-Clause, Drake's authors; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   iiwa14.xml (MJCF), bodies of 'world' to 'attachment_site', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact, keyframe
// read:     tool: frame of link 'attachment_site', the chain's only end
// assumed:  no rotor inertias, where a joint has no armature: joint1, joint2, joint3, joint4, joint5, joint6, joint7
// assumed:  speed limit of half a turn a second: joint1, joint2, joint3, joint4, joint5, joint6, joint7
// assumed:  acceleration limits that reach full speed in 0.25 s: joint1, joint2, joint3, joint4, joint5, joint6, joint7
// assumed:  no effort limit: joint1, joint2, joint3, joint4, joint5, joint6, joint7
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 3.3e-16 (bound 1e-12), torques within 3.7e-16 of the largest, mass matrix within
//           5.1e-16 of its largest entry (bound 1e-09), bodies within 2.5e-16 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 1.9e-15, torques with
//           rotors within 9.4e-16 of the largest, mass matrix within 1.2e-15, bodies within 7.2e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// KUKA LBR iiwa 14.
struct Iiwa14 {
  static constexpr const char* name = "iiwa14";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(0.0, 0.0, 0.126),
      // 0: joint1 moves link1
      axial::revolute().d(0.36)
          .mass(5.76).com(0.0, -0.03, -0.0825).inertia_com(0.0333, 0.033, 0.0123)
          .position_limits(-2.96706, 2.96706).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 1: joint2 moves link2
      axial::revolute().alpha_deg(-90)
          .mass(6.35).com(-3e-04, -0.059, 0.042).inertia_com(0.0305, 0.011, 0.0304)
          .position_limits(-2.0944, 2.0944).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 2: joint3 moves link3
      axial::revolute().alpha_deg(90).d(0.42)
          .mass(3.5).com(0.0, 0.03, -0.0855).inertia_com(0.025, 0.0238, 0.0076)
          .position_limits(-2.96706, 2.96706).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 3: joint4 moves link4
      axial::revolute().alpha_deg(90)
          .mass(3.5).com(0.0, 0.067, 0.034).inertia_com(0.017, 0.006, 0.0164)
          .position_limits(-2.0944, 2.0944).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 4: joint5 moves link5
      axial::revolute().alpha_deg(-90).d(0.4)
          .mass(3.5).com(-1e-04, -0.021, -0.1395).inertia_com(0.01, 0.0087, 0.00449)
          .position_limits(-2.96706, 2.96706).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 5: joint6 moves link6
      axial::revolute().alpha_deg(-90)
          .mass(1.8).com(0.0, -6e-04, 4e-04).inertia_com(0.0049, 0.0036, 0.0047)
          .position_limits(-2.0944, 2.0944).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 6: joint7 moves link7
      axial::revolute().alpha_deg(90)
          .mass(1.2).com(0.0, 0.0, 0.101).inertia_com(0.001, 0.001, 0.001)
          .position_limits(-3.05433, 3.05433).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172)
  );
  // clang-format on
};

}  // namespace robots
