// One link of a robot, described with named arguments in modified Denavit-Hartenberg (MDH) frames.
#pragma once

#include <axial/robot/link_builder.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Fluent builder of a link of chain(); start with revolute() or prismatic(). Frame i is fixed to link i, its z axis is
/// joint i's; a and alpha of link i lead from frame i-1 to it (Khalil's numbering). Craig numbers the same two
/// constants i-1: a_previous, alpha_previous (doc/guides/conventions.md).
class Link : public LinkBuilder<Link> {
 public:
  using LinkBuilder<Link>::LinkBuilder;

  /// Link length in m: distance from frame i-1 to the joint axis, along x of frame i-1.
  constexpr Link a(double metres) const {
    return with(Quantity::a, [&](auto& p) { p.a = metres; });
  }
  /// Link twist in radians, about x of frame i-1. Use alpha_deg for right angles.
  constexpr Link alpha(double radians) const {
    return with(Quantity::alpha, [&](auto& p) { p.alpha = Angle::from_radians(radians); });
  }
  /// Link twist in degrees; 0, 90, 180, -90 are exact and cost nothing.
  constexpr Link alpha_deg(double degrees) const {
    return with(Quantity::alpha, [&](auto& p) { p.alpha = Angle::from_degrees(degrees); });
  }
  /// Craig's a_{i-1} in m: another name of a.
  constexpr Link a_previous(double metres) const { return a(metres); }
  /// Craig's alpha_{i-1} in radians: another name of alpha.
  constexpr Link alpha_previous(double radians) const { return alpha(radians); }
  /// Craig's alpha_{i-1} in degrees: another name of alpha_deg.
  constexpr Link alpha_previous_deg(double degrees) const { return alpha_deg(degrees); }

  /// Axis of the rotor, about which it turns gear times as fast as the joint: a direction in the frame of the link that
  /// carries it, the joint's parent or one farther inboard (an index, or LinkParameters::base). Default: the joint's
  /// own axis, on its parent. Only scenes that name RotorDynamics see it.
  constexpr Link rotor_axis(double x, double y, double z, int carrier = LinkParameters::previous) const {
    return with(Quantity::rotor_axis, [&](auto& p) {
      p.rotor_axis[0] = x, p.rotor_axis[1] = y, p.rotor_axis[2] = z, p.rotor_carrier = carrier;
    });
  }

  /// Added mass in kg along the axes of frame i and added inertia in kg m^2 about them, at the centre of buoyancy.
  constexpr Link added_mass(double mx, double my, double mz, double ix = 0.0, double iy = 0.0, double iz = 0.0) const {
    return with(Quantity::added_mass, [&](auto& p) {
      p.water.added_mass[0] = mx, p.water.added_mass[1] = my, p.water.added_mass[2] = mz;
      p.water.added_inertia[0] = ix, p.water.added_inertia[1] = iy, p.water.added_inertia[2] = iz;
    });
  }
  /// Mass of the water that the link displaces, kg, and its centre of buoyancy in frame i, m.
  constexpr Link buoyancy(double displaced_kg, double x, double y, double z) const {
    return with(Quantity::buoyancy, [&](auto& p) {
      p.water.displaced_mass = displaced_kg;
      p.water.centre[0] = x, p.water.centre[1] = y, p.water.centre[2] = z;
    });
  }
  /// Drag in proportion to the velocity of the centre of buoyancy along the axes of frame i, N s/m, and to the angular
  /// velocity about them, N m s/rad.
  constexpr Link drag_linear(double x, double y, double z, double rx = 0.0, double ry = 0.0, double rz = 0.0) const {
    return with(Quantity::drag_linear, [&](auto& p) {
      const double values[] = {x, y, z, rx, ry, rz};
      for (int i = 0; i < 6; ++i)
        p.water.drag_linear[i] = values[i];
    });
  }
  /// Drag in proportion to speed times its magnitude, axis by axis: N s^2/m^2, N m s^2/rad^2.
  constexpr Link drag_quadratic(double x, double y, double z, double rx = 0.0, double ry = 0.0, double rz = 0.0) const {
    return with(Quantity::drag_quadratic, [&](auto& p) {
      const double values[] = {x, y, z, rx, ry, rz};
      for (int i = 0; i < 6; ++i)
        p.water.drag_quadratic[i] = values[i];
    });
  }

  /// Index of the link that carries this joint (0 is the first), or LinkParameters::base. Default: the link before.
  constexpr Link parent(int index) const {
    return with(Quantity::parent, [&](auto& p) { p.parent = index; });
  }
  /// Where this joint leaves a parent that carries several: before alpha and a, a turn in radians about and a shift in
  /// m along the parent's z axis (Khalil and Kleinfinger's tree parameters gamma and b). Use branch_deg for right
  /// angles.
  constexpr Link branch(double gamma, double b) const {
    return with(Quantity::branch, [&](auto& p) { p.gamma = Angle::from_radians(gamma), p.b = b; });
  }
  /// branch() with gamma in degrees; 0, 90, 180, -90 are exact and cost nothing.
  constexpr Link branch_deg(double gamma, double b) const {
    return with(Quantity::branch, [&](auto& p) { p.gamma = Angle::from_degrees(gamma), p.b = b; });
  }
};

/// A link that turns about its z axis.
constexpr Link revolute() { return Link(JointType::revolute); }
/// A link that slides along its z axis.
constexpr Link prismatic() { return Link(JointType::prismatic); }

}  // namespace axial

#include <axial/options/end.hpp>
