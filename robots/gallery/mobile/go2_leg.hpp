// a leg of the Unitree Go2.
//
// data:     PickNikRobotics/mujoco_menagerie, commit d43f1b4e2247,
//           unitree_go2/go2.xml;
//           BSD-3-Clause, Unitree Robotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   go2.xml (MJCF), bodies of 'base' to 'FL_calf', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, keyframe
// read:     joint 'joint0' is free: body 'base' is the base, fixed unless a scene names FloatingBase
// assumed:  speed limit of half a turn a second: FL_hip_joint, FL_thigh_joint, FL_calf_joint
// assumed:  acceleration limits that reach full speed in 0.25 s: FL_hip_joint, FL_thigh_joint, FL_calf_joint
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 2.2e-16 (bound 1e-12), torques within 2.9e-16 of the largest, mass matrix within
//           2.8e-16 of its largest entry (bound 1e-09), bodies within 6.3e-17 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 5.6e-16, torques with
//           rotors within 4.6e-16 of the largest, mass matrix within 7.6e-16, bodies within 3.9e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// a leg of the Unitree Go2.
struct Go2Leg {
  static constexpr const char* name = "go2_leg";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::base(axial::FixedPose{{0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 0.0}}),
      axial::tool(axial::FixedPose{{0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0},
                                   {0.0, 0.0, 0.0955}}),
      axial::base_body().mass(6.921).com(0.0, -0.021112, -0.005366).inertia_com(0.0980769911862011, 0.02448001076845712, 0.10700019804534178, -0.00012165981636169433, -3.1200472825479954e-05, -0.0014848088689877236),
      // 0: FL_hip_joint moves FL_hip
      axial::revolute().a(0.0465).alpha_deg(90).d(0.1934).theta_deg(90)
          .mass(0.678).com(-0.000105, -0.00194, -0.0054).inertia_com(0.0005959996664285152, 0.0008840004917065919, 0.0004799998418648929, 1.4200337819249773e-06, 1.109948638849029e-06, 3.010076696263039e-06)
          .rotor_inertia(0.01, 1.0)
          .viscous(2.0).coulomb(0.2)
          .position_limits(-1.0472, 1.0472).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(23.7),
      // 1: FL_thigh_joint moves FL_thigh
      axial::revolute().alpha_deg(90)
          .mass(1.152).com(-0.0327, -0.00374, 0.0732).inertia_com(0.001030000225806019, 0.005840003381089966, 0.005800003393104016, -0.0002890007165841475, 0.0008080003950198985, 8.719995117917713e-05)
          .rotor_inertia(0.01, 1.0)
          .viscous(2.0).coulomb(0.2)
          .position_limits(-1.5708, 3.4907).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(23.7),
      // 2: FL_calf_joint moves FL_calf
      axial::revolute().a(-0.213)
          .mass(0.241352).com(-0.141417, 0.00629595, 0.094877879).inertia_com(5.326932941619464e-05, 0.0014635374889026553, 0.00148999288168115, 5.966814216748572e-06, 1.224786879851145e-05, 2.1754499065184987e-07)
          .rotor_inertia(0.01, 1.0)
          .viscous(2.0).coulomb(0.2)
          .position_limits(-2.7227, -0.83776).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(45.43)
  );
  // clang-format on
};

}  // namespace robots
