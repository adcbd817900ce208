// the first finger of the LEAP hand.
//
// data:     google-deepmind/mujoco_menagerie, commit 1f2300db40ca,
//           leap_hand/right_hand.xml;
//           MIT, Ananye Agarwal; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   right_hand.xml (MJCF), bodies of 'palm' to 'if_ds', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact, sensor
// read:     axes were turned by up to 6e-06 rad onto axes of their frames or of their neighbours', joints 'if_mcp',
//           'if_rot', 'if_pip' (--right-angles 0 reads what is written)
// assumed:  no rotor inertias, where a joint has no armature: if_mcp, if_rot, if_pip, if_dip
// assumed:  speed limit of half a turn a second: if_mcp, if_rot, if_pip, if_dip
// assumed:  acceleration limits that reach full speed in 0.25 s: if_mcp, if_rot, if_pip, if_dip
// assumed:  no effort limit: if_mcp, if_rot, if_pip, if_dip
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 2.2e-16 (bound 1e-12), torques within 3.8e-16 of the largest, mass matrix within
//           3.5e-16 of its largest entry (bound 1e-09), bodies within 1.1e-16 (bound 1e-11)
// verified: no angle is read more than 8.5e-06 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 1.2e-15, torques with
//           rotors within 7.8e-16 of the largest, mass matrix within 2.7e-15, bodies within 6.2e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// the first finger of the LEAP hand.
struct LeapFinger {
  static constexpr const char* name = "leap_finger";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, 9.81),
      axial::base(0.0, 0.0, -0.0187),
      axial::tool(axial::FixedPose{{0.0, -1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0},
                                   {0.0, 0.0, 0.0141}}),
      // 0: if_mcp moves if_bs
      axial::revolute().a(-0.007).alpha_deg(-90).d(0.0085)
          .mass(0.044).com(0.033882, -0.022516, -0.001859).inertia_com(1.0300995041235658e-05, 1.3160000535129737e-05, 1.7400024423634606e-05, 4.265995196931936e-06, 1.615770023854572e-07, -5.070744192178326e-07)
          .viscous(0.03).coulomb(0.001)
          .position_limits(-0.314, 2.23).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 1: if_rot moves if_px
      axial::revolute().a(0.0381).alpha_deg(-90).d(8e-04)
          .mass(0.032).com(0.0075, 2e-04, -0.002).inertia_com(3.0933e-06, 4.3733e-06, 4.8853e-06)
          .viscous(0.03).coulomb(0.001)
          .position_limits(-1.047, 1.047).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 2: if_pip moves if_md
      axial::revolute().a(0.015).alpha_deg(90)
          .mass(0.037).com(0.029148, -0.0054215, -7e-04).inertia_com(5.999400257219236e-06, 7.675799742780765e-06, 8.1598e-06, 1.1739055945016445e-06, 0.0, 0.0)
          .viscous(0.03).coulomb(0.001)
          .position_limits(-0.506, 1.885).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 3: if_dip moves if_ds
      axial::revolute().a(0.0361)
          .mass(0.016).com(0.027019, 0.0008794, -0.000494).inertia_com(1.6594987729162232e-06, 3.711095050149513e-06, 3.0237961769342636e-06, -1.245595353914148e-07, -1.4951659382543072e-08, -1.2590378527392363e-09)
          .viscous(0.03).coulomb(0.001)
          .position_limits(-0.366, 2.042).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172)
  );
  // clang-format on
};

}  // namespace robots
