// Doosan M1013.
//
// data:     DoosanRobotics/doosan-robot2, commit ec9242546ec6,
//           dsr_description2/urdf/m1013.urdf;
//           BSD-3-Clause, Doosan Robotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   m1013.urdf (URDF), links of 'base_link' to 'link_6', whose frame is the tool's
// read:     tool: frame of link 'link_6', the chain's only end
// read:     6 angles were read as the multiples of 90 degrees that they are within 0.005 rad of; the farthest by 0.0002
//           (without --snap fewer are)
// assumed:  gravity of 9.81 m/s^2 along -z of link 'base_link'
// assumed:  no rotor inertias: a URDF has none
// assumed:  acceleration limits that reach full speed in 0.25 s: joint_1, joint_2, joint_3, joint_4, joint_5, joint_6
// verified: against Orocos KDL, built from the text by another reader, on 100 random states (seed 1), axial::Model in
//           double:
// verified: frames and tool within 3.3e-16 (bound 1e-12), torques within 3.9e-16 of the largest, mass matrix within
//           5.5e-16 of its largest entry (bound 1e-09), bodies within 1.3e-16 (bound 1e-11)
// verified: no angle is read more than 0.0002 rad, no origin more than 0 m from what is written
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Doosan M1013.
struct M1013 {
  static constexpr const char* name = "m1013";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(0.0, 0.0, 0.121),
      // 0: joint_1 moves link_1
      axial::revolute().d(0.1525)
          .mass(7.8).com(0.000119, 0.0428, -0.006383).inertia_com(0.04506, 0.029679, 0.047056, 4.1126e-05, -5.2533e-05, -0.0019959)
          .position_limits(-6.2832, 6.2832).speed_limit(2.0944).acceleration_limit(8.3776).effort_limit(346.0),
      // 1: joint_2 moves link_2
      axial::revolute().alpha_deg(-90).theta_deg(-90)
          .mass(10.83).com(0.25973, -5.3e-05, 0.19232).inertia_com(0.037586, 0.84943, 0.85021, -0.00036999, -0.0069927, 4.0201e-05)
          .position_limits(-6.2832, 6.2832).speed_limit(2.0944).acceleration_limit(8.3776).effort_limit(346.0),
      // 2: joint_3 moves link_3
      axial::revolute().a(0.62).d(0.0345).theta_deg(90)
          .mass(3.68).com(-1.5e-05, -0.006702, 0.044608).inertia_com(0.018748, 0.018972, 0.011502, 7.8071e-06, -5.0324e-06, -0.00099342)
          .position_limits(-2.7925, 2.7925).speed_limit(3.1416).acceleration_limit(12.5664).effort_limit(163.0),
      // 3: joint_4 moves link_4
      axial::revolute().alpha_deg(90).d(0.559)
          .mass(3.82).com(7.1e-05, 0.091879, -0.18252).inertia_com(0.19063, 0.17268, 0.030386, -1.8037e-05, -3.8576e-05, -0.052996)
          .position_limits(-6.2832, 6.2832).speed_limit(3.927).acceleration_limit(15.708).effort_limit(50.0),
      // 4: joint_5 moves link_5
      axial::revolute().alpha_deg(-90)
          .mass(2.82).com(-0.000273, 0.003651, 0.032088).inertia_com(0.015583, 0.011519, 0.0088671, 2.135e-05, -5.1895e-06, 0.00042553)
          .position_limits(-6.2832, 6.2832).speed_limit(3.927).acceleration_limit(15.708).effort_limit(50.0),
      // 5: joint_6 moves link_6
      axial::revolute().alpha_deg(90)
          .mass(1.16).com(-0.000292, 7e-06, 0.0671).inertia_com(0.0048282, 0.0059519, 0.0061263, 4.1298e-06, 6.9879e-06, 4.252e-06)
          .position_limits(-6.2832, 6.2832).speed_limit(3.927).acceleration_limit(15.708).effort_limit(50.0)
  );
  // clang-format on
};

}  // namespace robots
