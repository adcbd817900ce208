// Flexiv Rizon 4.
//
// data:     google-deepmind/mujoco_menagerie, commit 946194e0bd83,
//           flexiv_rizon4/flexiv_rizon4.xml;
//           Apache-2.0, Flexiv; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   flexiv_rizon4.xml (MJCF), bodies of 'world' to 'link7', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset
// read:     tool: frame of link 'link7', the chain's only end
// assumed:  no rotor inertias, where a joint has no armature: joint1, joint2, joint3, joint4, joint5, joint6, joint7
// assumed:  speed limit of half a turn a second: joint1, joint2, joint3, joint4, joint5, joint6, joint7
// assumed:  acceleration limits that reach full speed in 0.25 s: joint1, joint2, joint3, joint4, joint5, joint6, joint7
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 4.4e-16 (bound 1e-12), torques within 3.7e-16 of the largest, mass matrix within
//           4.9e-16 of its largest entry (bound 1e-09), bodies within 3.2e-16 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 7.8e-16, torques with
//           rotors within 4.2e-16 of the largest, mass matrix within 9.4e-16, bodies within 3.3e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Flexiv Rizon 4.
struct Rizon4 {
  static constexpr const char* name = "rizon4";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(0.0, 0.0, 0.015),
      // 0: joint1 moves link1
      axial::revolute().d(0.365)
          .mass(3.596).com(-1e-04, -0.0035, -0.06).inertia_com(0.0274, 0.027299975663190562, 0.007100004336809441, 0.0, 0.0, -0.0010999985852014303)
          .position_limits(-2.8798, 2.8798).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(123.0),
      // 1: joint2 moves link2
      axial::revolute().alpha_deg(90).d(0.065)
          .mass(2.69).com(3e-04, 0.0998, 0.0011).inertia_com(0.023, 0.0036000025961130163, 0.023900007403886987, 0.0, 0.0, -9.9999730566875e-05)
          .position_limits(-2.3562, 2.3562).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(123.0),
      // 2: joint3 moves link3
      axial::revolute().alpha_deg(-90).d(0.395)
          .mass(2.354).com(0.0123, 0.0012, -0.0534).inertia_com(0.014300022550328745, 0.013700001045337366, 0.003999996404333891, 0.00010000401258153171, 0.0015000043718044922, 0.0005000014178132127)
          .position_limits(-3.0543, 3.0543).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(64.0),
      // 3: joint4 moves link4
      axial::revolute().a(0.02).alpha_deg(-90).d(0.055)
          .mass(2.354).com(-0.0129, -0.1034, 0.0063).inertia_com(0.018000024987857792, 0.002999998667936137, 0.01840002634420607, 0.0016000044494773726, 0.00010000001297035109, 0.0012000036504144786)
          .position_limits(-1.9548, 2.7751).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(64.0),
      // 4: joint5 moves link5
      axial::revolute().a(-0.02).alpha_deg(90).d(0.385)
          .mass(2.31).com(-3e-04, -0.0014, -0.0537).inertia_com(0.0142, 0.013499955938142516, 0.0037000040618574846, 0.0, 0.0, -0.0004999979820203043)
          .position_limits(-3.0543, 3.0543).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(39.0),
      // 5: joint6 moves link6
      axial::revolute().alpha_deg(90).d(0.103).theta_deg(90)
          .mass(2.223).com(0.0724, 0.0202, -0.0134).inertia_com(0.004200002478605222, 0.008500010828910097, 0.009000026692484682, 0.0012000044484496515, 0.0018000089518781074, 0.00040001791097635876)
          .position_limits(-1.4835, 4.6251).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(39.0),
      // 6: joint7 moves link7
      axial::revolute().a(0.11).alpha_deg(90)
          .mass(0.768).com(3e-04, 0.0, 0.0407).inertia_com(0.001, 9e-04, 9e-04)
          .position_limits(-3.0543, 3.0543).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(39.0)
  );
  // clang-format on
};

}  // namespace robots
