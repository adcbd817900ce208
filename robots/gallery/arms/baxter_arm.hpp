// an arm of the Rethink Robotics Baxter, its fingers held.
//
// data:     Gepetto/example-robot-data, commit 39aa94379908,
//           robots/baxter_description/urdf/baxter.urdf;
//           BSD-3-Clause, Rethink Robotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   baxter.urdf (URDF), links of 'torso' to 'left_gripper', whose frame is the tool's
// read:     joints beside the chain are held at 0 (or their nearest limit), their bodies carried along:
//           l_gripper_l_finger_joint, l_gripper_r_finger_joint
// read:     24 angles were read as the multiples of 90 degrees that they are within 1e-05 rad of; the farthest by
//           3.2e-09 (--right-angles 0 reads what is written)
// assumed:  gravity of 9.81 m/s^2 along -z of link 'torso'
// assumed:  no rotor inertias: a URDF has none
// assumed:  acceleration limits that reach full speed in 0.25 s: left_s0, left_s1, left_e0, left_e1, left_w0, left_w1,
//           left_w2
// verified: against Orocos KDL, built from the text by another reader, on 100 random states (seed 1), axial::Model in
//           double:
// verified: frames and tool within 5e-16 (bound 1e-12), torques within 4.4e-16 of the largest, mass matrix within
//           4.1e-16 of its largest entry (bound 1e-09), bodies within 2.8e-16 (bound 1e-11)
// verified: no angle is read more than 3.2e-09 rad, no origin more than 0 m from what is written
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// an arm of the Rethink Robotics Baxter, its fingers held.
struct BaxterArm {
  static constexpr const char* name = "baxter_arm";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::base(axial::FixedPose{{0.23996120231384377, -0.970782478923108, 0.0, 0.970782478923108, 0.23996120231384377, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 0.0}}),
      axial::tool(0.0, 0.0, 0.387225),
      // 0: left_s0 moves left_upper_shoulder
      axial::revolute().a(0.2668232998962994).d(0.399976).theta_deg(-31.1156442664417)
          .mass(5.70044).com(0.01783, 0.00086, -0.07908).inertia_com(0.04709102262, 0.03766976455, 0.03595988478, 0.00012787556, 0.00614870039, 0.00078086899)
          .viscous(0.7)
          .position_limits(-1.70167993878, 1.70167993878).speed_limit(1.5).acceleration_limit(6.0).effort_limit(50.0),
      // 1: left_s1 moves left_lower_shoulder
      axial::revolute().a(0.069).alpha_deg(-90).theta_deg(90)
          .mass(3.22708).com(0.0026899166429093795, -0.06845119457838045, -0.005289836074717702).inertia_com(0.027886136603968183, 0.01175210771191086, 0.020787652309232477, 0.0003009536103713416, -0.0001882185070340959, -0.002076737227681932)
          .viscous(0.7)
          .position_limits(-2.147, 1.047).speed_limit(1.5).acceleration_limit(6.0).effort_limit(50.0),
      // 2: left_e0 moves left_upper_elbow
      axial::revolute().alpha_deg(90).d(0.36442)
          .mass(4.31272).com(-0.00276, 0.00132, -0.08156).inertia_com(0.02661733557, 0.02844355207, 0.01248008322, 0.00029270634, 0.00392189887, 0.0010838933)
          .viscous(0.7)
          .position_limits(-3.05417993878, 3.05417993878).speed_limit(1.5).acceleration_limit(6.0).effort_limit(50.0),
      // 3: left_e1 moves left_lower_elbow
      axial::revolute().a(0.069).alpha_deg(-90)
          .mass(2.07216).com(0.001589923268473477, -0.026112986738475796, -0.01116946094896147).inertia_com(0.013182684255012957, 0.007115849589085679, 0.009268913911522875, -0.0003603715700351086, -0.0001966324040557091, -0.0007458804722061869)
          .viscous(0.7)
          .position_limits(-0.05, 2.618).speed_limit(1.5).acceleration_limit(6.0).effort_limit(50.0),
      // 4: left_w0 moves left_upper_forearm
      axial::revolute().alpha_deg(90).d(0.37429)
          .mass(2.24675).com(-0.0016824399688438857, 0.00459979525981974, -0.13118086881050406).inertia_com(0.0166774784672499, 0.01675492125120817, 0.0037466241257699106, 0.00018401183392238566, 0.00018646928612281918, -0.0006473324988003472)
          .viscous(0.7)
          .position_limits(-3.059, 3.059).speed_limit(4.0).acceleration_limit(16.0).effort_limit(15.0),
      // 5: left_w1 moves left_lower_forearm
      axial::revolute().a(0.01).alpha_deg(-90)
          .mass(1.60979).com(0.00697, -0.06041, 0.006).inertia_com(0.00700537914, 0.00387607152, 0.0055275524, 0.00044384784, 0.00015348067, 0.00021115038)
          .viscous(0.7)
          .position_limits(-1.57079632679, 2.094).speed_limit(4.0).acceleration_limit(16.0).effort_limit(15.0),
      // 6: left_w2 moves left_wrist
      axial::revolute().alpha_deg(90)
          .mass(0.90268).com(0.0030977222271458328, 0.0005753714494616032, 0.20316567111268666).inertia_com(0.04378759514674829, 0.04384990003962011, 0.04056629687907552, 7.059177174762762e-06, 4.6890078066125206e-05, 2.5763463572024084e-05)
          .viscous(0.7)
          .position_limits(-3.059, 3.059).speed_limit(4.0).acceleration_limit(16.0).effort_limit(15.0)
  );
  // clang-format on
};

}  // namespace robots
