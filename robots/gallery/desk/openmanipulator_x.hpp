// ROBOTIS OpenManipulator-X, its fingers held.
//
// data:     ROBOTIS-GIT/robotis_mujoco_menagerie, commit d8344c0dbe7a,
//           robotis_open_manipulator_x/open_manipulator_x.xml;
//           Apache-2.0, ROBOTIS; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   open_manipulator_x.xml (MJCF), bodies of 'world' to 'link5', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact, keyframe
// read:     joints beside the chain are held where the file draws them (or at their nearest limit), their bodies
//           carried along: Gripper, Gripper_mimic
// assumed:  speed limit of half a turn a second: Joint1, Joint2, Joint3, Joint4
// assumed:  acceleration limits that reach full speed in 0.25 s: Joint1, Joint2, Joint3, Joint4
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 3.3e-16 (bound 1e-12), torques within 3.3e-16 of the largest, mass matrix within
//           1.5e-16 of its largest entry (bound 1e-09), bodies within 3.4e-15 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 4.4e-16, torques with
//           rotors within 2.6e-16 of the largest, mass matrix within 1.2e-16, bodies within 4.7e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// ROBOTIS OpenManipulator-X, its fingers held.
struct OpenmanipulatorX {
  static constexpr const char* name = "openmanipulator_x";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(axial::FixedPose{{1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0},
                                   {0.0, 0.0, 0.0}}),
      // 0: Joint1 moves link2
      axial::revolute().a(0.012).d(0.0765)
          .mass(0.0984068).com(-0.000301849, 0.000540437, -0.0120665).inertia_com(3.454347138861465e-05, 3.268929300653921e-05, 1.8850335604846143e-05, -1.6031850160558658e-08, -3.837533946447858e-07, 2.851153289259637e-08)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-3.14159, 3.14159).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(4.1),
      // 1: Joint2 moves link3
      axial::revolute().alpha_deg(-90).theta(-1.3854483767992019)
          .mass(0.138509).com(0.10185978709030574, -0.008610672939880187, 0.000377434).inertia_com(5.5574084735041656e-05, 0.000335326357376804, 0.0003429043578881544, 1.3053010036019928e-05, -1.5628790280225267e-06, 1.9339300085198154e-07)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-1.5, 1.5).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(4.1),
      // 2: Joint3 moves link4
      axial::revolute().a(0.13023056476879766).theta(1.3854483767992019)
          .mass(0.132746).com(0.0909096, -0.000224133, 0.000389298).inertia_com(3.065422450375684e-05, 0.0002515506544673849, 0.0002423033210288582, 2.68732307969723e-07, -1.276434603768357e-06, -1.1559142907742067e-08)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-1.5, 1.4).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(4.1),
      // 3: Joint4 moves link5
      axial::revolute().a(0.124)
          .mass(0.145276).com(0.04472296509265122, -0.00879149883476968, 3.63328274e-07).inertia_com(8.390945196965047e-05, 9.878216147074712e-05, 8.091001343986218e-05, 3.5653842862875796e-07, 2.72446793e-11, 6.4775763e-12)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-1.7, 1.97).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(4.1)
  );
  // clang-format on
};

}  // namespace robots
