// a leg of the ANYbotics ANYmal C.
//
// data:     PickNikRobotics/mujoco_menagerie, commit d43f1b4e2247,
//           anybotics_anymal_c/anymal_c.xml;
//           BSD-3-Clause, ANYbotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   anymal_c.xml (MJCF), bodies of 'base' to 'LF_SHANK', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact
// read:     joint 'joint0' is free: body 'base' is the base, fixed unless a scene names FloatingBase
// read:     axes were turned by up to 7.7e-07 rad onto axes of their frames or of their neighbours', joints 'LF_HFE'
//           (--right-angles 0 reads what is written)
// read:     origins were shifted by up to 8.1e-09 m, which is finer than the file's digits, 'LF_HFE' (--right-angles 0
//           reads what is written)
// assumed:  no rotor inertias, where a joint has no armature: LF_HAA, LF_HFE, LF_KFE
// assumed:  speed limit of half a turn a second: LF_HAA, LF_HFE, LF_KFE
// assumed:  acceleration limits that reach full speed in 0.25 s: LF_HAA, LF_HFE, LF_KFE
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 3.3e-16 (bound 1e-12), torques within 3.4e-16 of the largest, mass matrix within
//           3.7e-16 of its largest entry (bound 1e-09), bodies within 1.1e-16 (bound 1e-11)
// verified: no angle is read more than 7.7e-07 rad, no origin more than 9.4e-09 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 7.8e-16, torques with
//           rotors within 1e-15 of the largest, mass matrix within 2.5e-15, bodies within 5.4e-16, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// a leg of the ANYbotics ANYmal C.
struct AnymalCLeg {
  static constexpr const char* name = "anymal_c_leg";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::base(axial::FixedPose{{0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 0.0}}),
      axial::tool(axial::FixedPose{{0.0, 0.0, 1.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0},
                                   {0.0, 0.0, 0.18411000944732026}}),
      axial::base_body().mass(19.2035).com(0.0, -0.0025, 0.0502071).inertia_com(0.639559, 0.217374, 0.624031),
      // 0: LF_HAA moves LF_HIP
      axial::revolute().a(0.104).alpha_deg(90).d(0.3598).theta_deg(90)
          .mass(2.781).com(-0.00046085668385612894, -0.0173939126070745, -0.0032394).inertia_com(0.005832954089114315, 0.0049383028619255824, 0.0032955230489601023, -0.00013580873831618397, -9.791382795497403e-05, 4.4533988925550867e-05)
          .viscous(1.0).coulomb(0.1)
          .position_limits(-0.72, 0.49).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(80.0),
      // 1: LF_HFE moves LF_THIGH
      axial::revolute().alpha_deg(90)
          .mass(3.071).com(-0.245696, -4.64995e-05, 0.11462470944732027).inertia_com(0.004861082349076359, 0.02990406024438156, 0.02956380740654208, -9.444761492811437e-05, 0.004142436099379033, -4.4298185492099526e-05)
          .viscous(1.0).coulomb(0.1)
          .position_limits(-9.42478, 9.42478).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(80.0),
      // 2: LF_KFE moves LF_SHANK
      axial::revolute().a(-0.285)
          .mass(0.58842).com(-0.0806598, 0.0612528, 0.18957200944732028).inertia_com(0.0015497833337842469, 0.008810382484522117, 0.010161184181693634, 0.0018193582706213362, -2.2660088319322836e-05, 5.357319659918668e-05)
          .viscous(1.0).coulomb(0.1)
          .position_limits(-9.42478, 9.42478).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(80.0)
  );
  // clang-format on
};

}  // namespace robots
