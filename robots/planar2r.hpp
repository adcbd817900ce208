// The two-link planar arm of J. J. Craig, "Introduction to Robotics" (section 6.7): point masses at the ends of the
// links, moving in a vertical plane (gravity along -y of frame 0).
//
// published: the model and its closed form.
// assumed:   every length, mass and limit, the payload too; the book works in symbols. The values are those of the
// validation case
//            tests/data/craig_2r_pointmass.json, but for standard gravity.
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// Craig's planar arm of two links, point masses at their ends.
struct Planar2r {
  static constexpr const char* name = "planar2r";  ///< on the command line, in files and in JSON

  static constexpr double l1 = 0.5, l2 = 0.75;  ///< m, lengths of the links
  static constexpr double m1 = 4.6, m2 = 2.3;   ///< kg, at the ends

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, -9.81, 0.0), axial::payload_limit(2.0, 0.25, 0.05),
      axial::revolute().mass(m1).com(l1, 0.0, 0.0)
          .position_limits(-3.14, 3.14).speed_limit(3.0).acceleration_limit(10.0).effort_limit(180.0),
      axial::revolute().a(l1).mass(m2).com(l2, 0.0, 0.0)
          .position_limits(-2.8, 2.8).speed_limit(4.0).acceleration_limit(15.0).effort_limit(75.0),
      axial::tool(l2, 0.0, 0.0));
  // clang-format on
};

}  // namespace robots
