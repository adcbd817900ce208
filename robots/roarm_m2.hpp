// Waveshare RoArm-M2, four revolute joints (base, shoulder, elbow, gripper): the model of RoboPrec's published
// comparison of fixed-point accuracy (robomorphic/roboprec, src/algorithms/robots/roarm_m2.rs, after the maker's robot
// description), as tests/data/rival_models.json has it, carried to MDH frames here. tests/cases checks one against the
// other.
//
// published: geometry, masses, centres of mass, inertias, joint ranges; speeds of +-0.5 rad/s and accelerations of
//            +-1 rad/s^2, which are the comparison's. Right angles are exact here; that source rounds them to 4e-6 rad.
// measured:  nothing. assumed: nothing; no effort limit, rotor, friction or payload is known from there.
//
// Joint positions are the description's own. The elbow stands aside of the upper arm's x axis there, by 0.126 rad, and
// on it here. Frame 3 is the description's turned by -90 degrees about its axis, frames 1 and 4 are parallel to its.
// Frame 0 stands in the shoulder: base() is it over the foot, tool() the origin of the description's last frame.
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// The elbow in the description's frame of the upper arm.
struct RoarmM2Elbow {
  static constexpr double x = 0.236815132922094, y = 0.0300023995170449;  ///< m
  static constexpr double distance = 0.23870808775089591;                 ///< m, of (x, y)
  static constexpr double angle = 0.12601985357069536;                    ///< rad, from x towards y
  static constexpr double less_a_quarter = -1.4447764732242013;           ///< angle - pi/2
  static constexpr double c = x / distance, s = y / distance;             ///< cosine and sine of `angle`

  /// Centre of mass on the description's x axis, inertia about its axes, kg m^2: in axes turned by `angle`.
  static constexpr axial::Link turned(const axial::Link& link, double com, double xx, double yy, double zz) {
    return link.com(c * com, -s * com, 0.0)
        .inertia_com(c * c * xx + s * s * yy, s * s * xx + c * c * yy, zz, c * s * (yy - xx));
  }
  /// Limits of the comparison.
  static constexpr axial::Link limited(const axial::Link& link, double low, double high) {
    return link.position_limits(low, high).speed_limit(0.5).acceleration_limit(1.0);
  }
};

/// Waveshare RoArm-M2, four revolute joints.
struct RoarmM2 : RoarmM2Elbow {
  static constexpr const char* name = "roarm_m2";  ///< on the command line, in files and in JSON

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81), axial::base(0.0100000008759151, 0.0, 0.123059270461044),
      limited(axial::revolute().a(0.0).alpha_deg(0)
          .mass(0.0729177).com(0.0, 0.0, -0.015)
          .inertia_com(4.68465e-05, 3.32107e-05, 5.01023e-05),
          -3.1416, 3.1416),
      limited(turned(axial::revolute().a(0.0).alpha_deg(-90).theta(less_a_quarter)
          .mass(0.0703216), 0.122, 5.46501e-05, 0.000423091, 0.000404557),
          -1.5708, 1.5708),
      limited(axial::revolute().a(distance).alpha_deg(0).d(-0.00066683).theta(-angle)
          .mass(0.0269773).com(0.13687, 0.002, 0.00656683)
          .inertia_com(8.01674e-06, 0.000199591, 0.000196918),
          -1.0, 2.95),
      limited(axial::revolute().a(0.21599).alpha_deg(-90)
          .mass(0.0028708).com(0.029, 0.0027, 0.002126)
          .inertia_com(5.23216e-07, 1.82071e-06, 1.60231e-06),
          0.0, 1.5),
      axial::tool(0.0, 0.0, 0.002906));
  // clang-format on
};

}  // namespace robots
