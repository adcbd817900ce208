// Dobot MG400, a palletiser of two parallelograms.
//
// data:     Dobot-Arm/MG400_ROS, commit 2bcf6a988311,
//           mg400_description/urdf/mg400_description.urdf;
//           MIT, Dobot; numbers alone are taken over
// published: geometry, bodies, and limits, friction and rotors as far as that file has them
// measured: nothing here; assumed: as the lines say that begin so
// doubtful: bodies are a drawing program's
// source:   mg400_description.urdf (URDF), links of 'base_link'
// assumed:  gravity of 9.81 m/s^2 along -z of link 'base_link'
// assumed:  no rotor inertias: a URDF has none
// assumed:  speed limit of half a turn a second: j1, j2, j3, j4
// assumed:  acceleration limits that reach full speed in 0.25 s: j1, j2, j3, j4
// assumed:  limits of the joints that they mimic: j3_1, j4_1, j2_2, j3_2, j4_2
// assumed:  no effort limit: j1, j2, j3, j4
// warning:  link 'fake_link': has neither mass nor inertia; give both, or leave it massless on purpose
// verified: against Orocos KDL, built from the text by another reader, on 100 random states (seed 1), axial::Model in
//           double:
// verified: frames and tool within 3.6e-15 (bound 1e-12), torques within 1.8e-15 of the largest, mass matrix within
//           2.5e-15 of its largest entry (bound 1e-09), bodies within 8.2e-15 (bound 1e-11)
// verified: no angle is read more than 0 rad, no origin more than 0 m from what is written
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Dobot MG400, a palletiser of two parallelograms.
struct Mg400 {
  static constexpr const char* name = "mg400";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      // 0: j1 moves link1
      axial::revolute().a(-0.005).d(0.227995682641123)
          .mass(1.77056222753813).com(-0.0046209286967387, -6.881079823e-05, -0.048003746794540295).inertia_com(0.00605885293080088, 0.00579381982249127, 0.00741058257251941, 0.000156081820035162, -0.00021785654850453, 6.20876898015621e-05)
          .position_limits(-3.14, 3.14).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 1: j2 moves link2_1
      axial::revolute().a(0.0435007595118091).alpha_deg(-90).theta(1.5647892560635495)
          .mass(0.0866115884541459).com(-0.059631387257830015, 0.0028597290371865695, -0.0004822185392305972).inertia_com(3.887940279844661e-05, 0.0003386672183765647, 0.000307789653713489, 8.721060706641769e-06, 1.3610545929845272e-06, 1.0964682152877536e-08)
          .position_limits(-0.14, 1.39).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 2: j3 moves fake_link
      axial::revolute().a(-0.17500432184184025)
          .position_limits(0.0, 1.39).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 3: j3_1 moves link3_1
      axial::revolute().theta(1.5582202058241637)
          .mass(0.0375214831045061).com(-0.08209173497510656, -0.004863865984850311, 0.00011304468584277686).inertia_com(2.528182818936121e-06, 0.00016435092895336273, 0.000164234314177935, -9.809111865016683e-07, -3.727692925481296e-07, -2.140364981871666e-08)
          .mimic(7)
          .position_limits(-3.14, 3.14),
      // 4: j4_1 moves link4_1
      axial::revolute().a(-0.1749999999998487).theta(0.018571250872533734)
          .mass(0.0628979533925801).com(-0.03878778890249371, -0.0024615622076454517, 8.483339979e-05).inertia_com(4.784855948367186e-05, 3.3611842071832436e-05, 5.42362047732042e-05, -8.329000794602344e-06, -1.420815623360299e-07, -2.9062541175788344e-08)
          .mimic(8, -1.0)
          .position_limits(-3.14, 3.14),
      // 5: j4 moves link5
      axial::revolute().a(-0.06599999407096162).alpha_deg(-90)
          .mass(0.0965276919819365).com(-6.689004e-09, -3e-14, -0.003968869023562379).inertia_com(4.985899922029461e-05, 4.98589881725446e-05, 2.1304630079388188e-05, -1.5348655e-12, -5.461595e-12, 3.82e-17)
          .position_limits(-3.14, 3.14).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 6: j2_2 moves link2_2
      axial::revolute().parent(0).branch_deg(0, 0.02250431735887802).a(0.00452885682964267).alpha_deg(-90).theta(1.5647934478547445)
          .mass(0.0662546292985346).com(-0.07375220653416362, 0.01966874464001492, -3.6473148e-08).inertia_com(3.7408037437675754e-05, 0.00021899751393218283, 0.000200510070261609, 1.424094706434981e-06, 1.420160877e-09, -2.92959606e-10)
          .mimic(1)
          .position_limits(-3.14, 3.14).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 7: j3_2 moves link3_2
      axial::revolute().a(-0.17499999999999524).theta(1.4022662805365589)
          .mass(0.0366692789294813).com(-0.03412760363295736, -0.0014255545972393445, 2.088738574266072e-05).inertia_com(6.9462885799126594e-06, 1.697699404498968e-05, 2.34967008246727e-05, -2.5241355686289458e-08, -8.605850287e-10, 3.107896831e-10)
          .mimic(6, -1.0)
          .position_limits(-3.14, 3.14).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172),
      // 8: j4_2 moves link4_2
      axial::revolute().a(-0.0689439998808919)
          .mass(0.0453569016333092).com(-0.08775159449419698, -0.007029780102367664, -1.32547725e-07).inertia_com(2.3751209010711106e-05, 0.00013806652948384937, 0.000132049841023893, -2.103524672991402e-05, -3.3871782064505175e-09, -5.1988475e-11)
          .mimic(2)
          .position_limits(-3.14, 3.14).speed_limit(3.141592653589793).acceleration_limit(12.566370614359172)
  );
  // clang-format on
};

}  // namespace robots
