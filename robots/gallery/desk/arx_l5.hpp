// ARX L5, its fingers held.
//
// data:     google-deepmind/mujoco_menagerie, commit 1f2300db40ca,
//           arx_l5/arx_l5.xml;
//           BSD-3-Clause, ARXrobotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   arx_l5.xml (MJCF), bodies of 'world' to 'link6', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact, keyframe
// read:     gravcomp of body 'link7' is not taken over: its weight is held by the joints, as that of the others
// read:     gravcomp of body 'link8' is not taken over: its weight is held by the joints, as that of the others
// read:     joints beside the chain are held where the file draws them (or at their nearest limit), their bodies
//           carried along: joint7, joint8
// read:     axes were turned by up to 7.3e-06 rad onto axes of their frames or of their neighbours', joints 'joint3',
//           'joint6' (--right-angles 0 reads what is written)
// assumed:  no rotor inertias, where a joint has no armature: joint1, joint2, joint3, joint4, joint5, joint6
// assumed:  speed limit of half a turn a second: joint1, joint2, joint3, joint4, joint5, joint6
// assumed:  acceleration limits that reach full speed in 0.25 s: joint1, joint2, joint3, joint4, joint5, joint6
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 4.4e-16 (bound 1e-12), torques within 9.5e-16 of the largest, mass matrix within
//           1.7e-15 of its largest entry (bound 1e-09), bodies within 7.7e-15 (bound 1e-11)
// verified: no angle is read more than 7.3e-06 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 1e-15, torques with
//           rotors within 4.3e-16 of the largest, mass matrix within 7.8e-16, bodies within 2.8e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// ARX L5, its fingers held.
struct ArxL5 {
  static constexpr const char* name = "arx_l5";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(axial::FixedPose{{0.0, -1.0, 0.0, 0.0, 0.0, -1.0, 1.0, 0.0, 0.0},
                                   {0.0, 0.0, 0.025286}}),
      // 0: joint1 moves link1
      axial::revolute().d(0.1035)
          .mass(0.096804).com(0.0050395, -0.0077407, -0.026103).inertia_com(0.00011000007349838501, 4.999999114069343e-05, 0.00010000003536092157, -9.99995220598826e-06, 1.0000036627066957e-05, -9.999978329362814e-06)
          .position_limits(-3.14, 3.14).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(100.0),
      // 1: joint2 moves link2
      axial::revolute().a(0.02).alpha_deg(-90)
          .mass(1.1988).com(-0.12992, 2.6366e-05, -0.0011822).inertia_com(0.0006499997466641572, 0.01646, 0.016469995253335843, 0.0, 8.002033634126522e-05, 0.0)
          .position_limits(0.0, 3.14).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(100.0),
      // 2: joint3 moves link3
      axial::revolute().a(-0.264).alpha_deg(180).theta(0.2401710078601731)
          .mass(0.84082).com(0.17014135718280804, 0.01449472924866627, 0.0011723).inertia_com(0.0015874342455415298, 0.007572569784804651, 0.008489999969653819, 0.0023936897563951284, 7.53335431460872e-05, -2.8745369122313654e-05)
          .position_limits(0.0, 3.14).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(100.0),
      // 3: joint4 moves link4
      axial::revolute().a(0.2522399651125888).theta(-0.2401710078601731)
          .mass(0.12432).com(0.041751, 0.03337, 0.0053736).inertia_com(0.00022000000760277706, 0.00016999978662045928, 0.00025000020577676364, 9.00000349321094e-05, -1.9999924840330122e-05, -1.999997423189146e-05)
          .position_limits(-1.7, 1.7).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(100.0),
      // 4: joint5 moves link5
      axial::revolute().a(0.073914).alpha_deg(90).theta_deg(90)
          .mass(0.63601).com(-1.5428e-05, 8.3435e-05, -0.031175).inertia_com(0.00082, 0.0008400003042391945, 0.0002599996957608055, 0.0, 0.0, -7.00001127297278e-05)
          .position_limits(-1.7, 1.7).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(100.0),
      // 5: joint6 moves link6
      axial::revolute().alpha_deg(90)
          .mass(0.5704862).com(-1.845042295e-05, 8.1045328e-06, 0.0770960139976066).inertia_com(0.0005394855530865352, 0.0007962579512528638, 0.00045875828540765, 5.980615209557895e-06, -1.1614358992658074e-07, -2.997985192195717e-06)
          .position_limits(-3.14, 3.14).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(100.0)
  );
  // clang-format on
};

}  // namespace robots
