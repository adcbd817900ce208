// HITBOT Z-Arm 10042C0, a SCARA whose first joint lifts.
//
// data:     jjh1214/hitbot_sim, commit d19aa1150f8c,
//           urdf/Z-Arm_10042C0.urdf;
//           MIT, jjh1214; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// doubtful: bodies are a drawing program's; other files beside this one give the last
//           three links a hundredth or a tenth of these masses
// source:   Z-Arm_10042C0.urdf (URDF), links of 'world' to 'link4', whose frame is the tool's
// read:     tool: frame of link 'link4', the chain's only end
// read:     3 angles were read as the multiples of 90 degrees that they are within 1e-05 rad of; the farthest by
//           7.3e-06 (--right-angles 0 reads what is written)
// assumed:  gravity of 9.81 m/s^2 along -z of link 'world'
// assumed:  no rotor inertias: a URDF has none
// assumed:  acceleration limits that reach full speed in 0.25 s: joint1, joint2, joint3, joint4
// verified: against Orocos KDL, built from the text by another reader, on 100 random states (seed 1), axial::Model in
//           double:
// verified: frames and tool within 3.9e-16 (bound 1e-12), torques within 1.8e-16 of the largest, mass matrix within
//           2.1e-17 of its largest entry (bound 1e-09), bodies within 3.8e-16 (bound 1e-11)
// verified: no angle is read more than 7.3e-06 rad, no origin more than 0 m from what is written
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// HITBOT Z-Arm 10042C0, a SCARA whose first joint lifts.
struct ZArm {
  static constexpr const char* name = "z_arm";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(axial::FixedPose{{-1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 1.10361}}),
      // 0: joint1 moves link1
      axial::prismatic()
          .mass(0.993699801386025).com(0.0814844684502057, -0.000148613714255294, 1.2317838791707967).inertia_com(0.000950142292489542, 0.0034290254131011, 0.00392515031508005, -1.44578489991647e-05, 7.33036655063474e-05, -2.09106228762866e-06)
          .position_limits(-0.95, 0.0).speed_limit(1.0).acceleration_limit(4.0).effort_limit(1.0),
      // 1: joint2 moves link2
      axial::revolute().a(0.133)
          .mass(5.85844227294122).com(0.111045959309931, 2.43604684770394e-05, 1.1685620145886457).inertia_com(0.00708782289991147, 0.0470616581346809, 0.0503399714879645, 7.1034720884927e-06, 0.000255328408086295, 3.523647279e-07)
          .position_limits(-1.571, 1.571).speed_limit(1.571).acceleration_limit(6.284).effort_limit(30.0),
      // 2: joint3 moves link3
      axial::revolute().a(0.22)
          .mass(3.43252725336984).com(0.0953068068304957, 1.46e-13, 1.1093444552597704).inertia_com(0.00328366639192851, 0.0233302625835159, 0.0254348240065591, -1.56e-14, 5.94905284720721e-05, 1e-16)
          .position_limits(-6.284, 6.284).speed_limit(1.571).acceleration_limit(6.284).effort_limit(30.0),
      // 3: joint4 moves link4
      axial::revolute().a(0.2)
          .mass(0.120587662892703).com(0.000247759291386207, 7.083e-12, 1.0826572897974114).inertia_com(5.0401439482025e-05, 5.01231671450723e-05, 8.90018861873181e-05, 1.4175e-14, 1.42422376690236e-07, -8.9692e-15)
          .position_limits(-6.284, 6.284).speed_limit(1.571).acceleration_limit(6.284).effort_limit(30.0)
  );
  // clang-format on
};

}  // namespace robots
