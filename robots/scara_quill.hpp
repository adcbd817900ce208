// A SCARA whose quill hangs on a ball-screw spline: a nut and a spline drive share slide and turn.
//
// assumed: everything. scara_rrpr with its screw and spline; no particular product.
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Industrial SCARA of four drives: two of the arm, nut and spline of the quill.
struct ScaraQuill {
  static constexpr const char* name = "scara_quill";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file. The quill's drives: the nut's angle and
  /// torque, the spline's.
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
          .rotor_inertia(5.0e-6, 2.0).viscous(2.5e-4).coulomb(0.04)
          .position_limits(0.0, 0.200).speed_limit(1.1).acceleration_limit(20.0).effort_limit(1.1)
          .drive_limits(-70.0, 70.0, 360.0, 7000.0),
      axial::revolute().a(0.0).alpha_deg(0)
          .mass(0.60).com(0.004, 0.0, 0.025).inertia_com(0.0006, 0.0006, 0.0004)
          .rotor_inertia(4.0e-6, 20.0).viscous(0.02).coulomb(0.15)
          .position_limits(-6.28, 6.28).speed_limit(20.0).acceleration_limit(120.0).effort_limit(2.0)
          .drive_limits(-6.28, 6.28, 20.0, 120.0),
      axial::screw_spline(0.020));
  // clang-format on
};

}  // namespace robots
