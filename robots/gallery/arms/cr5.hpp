// Dobot CR5.
//
// data:     Dobot-Arm/DOBOT_6Axis_ROS2_V4, commit a1eabefdfc34,
//           dobot_rviz/urdf/cr5_robot.urdf;
//           MIT, Dobot; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   cr5_robot.urdf (URDF), links of 'dummy_link' to 'Link6', whose frame is the tool's
// read:     tool: frame of link 'Link6', the chain's only end
// read:     5 angles were read as the multiples of 90 degrees that they are within 1e-05 rad of; the farthest by
//           3.7e-06 (--right-angles 0 reads what is written)
// read:     origins were shifted by up to 4e-07 m, which is finer than the file's digits, 'joint4' (--right-angles 0
//           reads what is written)
// assumed:  gravity of 9.81 m/s^2 along -z of link 'dummy_link'
// assumed:  no rotor inertias: a URDF has none
// assumed:  speed limit of half a turn a second: joint1, joint2, joint3, joint4, joint5, joint6
// assumed:  acceleration limits that reach full speed in 0.25 s: joint1, joint2, joint3, joint4, joint5, joint6
// assumed:  no effort limit: joint1, joint2, joint3, joint4, joint5, joint6
// verified: against Orocos KDL, built from the text by another reader, on 100 random states (seed 1), axial::Model in
//           double:
// verified: frames and tool within 4.4e-16 (bound 1e-12), torques within 1.7e-15 of the largest, mass matrix within
//           1.1e-15 of its largest entry (bound 1e-09), bodies within 1.7e-15 (bound 1e-11)
// verified: no angle is read more than 3.7e-06 rad, no origin more than 4e-07 m from what is written
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Dobot CR5.
struct Cr5 {
  static constexpr const char* name = "cr5";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(0.0, 0.0, 0.105),
      // 0: joint1 moves Link1
      axial::revolute().d(0.147)
          .mass(1.61309076753593).com(1.73246183e-07, -0.00325457191611467, -0.00763347019440543).inertia_com(0.00546783618974324, 0.00525034621721433, 0.00340956817185818, 1.55105106e-09, -7.41656921e-08, -9.78846785618848e-05)
          .position_limits(-6.28, 6.28).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 1: joint2 moves Link2
      axial::revolute().alpha_deg(90).theta(-1.5699797930185198)
          .mass(5.52502766431306).com(-0.21351461246518064, 1.9604761e-07, 0.142532293229243).inertia_com(0.013538901258170208, 0.17535129990251, 0.171155665794094, -6.669622e-07, 1.089298399e-06, -1.566513955e-07)
          .position_limits(-6.28, 6.28).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 2: joint3 moves Link3
      axial::revolute().a(-0.42700014234634115).theta(-0.0017931700935715524)
          .mass(2.85389421082174).com(-0.15234174147838575, 5.76999078e-07, 0.0226831470311876).inertia_com(0.004262279977943156, 0.06512957016931303, 0.0643864464792015, 3.228676748e-07, 0.0014536658224465072, 2.16380293e-08)
          .position_limits(-2.792, 2.792).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 3: joint4 moves Link4
      axial::revolute().a(-0.3570005739601977).d(0.141).theta(-1.569819690477702)
          .mass(0.670967728058518).com(5.5949717e-08, -0.00203370549966442, -0.00155327517554493).inertia_com(0.00165215048696393, 0.000679018426564622, 0.00161207334026771, 6.9988406e-10, -2.82735062e-09, -3.9331196747873e-05)
          .position_limits(-6.28, 6.28).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 4: joint5 moves Link5
      axial::revolute().alpha_deg(90).d(0.116)
          .mass(0.741136954745254).com(1.6683934e-08, -0.00612503200433553, -0.00127182253467861).inertia_com(0.00212858333782698, 0.000739514141641333, 0.00208815449047131, -3.051141183e-08, 1.845873344e-08, 5.38479498016834e-05)
          .position_limits(-6.28, 6.28).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 5: joint6 moves Link6
      axial::revolute().alpha_deg(-90)
          .mass(0.157885369717385).com(4.944e-11, 9.3763228635857e-05, 0.085714563574411).inertia_com(7.94006759268348e-05, 7.91691792019657e-05, 0.000130860179835048, 4.662e-15, 2.94413e-14, -9.61313747365424e-08)
          .position_limits(-6.28, 6.28).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172)
  );
  // clang-format on
};

}  // namespace robots
