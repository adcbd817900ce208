// A generic industrial SCARA, RRPR: shoulder, elbow, quill and a tool axis coaxial with the quill.
//
// assumed: everything. The values are of the size usual for an arm of 0.6 m reach and 5 kg payload; they describe no
//          particular product. The quill and the tool axis are modelled as independent drives: the coupling of a
//          real ball-screw spline belongs to the motor coordinates, not to the joints.
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Industrial SCARA, RRPR: three revolute joints and a quill.
struct ScaraRrpr {
  static constexpr const char* name = "scara_rrpr";  ///< on the command line, in files and in JSON

  /// Motor turns (rad) per metre of a ball screw with a lead of 20 mm.
  static constexpr double screw = 2.0 * 3.14159265358979323846 / 0.020;

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81), axial::payload_limit(5.0, 0.25, 0.05),
      axial::revolute().a(0.0).alpha_deg(0).d(0.320)
          .mass(9.0).com(0.170, 0.0, 0.035).inertia_com(0.032, 0.125, 0.130)
          .rotor_inertia(2.6e-5, 80.0).viscous(2.4).coulomb(3.2)
          .position_limits(-2.27, 2.27).speed_limit(6.5).acceleration_limit(25.0).effort_limit(250.0),
      axial::revolute().a(0.325).alpha_deg(0)
          .mass(7.2).com(0.135, 0.0, 0.080).inertia_com(0.040, 0.085, 0.072, 0.0, -0.006, 0.0)
          .rotor_inertia(1.4e-5, 50.0).viscous(0.9).coulomb(1.6)
          .position_limits(-2.53, 2.53).speed_limit(9.0).acceleration_limit(45.0).effort_limit(90.0),
      axial::prismatic().a(0.275).alpha_deg(180)
          .mass(0.95).com(0.0, 0.0, -0.060).inertia_com(0.0105, 0.0105, 0.0002)
          .rotor_inertia(5.0e-6, screw).viscous(25.0).coulomb(12.0)
          .position_limits(0.0, 0.200).speed_limit(1.1).acceleration_limit(20.0).effort_limit(110.0),
      axial::revolute().a(0.0).alpha_deg(0)
          .mass(0.60).com(0.004, 0.0, 0.025).inertia_com(0.0006, 0.0006, 0.0004)
          .rotor_inertia(4.0e-6, 20.0).viscous(0.02).coulomb(0.15)
          .position_limits(-6.28, 6.28).speed_limit(20.0).acceleration_limit(120.0).effort_limit(2.0));
  // clang-format on
};

}  // namespace robots
