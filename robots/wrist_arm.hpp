// A light arm with a belt past its elbow and a differential wrist.
//
// assumed: everything; no particular product.
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Five drives, five joints: base, shoulder, elbow by a belt from the shoulder's axis, pitch and roll by a
/// differential.
struct WristArm {
  static constexpr const char* name = "wrist_arm";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description: the elbow's motor stands on the base, so that q3 = u3 - u2; q5 and q6 are half the sum and half the
  /// difference of the wrist's drives.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81), axial::payload_limit(2.0, 0.15, 0.01),
      axial::revolute().d(0.2).mass(3.0).com(0.0, 0.02, -0.05).inertia_com(0.012, 0.010, 0.011)
          .rotor_inertia(2.0e-5, 60.0).viscous(0.2).coulomb(0.5)
          .position_limits(-2.9, 2.9).speed_limit(4.0).acceleration_limit(20.0).effort_limit(40.0),
      axial::revolute().alpha_deg(90).mass(2.4).com(0.16, 0.0, 0.01).inertia_com(0.003, 0.020, 0.021)
          .rotor_inertia(2.0e-5, 80.0).viscous(0.3).coulomb(0.6)
          .position_limits(-0.4, 2.6).speed_limit(3.5).acceleration_limit(18.0).effort_limit(60.0)
          .drive_limits(-0.4, 2.6, 3.5, 18.0),
      axial::revolute().a(0.32).mass(1.5).com(0.12, 0.0, 0.0).inertia_com(0.001, 0.009, 0.009)
          .rotor_inertia(1.2e-5, 80.0).viscous(0.2).coulomb(0.4).driven_by(1, -1.0)
          .position_limits(-2.6, 0.4).speed_limit(5.0).acceleration_limit(30.0).effort_limit(35.0)
          .drive_limits(-2.6, 2.6, 4.0, 20.0),
      axial::revolute().a(0.28).mass(0.5).com(0.03, 0.0, 0.0).inertia_com(0.0003, 0.0005, 0.0005)
          .rotor_inertia(4.0e-6, 30.0).viscous(0.01).coulomb(0.03)
          .position_limits(-1.9, 1.9).speed_limit(8.0).acceleration_limit(80.0).effort_limit(6.0)
          .drive_limits(-8.0, 8.0, 12.0, 120.0),
      axial::revolute().alpha_deg(90).mass(0.3).com(0.0, 0.005, 0.06).inertia_com(0.0004, 0.0004, 0.0001)
          .rotor_inertia(4.0e-6, 30.0).viscous(0.01).coulomb(0.03)
          .position_limits(-6.0, 6.0).speed_limit(8.0).acceleration_limit(80.0).effort_limit(6.0)
          .drive_limits(-8.0, 8.0, 12.0, 120.0),
      axial::differential());
  // clang-format on
};

}  // namespace robots
