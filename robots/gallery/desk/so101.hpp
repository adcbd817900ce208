// SO-101 with its jaw.
//
// data:     TheRobotStudio/SO-ARM100, commit fda892cba810,
//           Simulation/SO101/so101_new_calib.xml;
//           Apache-2.0, The Robot Studio; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   so101_new_calib.xml (MJCF), bodies of 'world' to 'moving_jaw_so101_v1', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset
// read:     tool: frame of link 'moving_jaw_so101_v1', the chain's only end
// read:     axes were turned by up to 2.3e-07 rad onto axes of their frames or of their neighbours', joints
//           'shoulder_lift' (--right-angles 0 reads what is written)
// read:     origins were shifted by up to 4.2e-09 m, which is finer than the file's digits, 'shoulder_lift'
//           (--right-angles 0 reads what is written)
// assumed:  speed limit of half a turn a second: shoulder_pan, shoulder_lift, elbow_flex, wrist_flex, wrist_roll,
//           gripper
// assumed:  acceleration limits that reach full speed in 0.25 s: shoulder_pan, shoulder_lift, elbow_flex, wrist_flex,
//           wrist_roll, gripper
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 4.4e-15 (bound 1e-12), torques within 1.1e-15 of the largest, mass matrix within
//           3.7e-16 of its largest entry (bound 1e-09), bodies within 7.4e-15 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 1.1e-15, torques with
//           rotors within 4.6e-11 of the largest, mass matrix within 1.1e-10, bodies within 2.6e-08, what joints have
//           within 0 (bound of each 1e-06)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// SO-101 with its jaw.
struct So101 {
  static constexpr const char* name = "so101";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::base(axial::FixedPose{{0.9999999999999732, 2.311446e-07, 0.0, -2.311446e-07, 0.9999999999999732, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 0.0}}),
      axial::tool(axial::FixedPose{{1.0, -5.2428275e-08, 0.0, 5.2428275e-08, 1.0, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, -0.0188}}),
      // 0: shoulder_pan moves shoulder
      axial::revolute().a(0.0388353).alpha_deg(180).d(-0.1166)
          .mass(0.100006).com(0.030760400003852984, 1.66655899e-05, 0.0289287).inertia_com(8.375900003492696e-05, 8.104029996507304e-05, 2.39783e-05, 7.555187158715676e-08, 1.163419964250451e-06, -1.546632689182512e-07)
          .rotor_inertia(0.028, 1.0)
          .viscous(0.6).coulomb(0.052)
          .position_limits(-1.9198621771937616, 1.9198621771937634).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(3.35),
      // 1: shoulder_lift moves upper_arm
      axial::revolute().a(0.0303992).alpha_deg(90).theta(-1.3270094336148002)
          .mass(0.103).com(0.08921369726504619, -0.013552842732367593, 0.0001311070266115342).inertia_com(3.7738848569606275e-05, 0.00015037935143039373, 0.000142487, 7.474173910020642e-06, 3.6943957342383296e-08, -1.8435899041561493e-08)
          .rotor_inertia(0.028, 1.0)
          .viscous(0.6).coulomb(0.052)
          .position_limits(-1.7453292519943224, 1.7453292519943366).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(3.35),
      // 2: elbow_flex moves lower_arm
      axial::revolute().a(0.11600002112068773).theta(1.2884814367726618)
          .mass(0.104).com(0.09812226571275937, 0.000536157012679494, 5.30702661e-06).inertia_com(2.83677726809419e-05, 0.0001602200273190581, 0.00014529, 2.343496411719042e-06, -1.2650400332854446e-06, 2.91615304e-10)
          .rotor_inertia(0.028, 1.0)
          .viscous(0.6).coulomb(0.052)
          .position_limits(-1.69, 1.69).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(3.35),
      // 3: wrist_flex moves wrist
      axial::revolute().a(0.1350001851850582).d(-0.00017779297338791616).theta(-1.5322683299527582)
          .mass(0.079).com(0.000103312, 0.0386143, 0.0100156).inertia_com(3.68263e-05, 2.5391e-05, 2.1e-05, 1.7893e-08, 5.28128e-08, -3.6412e-06)
          .rotor_inertia(0.028, 1.0)
          .viscous(0.6).coulomb(0.052)
          .position_limits(-1.6580628494556928, 1.6580627293335335).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(3.35),
      // 4: wrist_roll moves gripper
      axial::revolute().alpha_deg(90).d(-0.0845).theta(-0.04867951485346194)
          .mass(0.087).com(0.000213627, 0.000245138, -0.001787).inertia_com(2.75087e-05, 4.33657e-05, 3.45059e-05, -3.35241e-07, -5.7352e-06, -5.17847e-08)
          .rotor_inertia(0.028, 1.0)
          .viscous(0.6).coulomb(0.052)
          .position_limits(-2.7438472969992493, 2.841206309382605).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(3.35),
      // 5: gripper moves moving_jaw_so101_v1
      axial::revolute().a(0.0202).alpha_deg(90)
          .mass(0.012).com(-0.0015749484258725085, -0.03002440008257187, 0.0004755).inertia_com(6.6142700335338454e-06, 1.8903199664661546e-06, 5.28738e-06, -3.1980675233145027e-07, -5.907164235773336e-09, -1.0994500030970257e-07)
          .rotor_inertia(0.028, 1.0)
          .viscous(0.6).coulomb(0.052)
          .position_limits(-0.17453297762778586, 1.7453291995659765).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(3.35)
  );
  // clang-format on
};

}  // namespace robots
