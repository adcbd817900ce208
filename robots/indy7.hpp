// Neuromeka Indy7, six revolute joints: the model of RoboPrec's published comparison of fixed-point accuracy
// (robomorphic/roboprec, src/algorithms/robots/indy7.rs, after the maker's robot description), as
// tests/data/rival_models.json has it, carried to MDH frames here. tests/cases checks one against the other.
//
// published: geometry, masses, centres of mass, inertias, joint ranges; speeds of +-0.5 rad/s and accelerations of
//            +-1 rad/s^2, which are the comparison's and far below the arm's own. Right angles are exact here; that
//            source rounds them to 4e-6 rad.
// measured:  nothing. assumed: nothing; no effort limit, rotor, friction or payload is known from there.
//
// Joint positions are the description's own. Frames 3 and 5 are its frames turned by 90 degrees about their axes, the
// others are parallel to its. Origins stand where neighbouring axes intersect: those of frames 0, 1 and 2 in the
// shoulder, those of 5 and 6 in the wrist. base() is the shoulder over the foot, tool() the origin of the description's
// last frame.
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// A joint with the limits of the comparison.
struct Indy7Joint {
  /// The limits of the comparison: speed 0.5 rad/s, acceleration 1 rad/s^2, +-position (rad).
  static constexpr axial::Link limited(const axial::Link& link, double position) {
    return link.position_limits(-position, position).speed_limit(0.5).acceleration_limit(1.0);
  }
};

/// Neuromeka Indy7, six revolute joints.
struct Indy7 : Indy7Joint {
  static constexpr const char* name = "indy7";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81), axial::base(0.0, 0.0, 0.2995),
      limited(axial::revolute().a(0.0).alpha_deg(0)
          .mass(11.44444535).com(-0.00023749, -0.04310313, -0.08954604)
          .inertia_com(0.35065005, 0.304798, 0.06003147, 0.00011931, -0.00037553, -0.10984447),
          3.0543261909900767),
      limited(axial::revolute().a(0.0).alpha_deg(90).theta_deg(-90)
          .mass(5.84766553).com(-0.29616699, 2.254e-05, 0.15383069)
          .inertia_com(0.03599743, 0.72293306, 0.70024119, -4.693e-05, -0.05240346, 1.76e-06),
          3.0543261909900767),
      limited(axial::revolute().a(-0.45).alpha_deg(0).d(0.0035).theta_deg(90)
          .mass(2.68206064).com(0.00021421, 0.16804016, 0.00499617)
          .inertia_com(0.11364055, 0.0161721, 0.10022522, 0.00011817, -4.371e-05, -0.03341882),
          3.0543261909900767),
      limited(axial::revolute().a(0.0).alpha_deg(-90).d(0.35)
          .mass(2.12987371).com(-0.00026847, -0.0709844, -0.00650872)
          .inertia_com(0.02798891, 0.01443076, 0.01496211, 3.893e-05, -4.768e-05, -0.01266296),
          3.0543261909900767),
      limited(axial::revolute().a(0.0).alpha_deg(90).d(0.183)
          .mass(2.22412271).com(-0.00023114, 0.09796232, -0.00454108)
          .inertia_com(0.03698291, 0.01105297, 0.02754795, -5.517e-05, -3.74e-05, 0.01481977),
          3.0543261909900767),
      limited(axial::revolute().a(0.0).alpha_deg(-90)
          .mass(0.38254932).com(8.147e-05, -0.00046556, 0.19879097)
          .inertia_com(0.00078982, 0.00079764, 0.00058319, -3.4e-07, 8.3e-07, -5.08e-06),
          3.7524578917878086),
      axial::tool(0.0, 0.0, 0.168));
  // clang-format on
};

}  // namespace robots
