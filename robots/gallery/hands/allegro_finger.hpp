// the first finger of the Wonik Allegro hand.
//
// data:     RobotLocomotion/models, commit 4723170e1c8e,
//           allegro_hand_description/sdf/allegro_hand_description_right.sdf;
//           BSD, SimLab; changes BSD-3-Clause, Drake's authors; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   allegro_hand_description_right.sdf (SDF), links of 'hand_root' to 'link_3', whose frame is the tool's
// read:     not read: collision, visual
// read:     no joint fixes link 'hand_root' to the world: it is the base, fixed unless a scene names FloatingBase
// read:     origins were shifted by up to 1.9e-13 m, which is finer than the file's digits, 'joint_2' (--right-angles 0
//           reads what is written)
// assumed:  gravity of 9.81 m/s^2 along -z of the world: the file has a model alone
// assumed:  no rotor inertias: an SDF has none
// assumed:  speed limit of half a turn a second: joint_0, joint_1, joint_2, joint_3
// assumed:  acceleration limits that reach full speed in 0.25 s: joint_0, joint_1, joint_2, joint_3
// verified: against Orocos KDL on the tree of the file's links, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 5.6e-16 (bound 1e-12), torques within 6.2e-16 of the largest, mass matrix within
//           1.6e-15 of its largest entry (bound 1e-09), bodies within 1.5e-16 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 1.9e-13 m from what is written
// verified: the file as it is written against DART 6.12.1, built from the frames of libsdformat 12.3.0 on 20 of these
//           states: poses within 5.6e-16, torques with rotors within 5.1e-16 of the largest, mass matrix within
//           9.7e-16, bodies within 1.8e-16, what joints have within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// the first finger of the Wonik Allegro hand.
struct AllegroFinger {
  static constexpr const char* name = "allegro_finger";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::base(0.0, 0.0, -0.40374795828170174),
      axial::tool(axial::FixedPose{{0.0, -3.07439977e-07, 0.9999999999999527, 1.0, 0.0, 0.0, 0.0, 0.9999999999999527, 3.07439977e-07},
                                   {0.0, 0.0, 4.26968862e-07}}),
      axial::base_body().mass(0.4154).com(0.0, 0.0, 0.40374795828170174).inertia_com(0.002089, 0.001829, 0.0004825, -3.635e-06, 0.0002233, -1.756e-05),
      // 0: joint_0 moves link_0
      axial::revolute().alpha(-0.087266692560023).d(0.5155055888431128)
          .mass(0.0119).com(0.0, 0.0, -0.01640037453371962).inertia_com(1.954e-06, 1.1789999772064303e-06, 1.4970000227935698e-06, 3.034027432869005e-09, 8.922999906722289e-08, -3.7069902234080303e-08)
          .viscous(0.015)
          .position_limits(-0.47, 0.47).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(0.7),
      // 1: joint_1 moves link_1
      axial::revolute().alpha_deg(-90).theta_deg(-90)
          .mass(0.065).com(0.0, 0.0, -3.92072873e-07).inertia_com(5.405999549791417e-06, 7.192e-05, 7.438000045020859e-05, 0.0, 7.321787946348876e-07, 0.0)
          .viscous(0.015)
          .position_limits(-0.196, 1.61).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(0.7),
      // 2: joint_2 moves link_2
      axial::revolute().a(0.05399953967059266)
          .mass(0.0355).com(0.0, 0.0, 2.27927926e-07).inertia_com(3.2029999761760338e-06, 3.169e-05, 3.105000002382397e-05, -4.913000329267983e-09, 3.874143871895303e-08, 1.0709984895473424e-09)
          .viscous(0.015)
          .position_limits(-0.174, 1.709).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(0.7),
      // 3: joint_3 moves link_3
      axial::revolute().a(0.03840014225188419)
          .mass(0.0264).com(0.0, 0.0, 4.26968862e-07).inertia_com(2.484000007994322e-06, 1.263e-05, 1.1819999992005678e-05, -9.80000064562349e-09, -1.3002870259622855e-08, 2.0999969870881264e-09)
          .viscous(0.015)
          .position_limits(-0.227, 1.618).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(0.7)
  );
  // clang-format on
};

}  // namespace robots
