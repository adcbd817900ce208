// UFACTORY Lite 6.
//
// data:     PickNikRobotics/mujoco_menagerie, commit d43f1b4e2247,
//           ufactory_lite6/lite6.xml;
//           BSD-3-Clause, UFACTORY; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   lite6.xml (MJCF), bodies of 'world' to 'attachment_site', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, keyframe
// read:     tool: frame of link 'attachment_site', the chain's only end
// read:     axes were turned by up to 7.3e-06 rad onto axes of their frames or of their neighbours', joints 'joint3',
//           'joint4' (--right-angles 0 reads what is written)
// assumed:  speed limit of half a turn a second: joint1, joint2, joint3, joint4, joint5, joint6
// assumed:  acceleration limits that reach full speed in 0.25 s: joint1, joint2, joint3, joint4, joint5, joint6
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 4.4e-16 (bound 1e-12), torques within 3.3e-16 of the largest, mass matrix within
//           3.7e-16 of its largest entry (bound 1e-09), bodies within 1e-16 (bound 1e-11)
// verified: no angle is read more than 8.5e-06 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 8.9e-16, torques with
//           rotors within 6.6e-16 of the largest, mass matrix within 1.1e-15, bodies within 2.7e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// UFACTORY Lite 6.
struct Lite6 {
  static constexpr const char* name = "lite6";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(0.0, 0.0, 0.0625),
      // 0: joint1 moves link1
      axial::revolute().d(0.2435)
          .mass(1.411).com(-0.00036, 0.04195, -0.0025).inertia_com(0.0014516370479116876, 0.0008872999861208134, 0.001319927965967499, -1.239995121343832e-05, 6.6999051667868685e-06, -0.00012549984363230648)
          .rotor_inertia(0.1, 1.0)
          .viscous(1.0)
          .position_limits(-6.28319, 6.28319).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(50.0),
      // 1: joint2 moves link2
      axial::revolute().alpha_deg(-90).theta_deg(-90)
          .mass(1.34).com(0.179, 0.0, 0.0584).inertia_com(0.0015854001024178637, 0.005609697145365886, 0.004849992752216249, 6.768098188598058e-06, 0.0011513637776023361, -1.1404870612190337e-06)
          .rotor_inertia(0.1, 1.0)
          .viscous(1.0)
          .position_limits(-2.61799, 2.61799).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(50.0),
      // 2: joint3 moves link3
      axial::revolute().a(0.2002).alpha_deg(180).theta_deg(-90)
          .mass(0.953).com(0.072, -0.0357, -0.001).inertia_com(0.000886099107405336, 0.0015784979250210692, 0.0018467699675735947, 0.000392868099943885, -7.065982646046827e-05, 2.4449583012658698e-05)
          .rotor_inertia(0.1, 1.0)
          .viscous(1.0)
          .position_limits(-0.061087, 5.23599).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(32.0),
      // 3: joint4 moves link4
      axial::revolute().a(0.087).alpha_deg(90).d(0.22761)
          .mass(1.284).com(-0.002, -0.0285, -0.0813).inertia_com(0.0037050016556066274, 0.003045499661567256, 0.0015412986828261168, 1.999970490114243e-06, -7.170012520142507e-06, 0.0009318774501889606)
          .rotor_inertia(0.1, 1.0)
          .viscous(1.0)
          .position_limits(-6.28319, 6.28319).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(32.0),
      // 4: joint5 moves link5
      axial::revolute().alpha_deg(90)
          .mass(0.804).com(0.0, 0.01, 0.0019).inertia_com(0.0005668002386478409, 0.0005077001328740126, 0.0005299996284781467, -5.999982960684696e-07, 5.3000906155823096e-06, 4.799846403321458e-07)
          .rotor_inertia(0.1, 1.0)
          .viscous(1.0)
          .position_limits(-2.1642, 2.1642).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(32.0),
      // 5: joint6 moves link6
      axial::revolute().alpha_deg(-90)
          .mass(0.13).com(0.0, -0.00194, 0.0523).inertia_com(7.726004840947742e-05, 8.566498107375792e-05, 0.00014813987051676464, -9.9999237472632e-07, -4.0002964780334696e-07, 6.000148609989014e-07)
          .rotor_inertia(0.1, 1.0)
          .viscous(1.0)
          .position_limits(-6.28319, 6.28319).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(20.0)
  );
  // clang-format on
};

}  // namespace robots
