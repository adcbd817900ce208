// Franka Research 3.
//
// data:     google-deepmind/mujoco_menagerie, commit 1f2300db40ca,
//           franka_fr3/fr3.xml;
//           Apache-2.0, Franka Robotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   fr3.xml (MJCF), bodies of 'world' to 'attachment_site', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact, keyframe
// read:     tool: frame of link 'attachment_site', the chain's only end
// assumed:  speed limit of half a turn a second: fr3_joint1, fr3_joint2, fr3_joint3, fr3_joint4, fr3_joint5,
//           fr3_joint6, fr3_joint7
// assumed:  acceleration limits that reach full speed in 0.25 s: fr3_joint1, fr3_joint2, fr3_joint3, fr3_joint4,
//           fr3_joint5, fr3_joint6, fr3_joint7
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 3.3e-16 (bound 1e-12), torques within 4.1e-16 of the largest, mass matrix within
//           5.2e-16 of its largest entry (bound 1e-09), bodies within 8.5e-17 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 1.6e-15, torques with
//           rotors within 6.7e-16 of the largest, mass matrix within 1.8e-15, bodies within 3e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Franka Research 3.
struct Fr3 {
  static constexpr const char* name = "fr3";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(0.0, 0.0, 0.107),
      // 0: fr3_joint1 moves fr3_link1
      axial::revolute().d(0.333)
          .mass(2.92747).com(4.128e-07, -0.0181251, -0.0386036).inertia_com(0.023927294745327204, 0.022482145850047305, 0.006350099404625492, 1.3317329788107941e-05, -0.0001140513221704633, -0.0019950291857125674)
          .rotor_inertia(0.195, 1.0)
          .viscous(0.21).coulomb(1.137)
          .position_limits(-2.7437, 2.7437).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(87.0),
      // 1: fr3_joint2 moves fr3_link2
      axial::revolute().alpha_deg(-90)
          .mass(2.93554).com(0.00318289, -0.0743222, 0.00881461).inertia_com(0.041938889889479414, 0.025145189270313593, 0.06170212084020699, 0.00020260103310274486, 0.004077780185739447, -0.0042252317945335625)
          .rotor_inertia(0.195, 1.0)
          .viscous(0.21).coulomb(1.137)
          .position_limits(-1.7837, 1.7837).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(87.0),
      // 2: fr3_joint3 moves fr3_link3
      axial::revolute().alpha_deg(90).d(0.316)
          .mass(2.2449).com(0.0407016, -0.00482006, -0.0289731).inertia_com(0.02410144205687311, 0.019740547576264325, 0.01904451036686257, 0.002404684264507142, -0.002856268891830052, -0.0021042136745217225)
          .rotor_inertia(0.195, 1.0)
          .viscous(0.21).coulomb(1.137)
          .position_limits(-2.9007, 2.9007).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(87.0),
      // 3: fr3_joint4 moves fr3_link4
      axial::revolute().a(0.0825).alpha_deg(90)
          .mass(2.6156).com(-0.0459101, 0.0630493, -0.00851879).inertia_com(0.03453001857862381, 0.028881656941558167, 0.04125472447981802, 0.013225509072017234, 0.010151429202577257, -0.0009763068693925266)
          .rotor_inertia(0.195, 1.0)
          .viscous(0.21).coulomb(1.137)
          .position_limits(-3.0421, -0.1518).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(87.0),
      // 4: fr3_joint5 moves fr3_link5
      axial::revolute().a(-0.0825).alpha_deg(-90).d(0.384)
          .mass(2.32712).com(-0.00160396, 0.0292536, -0.0972966).inertia_com(0.051610314507960435, 0.04787733488563761, 0.01642365060640195, -0.0057151824164361625, -0.0035673163771816822, 0.010673987029003022)
          .rotor_inertia(0.074, 1.0)
          .viscous(0.21).coulomb(0.763)
          .position_limits(-2.8065, 2.8065).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(12.0),
      // 5: fr3_joint6 moves fr3_link6
      axial::revolute().alpha_deg(90)
          .mass(1.81704).com(0.0597131, -0.0410295, -0.0101693).inertia_com(0.005412321871612688, 0.014058346410593482, 0.01608082171779383, 0.006193448335563163, 0.0014219245230394908, -0.001314072230401395)
          .rotor_inertia(0.074, 1.0)
          .viscous(0.21).coulomb(0.44)
          .position_limits(0.5445, 4.5169).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(12.0),
      // 6: fr3_joint7 moves fr3_link7
      axial::revolute().a(0.088).alpha_deg(90)
          .mass(0.627143).com(0.00452258, 0.00862619, -0.0161633).inertia_com(0.00021092439447223258, 0.00017718573600009237, 5.9932001527675035e-05, -2.4333028859916815e-05, 4.564477394166847e-05, 8.744084831776463e-05)
          .rotor_inertia(0.074, 1.0)
          .viscous(0.21).coulomb(0.248)
          .position_limits(-3.0159, 3.0159).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(12.0)
  );
  // clang-format on
};

}  // namespace robots
