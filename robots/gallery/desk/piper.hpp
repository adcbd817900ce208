// AgileX Piper, its fingers held.
//
// data:     google-deepmind/mujoco_menagerie, commit 1f2300db40ca,
//           agilex_piper/piper.xml;
//           MIT, RosenYin; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   piper.xml (MJCF), bodies of 'world' to 'link6', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact, keyframe
// read:     gravcomp of body 'base_link' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link1' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link2' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link3' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link4' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link5' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link6' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link7' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link8' is not taken over: its weight is held by the joints, as that of the others
// read:     joints beside the chain are held where the file draws them (or at their nearest limit), their bodies
//           carried along: joint7, joint8
// read:     axes were turned by up to 4.2e-06 rad onto axes of their frames or of their neighbours', joints 'joint1',
//           'joint2', 'joint4', 'joint5', 'joint6' (--right-angles 0 reads what is written)
// assumed:  speed limit of half a turn a second: joint1, joint2, joint3, joint4, joint5, joint6
// assumed:  acceleration limits that reach full speed in 0.25 s: joint1, joint2, joint3, joint4, joint5, joint6
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 1.8e-15 (bound 1e-12), torques within 9.5e-16 of the largest, mass matrix within
//           6.5e-16 of its largest entry (bound 1e-09), bodies within 2.8e-16 (bound 1e-11)
// verified: no angle is read more than 5.7e-06 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 1.6e-15, torques with
//           rotors within 9.5e-16 of the largest, mass matrix within 7.5e-16, bodies within 4.3e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// AgileX Piper, its fingers held.
struct Piper {
  static constexpr const char* name = "piper";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(0.0, 0.0, 0.091),
      // 0: joint1 moves link1
      axial::revolute().d(0.123)
          .mass(0.097868).com(0.000310289, -0.00131676, -0.00922875).inertia_com(9.249676255857056e-05, 7.766844442882393e-05, 8.245889301260552e-05, -1.0909275291230962e-07, 9.912790176638127e-07, 1.9748077041309125e-06)
          .rotor_inertia(0.005, 1.0)
          .coulomb(0.3)
          .position_limits(-2.618, 2.618).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(100.0),
      // 1: joint2 moves link2
      axial::revolute().alpha_deg(-90).theta(0.10095333204216182)
          .mass(0.290889).com(-0.1477925016071721, 0.017403695342280926, 0.00175155).inertia_com(0.00015020373572641844, 0.0017267619684502484, 0.001775464295823333, 8.605294670262243e-05, 1.0743640435742207e-06, 9.938449583198785e-07)
          .rotor_inertia(0.005, 1.0)
          .coulomb(0.3)
          .position_limits(0.0, 3.14).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(100.0),
      // 2: joint3 moves link3
      axial::revolute().a(-0.2850312254403015).theta(1.382596578038378)
          .mass(0.290848).com(-0.015681093953564845, -0.10446169249997565, 0.000508026).inertia_com(0.00022176842211298994, 0.0001008620997984868, 0.00024192347808852326, -7.576624985538873e-06, 6.370345381200431e-07, 8.163813318877471e-07)
          .rotor_inertia(0.005, 1.0)
          .coulomb(0.3)
          .position_limits(-2.697, 0.0).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(100.0),
      // 3: joint4 moves link4
      axial::revolute().a(-0.021989786550071676).alpha_deg(90).d(0.25075147374139656)
          .mass(0.127087).com(-0.0002764657337093207, 0.001028039802687409, -0.00472831).inertia_com(3.820118029020758e-05, 4.870488462370452e-05, 4.105923508608789e-05, -4.923858591229886e-08, -4.8964970357348714e-08, -6.708617117425517e-08)
          .rotor_inertia(0.005, 1.0)
          .coulomb(0.3)
          .position_limits(-1.832, 1.832).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(100.0),
      // 4: joint5 moves link5
      axial::revolute().alpha_deg(-90).d(0.0014165)
          .mass(0.144711).com(-8.82262e-05, -0.0566829, -0.0033777).inertia_com(0.001, 0.001, 0.001)
          .rotor_inertia(0.005, 1.0)
          .coulomb(0.3)
          .position_limits(-1.22, 1.22).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(100.0),
      // 5: joint6 moves link6
      axial::revolute().alpha_deg(90)
          .mass(1.2529645).com(0.00098760898251464, 0.01166139930044662, 0.12494550220344826).inertia_com(0.0031751748287140763, 0.0031632192465778012, 0.003012071641324401, -5.014054680312546e-07, 2.966695237261952e-06, 3.5029270798519086e-05)
          .rotor_inertia(0.005, 1.0)
          .coulomb(0.3)
          .position_limits(-3.14, 3.14).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(100.0)
  );
  // clang-format on
};

}  // namespace robots
