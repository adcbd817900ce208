// UFACTORY xArm 6.
//
// data:     Loki-Robotics/xarm_ros2, commit 2808d85c9084,
//           xarm_description/urdf/xarm6/xarm6.urdf;
//           BSD-3-Clause, UFACTORY; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   xarm6.urdf (URDF), links of 'world' to 'link_eef', whose frame is the tool's
// read:     transmission 'tran1': reduction 100, the gear in .rotor_inertia(J, 100) at joint 'joint1'
// read:     transmission 'tran2': reduction 100, the gear in .rotor_inertia(J, 100) at joint 'joint2'
// read:     transmission 'tran3': reduction 100, the gear in .rotor_inertia(J, 100) at joint 'joint3'
// read:     transmission 'tran4': reduction 100, the gear in .rotor_inertia(J, 100) at joint 'joint4'
// read:     transmission 'tran5': reduction 100, the gear in .rotor_inertia(J, 100) at joint 'joint5'
// read:     transmission 'tran6': reduction 100, the gear in .rotor_inertia(J, 100) at joint 'joint6'
// read:     tool: frame of link 'link_eef', the chain's only end
// read:     4 angles were read as the multiples of 90 degrees that they are within 1e-05 rad of; the farthest by
//           3.7e-06 (--right-angles 0 reads what is written)
// assumed:  gravity of 9.81 m/s^2 along -z of link 'world'
// assumed:  no rotor inertias: a URDF has none
// assumed:  acceleration limits that reach full speed in 0.25 s: joint1, joint2, joint3, joint4, joint5, joint6
// verified: against Orocos KDL, built from the text by another reader, on 100 random states (seed 1), axial::Model in
//           double:
// verified: frames and tool within 4.4e-16 (bound 1e-12), torques within 4.6e-16 of the largest, mass matrix within
//           5e-16 of its largest entry (bound 1e-09), bodies within 4e-17 (bound 1e-11)
// verified: no angle is read more than 3.7e-06 rad, no origin more than 0 m from what is written
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// UFACTORY xArm 6.
struct Xarm6 {
  static constexpr const char* name = "xarm6";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(0.0, 0.0, 0.097),
      // 0: joint1 moves link1
      axial::revolute().d(0.267)
          .mass(2.3814).com(0.00022, 0.02951, -0.0124).inertia_com(0.0058562, 0.0050316, 0.003536652, -1.79e-05, 3.55e-06, -0.000888336)
          .viscous(1.0).coulomb(1.0)
          .position_limits(-6.283185307179586, 6.283185307179586).speed_limit(3.14).acceleration_limit(12.56).effort_limit(50.0),
      // 1: joint2 moves link2
      axial::revolute().alpha_deg(-90).theta(-1.3849178728701894)
          .mass(2.2675).com(0.23107793811271718, -0.003963775671660972, 0.03496).inertia_com(0.004752755345675845, 0.029363020654324157, 0.0273447, -0.0005689926010321884, 0.004618291460926817, -0.00019134211123129278)
          .viscous(1.0).coulomb(1.0)
          .position_limits(-2.059, 2.0944).speed_limit(3.14).acceleration_limit(12.56).effort_limit(50.0),
      // 2: joint3 moves link3
      axial::revolute().a(0.2894866145437471).theta(1.3849178728701894)
          .mass(1.875).com(0.07041, 0.11631, 0.0107).inertia_com(0.0063483, 0.00379758, 0.00595768, -0.0015397, 0.00096858, 0.00186567)
          .viscous(1.0).coulomb(1.0)
          .position_limits(-3.927, 0.19198).speed_limit(3.14).acceleration_limit(12.56).effort_limit(32.0),
      // 3: joint4 moves link4
      axial::revolute().a(0.0775).alpha_deg(-90).d(0.3425)
          .mass(1.3192).com(-0.00018, 0.01798, -0.02291).inertia_com(0.004896, 0.00445694, 0.00134332, -6.925e-06, -1.418e-05, -0.00023186)
          .viscous(1.0).coulomb(1.0)
          .position_limits(-6.283185307179586, 6.283185307179586).speed_limit(3.14).acceleration_limit(12.56).effort_limit(32.0),
      // 4: joint5 moves link5
      axial::revolute().alpha_deg(90)
          .mass(1.33854).com(0.0651, 0.03096, 0.00315).inertia_com(0.00146378, 0.00184192, 0.002333524, -0.000450624, 0.000284306, 0.000130866)
          .viscous(1.0).coulomb(1.0)
          .position_limits(-1.69297, 3.141592653589793).speed_limit(3.14).acceleration_limit(12.56).effort_limit(32.0),
      // 5: joint6 moves link6
      axial::revolute().a(0.076).alpha_deg(-90)
          .mass(0.17).com(0.0, -0.00677, 0.08602).inertia_com(9.3e-05, 5.87e-05, 0.000132, 0.0, 0.0, -3.6e-06)
          .viscous(1.0).coulomb(1.0)
          .position_limits(-6.283185307179586, 6.283185307179586).speed_limit(3.14).acceleration_limit(12.56).effort_limit(20.0)
  );
  // clang-format on
};

}  // namespace robots
