// The SCARA of Djuric, Filipovic, Jovanovic and Kevac (IEEE 2016): two revolute joints and a slide that points down.
//
// published: structure (their Table I) and the model of slender rods with the centre of mass half-way.
// assumed:   every length, mass and limit, the payload too; the paper works in symbols. The values are those of the
// validation case
//            tests/data/scara_djuric_rrp.json, each exact in float.
// Their DH rows (theta1, d1, a1, 0), (theta2, 0, a2, 180 deg), (0, d3, 0, 0) are rewritten here as MDH rows.
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// SCARA of two revolute joints and a slide, without a tool axis.
struct Scara {
  static constexpr const char* name = "scara";  ///< on the command line, in files and in JSON

  static constexpr double a1 = 0.375, a2 = 0.3125, length3 = 0.25;  ///< m, lengths of the links
  static constexpr double m1 = 4.0, m2 = 2.5, m3 = 1.25;            ///< kg, their masses

  // Slender rods about their centres of mass, across their length: m l^2 / 12, kg m^2.
  /// kg m^2, slender rods about their centres of mass, across their length: m l^2 / 12
  static constexpr double rod1 = m1 * a1 * a1 / 12.0, rod2 = m2 * a2 * a2 / 12.0, rod3 = m3 * length3 * length3 / 12.0;

  // A line a group of values.
  // clang-format off
  /// Its description; sources and assumptions stand at the top of the file.
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.8125), axial::payload_limit(2.0, 0.25, 0.05),
      axial::revolute().a(0.0).alpha_deg(0).d(0.5)
          .mass(m1).com(a1 / 2, 0.0, 0.0).inertia_com(0.0, rod1, rod1)
          .position_limits(-2.5, 2.5).speed_limit(4.0).acceleration_limit(20.0).effort_limit(80.0),
      axial::revolute().a(a1).alpha_deg(0)
          .mass(m2).com(a2 / 2, 0.0, 0.0).inertia_com(0.0, rod2, rod2)
          .position_limits(-2.6, 2.6).speed_limit(5.0).acceleration_limit(30.0).effort_limit(25.0),
      axial::prismatic().a(a2).alpha_deg(180)
          .mass(m3).com(0.0, 0.0, -length3 / 2).inertia_com(rod3, rod3, 0.0)
          .position_limits(0.0, 0.25).speed_limit(1.0).acceleration_limit(10.0).effort_limit(30.0));
  // clang-format on
};

}  // namespace robots
