// Dobot M1 Pro, a SCARA whose first joint lifts.
//
// data:     Dobot-Arm/M1Pro-ROS, commit 561c9ceb55d7,
//           m1pro_description/urdf/m1pro_description.urdf;
//           MIT, Dobot; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// doubtful: bodies are a drawing program's, of 1.1 kg that move; joint 4 stands a degree off
//           as it was drawn
// source:   m1pro_description.urdf (URDF), links of 'dummy_link' to 'Link4', whose frame is the tool's
// read:     tool: frame of link 'Link4', the chain's only end
// read:     axes were turned by up to 1.5e-07 rad onto axes of their frames or of their neighbours', joints 'joint3'
//           (--right-angles 0 reads what is written)
// assumed:  gravity of 9.81 m/s^2 along -z of link 'dummy_link'
// assumed:  no rotor inertias: a URDF has none
// assumed:  position limits of a turn either way (fixed point needs limits; wrap the angle): joint2, joint3, joint4
// assumed:  speed limit of half a turn a second: joint2, joint3, joint4
// assumed:  speed limit of 1 m/s: joint1
// assumed:  acceleration limits that reach full speed in 0.25 s: joint1, joint2, joint3, joint4
// assumed:  no effort limit: joint1, joint2, joint3, joint4
// verified: against Orocos KDL, built from the text by another reader, on 100 random states (seed 1), axial::Model in
//           double:
// verified: frames and tool within 3.3e-16 (bound 1e-12), torques within 2.2e-16 of the largest, mass matrix within
//           2.1e-16 of its largest entry (bound 1e-09), bodies within 8.8e-15 (bound 1e-11)
// verified: no angle is read more than 1.5e-07 rad, no origin more than 0 m from what is written
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Dobot M1 Pro, a SCARA whose first joint lifts.
struct M1Pro {
  static constexpr const char* name = "m1_pro";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(0.0, 0.0, -0.06883895613683245),
      // 0: joint1 moves Link1
      axial::prismatic().a(-0.003)
          .mass(0.34234).com(0.096709, 6.1822e-05, 0.185951).inertia_com(0.0016183, 0.0016941, 0.00088121, 1.9963e-06, -0.00029873, 8.0481e-07)
          .position_limits(0.0, 0.25).speed_limit(1.0).acceleration_limit(4.0),
      // 1: joint2 moves Link2
      axial::revolute().a(0.123)
          .mass(0.37995).com(0.11428, -2.1681e-05, 0.1441295).inertia_com(0.00096644, 0.0031741, 0.0027963, 2.2955e-06, -0.00059955, -2.4057e-09)
          .position_limits(-6.283185307179586, 6.283185307179586).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 2: joint3 moves Link3
      axial::revolute().a(0.2).alpha_deg(180).d(-0.0939016327044696).theta(-0.034228)
          .mass(0.33738).com(0.097934, -0.000460223871381972, -0.017590791080195886).inertia_com(0.00099637, 0.0032537778141527945, 0.0025683221858472053, 1.413868442279544e-05, 0.0007476771212658594, -1.2348794449261958e-05)
          .position_limits(-6.283185307179586, 6.283185307179586).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 3: joint4 moves Link4
      axial::revolute().a(0.2).alpha(3.1241398076692724)
          .mass(0.010941).com(3.5e-13, -1.577e-11, -0.10775995613683245).inertia_com(7.2568e-06, 7.2589e-06, 4.4133e-07, 4e-21, 6.14e-17, -4.5944e-15)
          .position_limits(-6.283185307179586, 6.283185307179586).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172)
  );
  // clang-format on
};

}  // namespace robots
