// lift, arm and wrist of the Hello Robot Stretch 3.
//
// data:     hello-robot/stretch_urdf, commit c8c6e27e1f87,
//           stretch_urdf/SE3/stretch_description_SE3_eoa_wrist_dw3_tool_nil.urdf;
//           Clear BSD, Hello Robot; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// doubtful: one drive of the machine extends the arm's four slides together; the file has
//           them apart
// source:   stretch_description_SE3_eoa_wrist_dw3_tool_nil.urdf (URDF), links of 'base_link' to 'link_wrist_roll',
//           whose frame is the tool's
// read:     joints beside the chain are held at 0 (or their nearest limit), their bodies carried along: joint_head_pan,
//           joint_head_tilt
// read:     12 angles were read as the multiples of 90 degrees that they are within 1e-05 rad of; the farthest by
//           7.3e-06 (--right-angles 0 reads what is written)
// assumed:  gravity of 9.81 m/s^2 along -z of link 'base_link'
// assumed:  no rotor inertias: a URDF has none
// assumed:  acceleration limits that reach full speed in 0.25 s: joint_lift, joint_arm_l3, joint_arm_l2, joint_arm_l1,
//           joint_arm_l0, joint_wrist_yaw, joint_wrist_pitch, joint_wrist_roll
// verified: against Orocos KDL, built from the text by another reader, on 100 random states (seed 1), axial::Model in
//           double:
// verified: frames and tool within 4.6e-14 (bound 1e-12), torques within 1.4e-16 of the largest, mass matrix within
//           6.6e-17 of its largest entry (bound 1e-09), bodies within 1.2e-14 (bound 1e-11)
// verified: no angle is read more than 7.3e-06 rad, no origin more than 0 m from what is written
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// lift, arm and wrist of the Hello Robot Stretch 3.
struct StretchArm {
  static constexpr const char* name = "stretch_arm";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::base(axial::FixedPose{{0.6116926351517493, 0.7910955189489502, 0.0, -0.7910955189489502, 0.6116926351517493, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 0.0}}),
      axial::tool(axial::FixedPose{{0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 0.018859}}),
      // 0: joint_lift moves link_lift
      axial::prismatic().a(-0.17064943077842365).d(0.195).theta(0.9125978921236707)
          .mass(2.222793).com(-0.03075337497823684, -0.03193366395926206, 0.019962814853204957).inertia_com(0.008596850507647375, 0.007048280161221071, 0.012364682241676004, 0.0023222231866620053, -0.0002300274699056373, -0.00015169049290233207)
          .position_limits(0.0, 1.1).speed_limit(1.0).acceleration_limit(4.0).effort_limit(100.0),
      // 1: joint_arm_l3 moves link_arm_l3
      axial::prismatic().alpha_deg(90)
          .mass(0.146817).com(-1e-06, -0.000146, 0.14862).inertia_com(0.001081, 0.001081, 7.7e-05, 0.0, 0.0, -1e-06)
          .position_limits(0.0, 0.13).speed_limit(1.0).acceleration_limit(4.0).effort_limit(100.0),
      // 2: joint_arm_l2 moves link_arm_l2
      axial::prismatic()
          .mass(0.130565).com(0.0, -7.1e-05, 0.165065).inertia_com(0.000943, 0.000943, 5.7e-05)
          .position_limits(0.0, 0.13).speed_limit(1.0).acceleration_limit(4.0).effort_limit(100.0),
      // 3: joint_arm_l1 moves link_arm_l1
      axial::prismatic()
          .mass(0.113658).com(-1e-06, -0.000121, 0.180243).inertia_com(8e-04, 8e-04, 4e-05)
          .position_limits(0.0, 0.13).speed_limit(1.0).acceleration_limit(4.0).effort_limit(100.0),
      // 4: joint_arm_l0 moves link_arm_l0
      axial::prismatic().d(0.2799500000008013)
          .mass(0.427734).com(0.033681, -0.000847, -0.031723).inertia_com(0.001689, 0.002107, 0.000571, -2.8e-05, 0.000483, -1.1e-05)
          .position_limits(0.0, 0.13).speed_limit(1.0).acceleration_limit(4.0).effort_limit(100.0),
      // 5: joint_wrist_yaw moves link_wrist_yaw
      axial::revolute().a(0.0830000000000654).alpha_deg(-90).d(-0.0612500000000129).theta_deg(-90)
          .mass(0.198970635554334).com(-0.012005287793597897, -0.032424944866702686, 0.014591175589358046).inertia_com(0.0002120708504137886, 0.00017081242001049085, 0.00018428189496801512, -3.0337831419912376e-05, -2.9251039550449482e-05, -7.870570241665701e-05)
          .position_limits(-1.75, 4.0).speed_limit(1.0).acceleration_limit(4.0).effort_limit(100.0),
      // 6: joint_wrist_pitch moves link_wrist_pitch
      axial::revolute().alpha_deg(90).d(-9.5e-05).theta_deg(90)
          .mass(0.116590512374845).com(-0.0147442681465562, -0.000711479645697954, 3.592356805e-05).inertia_com(3.5844353951621e-05, 5.76204624498191e-05, 6.36355321976534e-05, -7.78647509857216e-07, -1.06445058968725e-06, 2.86646997376633e-08)
          .position_limits(-1.57, 0.56).speed_limit(1.0).acceleration_limit(4.0).effort_limit(100.0),
      // 7: joint_wrist_roll moves link_wrist_roll
      axial::revolute().a(-0.024).alpha_deg(90)
          .mass(0.0221916689638078).com(-0.000557472767112266, 0.000282866582415386, 0.038522545048089205).inertia_com(2.91436292743443e-06, 2.20608319376175e-06, 4.83731409646016e-06, -3.01742816614342e-09, 4.5509705441618e-08, -1.83537060988685e-08)
          .position_limits(-3.14, 3.14).speed_limit(1.0).acceleration_limit(4.0).effort_limit(100.0)
  );
  // clang-format on
};

}  // namespace robots
