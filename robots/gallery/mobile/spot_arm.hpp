// the arm of the Boston Dynamics Spot, its jaw held.
//
// data:     google-deepmind/mujoco_menagerie, commit 1f2300db40ca,
//           boston_dynamics_spot/spot_arm.xml;
//           BSD-3-Clause, Clearpath Robotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   spot_arm.xml (MJCF), bodies of 'body' to 'arm_link_wr1', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact, keyframe, visual
// read:     joint 'freejoint' is free: body 'body' is the base, fixed unless a scene names FloatingBase
// read:     joints beside the chain are held where the file draws them (or at their nearest limit), their bodies
//           carried along: arm_f1x
// assumed:  no rotor inertias, where a joint has no armature: arm_sh0, arm_sh1, arm_el0, arm_el1, arm_wr0, arm_wr1
// assumed:  speed limit of half a turn a second: arm_sh0, arm_sh1, arm_el0, arm_el1, arm_wr0, arm_wr1
// assumed:  acceleration limits that reach full speed in 0.25 s: arm_sh0, arm_sh1, arm_el0, arm_el1, arm_wr0, arm_wr1
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 3.3e-16 (bound 1e-12), torques within 5e-16 of the largest, mass matrix within
//           5.1e-16 of its largest entry (bound 1e-09), bodies within 8.8e-16 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 5.6e-16, torques with
//           rotors within 4.2e-16 of the largest, mass matrix within 7e-16, bodies within 2.3e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// the arm of the Boston Dynamics Spot, its jaw held.
struct SpotArm {
  static constexpr const char* name = "spot_arm";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(axial::FixedPose{{0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0},
                                   {0.0, 0.0, 0.0}}),
      axial::base_body().mass(32.86).com(0.0063944, -9.81216e-05, 0.000911379).inertia_com(0.13144, 0.13144, 0.13144),
      // 0: arm_sh0 moves arm_link_sh0
      axial::revolute().a(0.292).d(0.188)
          .mass(2.3364).com(-0.0123727, -4.52114e-05, -0.021032).inertia_com(0.0090143, 0.0058351, 0.00778748)
          .position_limits(-2.61799, 3.14159).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(1000.0),
      // 1: arm_sh1 moves arm_link_sh1
      axial::revolute().alpha_deg(-90)
          .mass(0.259601).com(2.483296844e-05, 1.005888853e-05, 2.4041851e-06).inertia_com(0.00020292863498130048, 0.00020389066648216002, 0.0001708265387698871, 9.357099e-12, 3.28535038e-10, -1.05816e-13)
          .position_limits(-3.14159, 0.523599).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(1000.0),
      // 2: arm_el0 moves arm_link_el0
      axial::revolute().a(0.3385).theta_deg(90)
          .mass(0.725).com(-0.048272, -0.0553741, 0.000236034).inertia_com(0.00197228, 0.000821537, 0.00200479)
          .position_limits(0.0, 3.14159).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(1000.0),
      // 3: arm_el1 moves arm_link_el1
      axial::revolute().a(-0.075).alpha_deg(90).d(0.4033)
          .mass(0.725).com(-0.000101579, -0.0136845, -0.125784).inertia_com(0.00451592, 0.00440245, 0.000625481)
          .position_limits(-2.79253, 2.79253).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(1000.0),
      // 4: arm_wr0 moves arm_link_wr0
      axial::revolute().alpha_deg(-90)
          .mass(0.98).com(-3.14348e-05, -0.00821068, -0.012051).inertia_com(0.00123549, 0.000985132, 0.000891615)
          .position_limits(-1.8326, 1.8326).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(1000.0),
      // 5: arm_wr1 moves arm_link_wr1
      axial::revolute().alpha_deg(90)
          .mass(0.985).com(0.01145381725888325, 3.88070964467005e-05, 0.13332245685279187).inertia_com(0.00233018176023269, 0.002345626534201523, 0.0009364500427693805, -6.154161032e-07, 8.02082854517665e-05, 1.972493555173401e-06)
          .position_limits(-2.87979, 2.87979).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(1000.0)
  );
  // clang-format on
};

}  // namespace robots
