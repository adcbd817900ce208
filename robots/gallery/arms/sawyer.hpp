// Rethink Robotics Sawyer.
//
// data:     PickNikRobotics/mujoco_menagerie, commit d43f1b4e2247,
//           rethink_robotics_sawyer/sawyer.xml;
//           Apache-2.0, Rethink Robotics; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// source:   sawyer.xml (MJCF), bodies of 'world' to 'right_l6', whose frame is the tool's
// read:     sections that are no part of rigid joints are not read: asset, contact, keyframe
// read:     axes were turned by up to 7.3e-06 rad onto axes of their frames or of their neighbours', joints 'right_j6'
//           (--right-angles 0 reads what is written)
// assumed:  speed limit of half a turn a second: right_j0, right_j1, right_j2, right_j3, right_j4, right_j5, right_j6
// assumed:  acceleration limits that reach full speed in 0.25 s: right_j0, right_j1, right_j2, right_j3, right_j4,
//           right_j5, right_j6
// verified: against Orocos KDL on the tree of the file's bodies, on 100 random states (seed 1), axial::Model in double:
// verified: frames and tool within 5e-16 (bound 1e-12), torques within 3.1e-16 of the largest, mass matrix within
//           3.9e-16 of its largest entry (bound 1e-09), bodies within 2.8e-16 (bound 1e-11)
// verified: no angle is read more than 7.4e-06 rad, no origin more than 0 m from what is written
// verified: the file as it is written against MuJoCo 3.3.8 on 20 of these states: poses within 1.8e-15, torques with
//           rotors within 7e-16 of the largest, mass matrix within 6.9e-16, bodies within 1e-15, what joints have
//           within 0 (bound of each 1e-09)
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Rethink Robotics Sawyer.
struct Sawyer {
  static constexpr const char* name = "sawyer";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::tool(axial::FixedPose{{-0.9848082493392387, -0.17364536283294102, 0.0, 0.17364536283294102, -0.9848082493392387, 0.0, 0.0, 0.0, 1.0},
                                   {0.0, 0.0, 0.11}}),
      // 0: right_j0 moves right_l0
      axial::revolute().d(0.317)
          .mass(6.9008).com(0.02000598822165546, 0.00845211337521012, -0.03501003647403198).inertia_com(0.14447437055638265, 0.14579531554483144, 0.029214673659370128, 0.004449752251077594, 0.017697500201922733, 0.011432956737183779)
          .rotor_inertia(1.0, 1.0)
          .viscous(0.1).coulomb(0.3)
          .position_limits(-3.0503, 3.0503).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(80.0),
      // 1: right_j1 moves right_l1
      axial::revolute().a(0.081).alpha_deg(-90).d(0.1925).theta_deg(90)
          .mass(4.505).com(-0.0030849, -0.026811, -0.049979).inertia_com(0.02239800570579064, 0.014612999481341222, 0.017295004812868137, -0.00023985830272180053, -0.0002936211359813716, -0.006087496019912452)
          .rotor_inertia(1.0, 1.0)
          .viscous(0.1).coulomb(0.3)
          .position_limits(-3.8095, 2.2736).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(80.0),
      // 2: right_j2 moves right_l2
      axial::revolute().alpha_deg(90).d(0.4)
          .mass(1.745).com(-0.00016044, -0.014967, -0.12418).inertia_com(0.02550600582303244, 0.02530004047495318, 0.003417913702014383, 4.410539468655148e-06, 1.495526099384344e-05, -0.0033204011419532596)
          .rotor_inertia(1.0, 1.0)
          .viscous(0.1).coulomb(0.3)
          .position_limits(-3.0426, 3.0426).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(40.0),
      // 3: right_j3 moves right_l3
      axial::revolute().alpha_deg(-90).d(-0.1685)
          .mass(2.5097).com(-0.0048135, -0.0281, 0.042346).inertia_com(0.010160015645454205, 0.006568503146438181, 0.006907801208107615, -9.740178064844962e-06, 0.0002662450554221148, 0.0030315988278310805)
          .rotor_inertia(1.0, 1.0)
          .viscous(0.1).coulomb(0.3)
          .position_limits(-3.0439, 3.0439).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(40.0),
      // 4: right_j4 moves right_l4
      axial::revolute().alpha_deg(90).d(0.4)
          .mass(1.1136).com(-0.00188917, 0.00689948, -0.140905).inertia_com(0.013557398631056572, 0.013555647227409207, 0.0013661041415342213, 1.8062751930718015e-05, 0.00013491629143634292, 0.0010560603330863798)
          .rotor_inertia(1.0, 1.0)
          .viscous(0.1).coulomb(0.1)
          .position_limits(-2.9761, 2.9761).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(9.0),
      // 5: right_j5 moves right_l5
      axial::revolute().alpha_deg(-90).d(0.1363)
          .mass(1.5625).com(0.0061133, -0.023697, -0.028884).inertia_com(0.004732796620103153, 0.0029676027994555406, 0.0031762005804413067, 0.0001152595461750743, 4.626907738259332e-05, -0.0011556977088744871)
          .rotor_inertia(1.0, 1.0)
          .viscous(0.1).coulomb(0.1)
          .position_limits(-2.9761, 2.9761).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(9.0),
      // 6: right_j6 moves right_l6
      axial::revolute().alpha_deg(90)
          .mass(0.3292).com(-0.0014825871024117833, -0.008454798820234163, 0.1050434).inertia_com(0.0003086839928434763, 0.0002178758656391023, 0.00035977014151742146, -1.4953676667067057e-05, 1.832953257408787e-06, 8.260594522824216e-06)
          .rotor_inertia(1.0, 1.0)
          .viscous(0.1).coulomb(0.1)
          .position_limits(-4.7124, 4.7124).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172).effort_limit(9.0)
  );
  // clang-format on
};

}  // namespace robots
