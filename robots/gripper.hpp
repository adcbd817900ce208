// A wrist with a parallel gripper: one drive moves both fingers.
//
// assumed: everything; no particular product.
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Two drives, three joints: roll, and two fingers that mirror each other.
struct Gripper {
  static constexpr const char* name = "gripper";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description: the second finger's slide points the other way, so that it follows the first one to one.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      axial::revolute().alpha_deg(90).mass(0.8).com(0.0, 0.01, 0.03).inertia_com(0.0012, 0.0011, 0.0006)
          .rotor_inertia(5.0e-6, 50.0).viscous(0.02).coulomb(0.05)
          .position_limits(-3.0, 3.0).speed_limit(6.0).acceleration_limit(60.0).effort_limit(4.0),
      axial::prismatic().alpha_deg(90).d(0.01).mass(0.12).com(0.0, 0.05, 0.0).inertia_com(6.0e-5, 1.0e-5, 6.0e-5)
          .rotor_inertia(1.0e-7, 3000.0).viscous(8.0).coulomb(5.0)
          .position_limits(0.0, 0.045).speed_limit(0.3).acceleration_limit(10.0).effort_limit(80.0),
      axial::prismatic().parent(0).alpha_deg(-90).d(0.01).mass(0.12).com(0.0, -0.05, 0.0)
          .inertia_com(6.0e-5, 1.0e-5, 6.0e-5).mimic(1));
  // clang-format on
};

}  // namespace robots
