// SO-100 with its jaw.
//
// data:     3DAlgoLab/so_arm_simul, commit 318cf2970acf,
//           trs_so_arm100/so_arm100.xml;
//           Apache-2.0, The Robot Studio; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   so_arm100.xml (MJCF), bodies of 'world' to 'Moving_Jaw', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact, keyframe
// read:     tool: frame of link 'Moving_Jaw', the chain's only end
// read:     axes were turned by up to 7.3e-06 rad onto axes of their frames or of their neighbours', joints 'Rotation',
//           'Pitch', 'Elbow', 'Jaw' (--right-angles 0 reads what is written)
// read:     origins were shifted by up to 4e-13 m, which is finer than the file's digits, 'Jaw' (--right-angles 0 reads
//           what is written)
// assumed:  speed limit of half a turn a second: Rotation, Pitch, Elbow, Wrist_Pitch, Wrist_Roll, Jaw
// assumed:  acceleration limits that reach full speed in 0.25 s: Rotation, Pitch, Elbow, Wrist_Pitch, Wrist_Roll, Jaw
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 6.1e-16 (bound 1e-12), torques within 3e-16 of the largest, mass matrix within
//           2.1e-16 of its largest entry (bound 1e-09), bodies within 9.1e-16 (bound 1e-11)
// verified: no angle is read more than 9.7e-06 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 1.2e-15, torques with
//           rotors within 7.5e-16 of the largest, mass matrix within 2.2e-16, bodies within 4.3e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// SO-100 with its jaw.
struct So100 {
  static constexpr const char* name = "so100";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::base(axial::FixedPose{{0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 0.0}}),
      axial::tool(axial::FixedPose{{0.9999999999730153, 7.34639676e-06, 0.0, -7.34639676e-06, 0.9999999999730153, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 1.27801257e-07}}),
      // 0: Rotation moves Rotation_Pitch
      axial::revolute().a(0.0452).d(0.119)
          .mass(0.119226).com(0.031089, -9.07886e-05, -0.0434028).inertia_com(5.8605819816992564e-05, 5.9040836380384496e-05, 3.214984380262294e-05, -5.9046937718081104e-08, -4.58022653682332e-06, 4.907910659673273e-07)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-2.2, 2.2).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0),
      // 1: Pitch moves Upper_Arm
      axial::revolute().a(0.0306).alpha_deg(-90).theta(0.24378689318009655)
          .mass(0.162409).com(0.06885462292881905, -0.013926420684176013, -1.72052e-05).inertia_com(7.952412261364132e-05, 0.00020395121036487115, 0.00016715286702148754, 3.5388700753536436e-05, 1.005502812353638e-06, -2.6249829858469916e-07)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-3.14158, 0.2).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0),
      // 2: Elbow moves Lower_Arm
      axial::revolute().a(0.11600002112068773).theta(-0.282314890022235)
          .mass(0.147968).com(0.07679678222506234, 0.001581307727151382, -0.00339604).inertia_com(5.114118822892233e-05, 0.00013850007730058787, 0.00010533393447048981, -5.152053775629198e-06, -1.1704916874799852e-05, -6.243747135263483e-07)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(0.0, 3.14158).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0),
      // 3: Wrist_Pitch moves Wrist_Pitch_Roll
      axial::revolute().a(0.13500018518505816).theta(-1.5322620031578615)
          .mass(0.0661321).com(-2.34622e-05, 0.0352279, -0.00852653).inertia_com(3.454014332443717e-05, 2.380287618639093e-05, 1.9571780489171898e-05, -4.0953208681220116e-08, 5.197324504161713e-09, 6.627147091265871e-07)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-2.0, 1.8).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0),
      // 4: Wrist_Roll moves Fixed_Jaw
      axial::revolute().alpha_deg(90).d(-0.0845)
          .mass(0.0929859).com(-0.00552376694035899, 0.0004836179477501673, -0.0036167).inertia_com(4.3328248099347486e-05, 5.024605687200024e-05, 3.0445195028652266e-05, -5.99793770320028e-07, -7.096543651906743e-06, -1.5870191203928196e-07)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-3.14158, 3.14158).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0),
      // 5: Jaw moves Moving_Jaw
      axial::revolute().a(0.0202).alpha_deg(90)
          .mass(0.0202444).com(-0.001617672943262756, -0.030347288116751647, 0.0004497738012569107).inertia_com(1.1091103670151574e-05, 3.035774097684357e-06, 8.991612232164067e-06, -5.351344731840832e-07, -9.462421145890512e-09, -1.7114679235760977e-07)
          .rotor_inertia(0.1, 1.0)
          .coulomb(0.1)
          .position_limits(-0.2, 2.0).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.0)
  );
  // clang-format on
};

}  // namespace robots
