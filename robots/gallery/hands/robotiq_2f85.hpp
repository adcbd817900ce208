// Robotiq 2F-85, both fingers.
//
// data:     Kinovarobotics/ros2_kortex, commit 1fdbef345954,
//           kortex_description/robots/gen3_2f85.urdf;
//           BSD-3-Clause, Kinova; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   gen3_2f85.urdf (URDF), links of 'gen3_robotiq_85_base_link'
// assumed:  gravity of 9.81 m/s^2 along -z of link 'gen3_robotiq_85_base_link'
// assumed:  no rotor inertias: a URDF has none
// assumed:  acceleration limits that reach full speed in 0.25 s: gen3_robotiq_85_left_knuckle_joint
// assumed:  limits of the joints that they mimic: gen3_robotiq_85_left_finger_tip_joint,
//           gen3_robotiq_85_right_finger_tip_joint, gen3_robotiq_85_left_inner_knuckle_joint,
//           gen3_robotiq_85_right_inner_knuckle_joint
// verified: against Orocos KDL, built from the text by another reader, on 100 random states (seed 1), axial::Model in
//           double:
// verified: frames and tool within 2.8e-16 (bound 1e-12), torques within 3.7e-16 of the largest, mass matrix within
//           4.3e-16 of its largest entry (bound 1e-09), bodies within 1.8e-14 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Robotiq 2F-85, both fingers.
struct Robotiq2f85 {
  static constexpr const char* name = "robotiq_2f85";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::base(0.0, 0.0, 0.05490452),
      // 0: gen3_robotiq_85_left_knuckle_joint moves gen3_robotiq_85_left_knuckle_link
      axial::revolute().a(0.03060114).alpha_deg(90).theta(0.8629815607128134)
          .mass(0.0564514996).com(0.027545420374850315, -0.015106119660429858, 0.0005505233516527239).inertia_com(8.831402203995067e-06, 2.0799442686017003e-05, 2.2123373744517134e-05, -1.0013221862727982e-06, -2.7684298981762934e-07, 7.583952332039839e-08)
          .position_limits(0.0, 0.8).speed_limit(0.5).acceleration_limit(2.0).effort_limit(50.0),
      // 1: gen3_robotiq_85_left_finger_tip_joint moves gen3_robotiq_85_left_finger_tip_link
      axial::revolute().a(0.057149996502820544)
          .mass(0.04268588744).com(0.00306303355973365, 0.021793769783946176, 8e-04).inertia_com(1.0352314304601971e-05, 4.357045695398028e-06, 1.197888e-05, -3.6337659805597622e-06, 0.0, 0.0)
          .mimic(0, -1.0)
          .position_limits(-0.8, 0.0).speed_limit(0.5).acceleration_limit(2.0),
      // 2: gen3_robotiq_85_right_knuckle_joint moves gen3_robotiq_85_right_knuckle_link
      axial::revolute().parent(axial::LinkParameters::base).a(-0.03060114).alpha_deg(90).theta(-0.8629815607128134)
          .mass(0.0564514996).com(-0.027545420374850315, -0.015106119660429858, -4.488716154e-05).inertia_com(8.821508101677929e-06, 2.0789548583699866e-05, 2.2123373744517134e-05, 1.0013221862727982e-06, 5.721594386680077e-08, 1.5673974305953403e-08)
          .mimic(0, -1.0)
          .position_limits(-0.8, 0.0).speed_limit(0.5).acceleration_limit(2.0),
      // 3: gen3_robotiq_85_right_finger_tip_joint moves gen3_robotiq_85_right_finger_tip_link
      axial::revolute().a(-0.057149996502820544)
          .mass(0.04268588744).com(-0.00306303355973365, 0.021793769783946176, -5e-05).inertia_com(1.0352314304601971e-05, 4.357045695398028e-06, 1.197888e-05, 3.6337659805597622e-06, 0.0, 0.0)
          .mimic(0)
          .position_limits(0.0, 0.8).speed_limit(0.5).acceleration_limit(2.0),
      // 4: gen3_robotiq_85_left_inner_knuckle_joint moves gen3_robotiq_85_left_inner_knuckle_link
      axial::revolute().parent(axial::LinkParameters::base).branch_deg(0, 0.00651548).a(0.0127).alpha_deg(90)
          .mass(0.02969376448).com(0.01897699, 0.02247101, -0.00015001).inertia_com(9.57136e-06, 8.19144e-06, 8.69056e-06, -3.93424e-06, 0.0, 0.0)
          .mimic(0)
          .position_limits(0.0, 0.8).speed_limit(0.5).acceleration_limit(2.0),
      // 5: gen3_robotiq_85_right_inner_knuckle_joint moves gen3_robotiq_85_right_inner_knuckle_link
      axial::revolute().parent(axial::LinkParameters::base).branch_deg(0, 0.00651548).a(-0.0127).alpha_deg(90)
          .mass(0.02969376448).com(-0.01926824, 0.02222178, -5.001e-05).inertia_com(9.42456e-06, 8.33824e-06, 8.69056e-06, 3.9636e-06, 0.0, 0.0)
          .mimic(0, -1.0)
          .position_limits(-0.8, 0.0).speed_limit(0.5).acceleration_limit(2.0)
  );
  // clang-format on
};

}  // namespace robots
