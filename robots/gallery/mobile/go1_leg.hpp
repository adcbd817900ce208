// a leg of the Unitree Go1.
//
// data:     google-deepmind/mujoco_menagerie, commit 1f2300db40ca,
//           unitree_go1/go1.xml;
//           BSD-3-Clause, Unitree Robotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   go1.xml (MJCF), bodies of 'trunk' to 'FL_calf', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, keyframe
// read:     joint 'joint0' is free: body 'trunk' is the base, fixed unless a scene names FloatingBase
// assumed:  speed limit of half a turn a second: FL_hip_joint, FL_thigh_joint, FL_calf_joint
// assumed:  acceleration limits that reach full speed in 0.25 s: FL_hip_joint, FL_thigh_joint, FL_calf_joint
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 1.1e-16 (bound 1e-12), torques within 3.3e-16 of the largest, mass matrix within
//           3.5e-16 of its largest entry (bound 1e-09), bodies within 8.9e-17 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 2.2e-16, torques with
//           rotors within 1.2e-15 of the largest, mass matrix within 7.2e-16, bodies within 3.4e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// a leg of the Unitree Go1.
struct Go1Leg {
  static constexpr const char* name = "go1_leg";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::base(axial::FixedPose{{0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 0.0}}),
      axial::tool(axial::FixedPose{{0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
                                   {0.0, 0.0, 0.08}}),
      axial::base_body().mass(5.204).com(0.002, -0.0223, -5e-04).inertia_com(0.06300954700354164, 0.016812825999284915, 0.07165472699717344, 0.00022967579570898987, -4.1873269113100054e-05, 0.00029455314731583344),
      // 0: FL_hip_joint moves FL_hip
      axial::revolute().a(0.04675).alpha_deg(90).d(0.1881).theta_deg(90)
          .mass(0.68).com(-8.865e-05, 0.00762615, -0.0049166).inertia_com(0.0004684219362908841, 0.000733419289295476, 0.0003993797744136399, -1.5751849645287403e-06, 1.2460870672928096e-06, 1.4589730974633867e-05)
          .rotor_inertia(0.01, 1.0)
          .viscous(1.0).coulomb(0.2)
          .position_limits(-0.863, 0.863).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(23.7),
      // 1: FL_thigh_joint moves FL_thigh
      axial::revolute().alpha_deg(90)
          .mass(1.009).com(-0.0305004, -0.00304722, 0.060685).inertia_com(0.0008174477185869543, 0.004598797720800477, 0.004689222560612569, -0.00022752955775863612, 0.0006108080313670359, 6.137373840168655e-05)
          .rotor_inertia(0.01, 1.0)
          .viscous(2.0).coulomb(0.2)
          .position_limits(-0.686, 4.501).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(23.7),
      // 2: FL_calf_joint moves FL_calf
      axial::revolute().a(-0.213)
          .mass(0.195862).com(-0.146197, 0.00429862, 0.080976676).inertia_com(3.6068191470958684e-05, 0.0014844887431687583, 0.001497635765360283, -1.7720040801891186e-05, -3.566275415813851e-06, -6.186249023727873e-07)
          .rotor_inertia(0.01, 1.0)
          .viscous(2.0).coulomb(0.2)
          .position_limits(-2.818, -0.888).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(35.55)
  );
  // clang-format on
};

}  // namespace robots
