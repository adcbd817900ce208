// One link of a robot, described with named arguments: geometry (MDH), inertia, drive, friction, limits.
#pragma once

#include <axial/model/angle.hpp>
#include <axial/model/water.hpp>

namespace axial {

enum class JointType : unsigned char { revolute, prismatic };

/// What a link is, in SI units and radians. Frame i is fixed to link i, its z axis is joint i's axis; the transform
/// from frame i-1 to frame i is Rx(alpha) Tx(a) Rz(theta) Tz(d) (modified Denavit-Hartenberg); in a tree it starts from
/// the parent's frame, and Rz(gamma) Tz(b) may come before it. All fields are inputs as written by the author of the
/// robot; the algorithms use LinkConstants, derived from them.
struct LinkParameters {
  static constexpr double unlimited = std::numeric_limits<double>::infinity();
  static constexpr int previous = -2;  ///< parent: the link before this one
  static constexpr int base = -1;      ///< parent: the fixed base

  JointType type = JointType::revolute;
  int parent = previous;            ///< index of the link that carries this joint, or base
  double b = 0.0;                   ///< m, along z of the parent's frame, before all else
  Angle gamma;                      ///< rad, about z of the parent's frame
  double a = 0.0;                   ///< m, along x of frame i-1
  Angle alpha;                      ///< rad, about x of frame i-1
  double d = 0.0;                   ///< m, along z of frame i; a prismatic joint's offset
  Angle theta;                      ///< rad, about z of frame i; a revolute joint's offset
  double mass = 0.0;                ///< kg
  double com[3] = {0.0, 0.0, 0.0};  ///< m, centre of mass in frame i
  double inertia_com[6] = {
      0.0, 0.0, 0.0, 0.0, 0.0, 0.0};      ///< kg m^2: xx yy zz xy xz yz about the centre of mass,
                                          ///< tensor entries (products with their sign), axes of frame i
  double rotor_inertia = 0.0;             ///< kg m^2, on the motor side
  double gear = 1.0;                      ///< motor turns per joint turn
  double viscous = 0.0;                   ///< N m s/rad or N s/m, on the joint side
  double coulomb_forward = 0.0;           ///< N m or N, friction while moving forward (>= 0)
  double coulomb_backward = 0.0;          ///< N m or N, friction while moving backward (<= 0)
  double static_friction = 0.0;           ///< N m or N, breakaway effort in either direction; 0: no Stribeck effect
  double stribeck_speed = 0.0;            ///< rad/s or m/s, where half of the breakaway beyond Coulomb is left
  double smooth_speed = 0.0;              ///< rad/s or m/s, below which dry friction goes through 0 smoothly; 0: a step
  double spring_stiffness = 0.0;          ///< N m/rad or N/m, of a spring across the joint
  double spring_rest = 0.0;               ///< rad or m, where the spring exerts nothing
  double position_min = -unlimited;       ///< rad or m
  double position_max = unlimited;        ///< rad or m
  double speed_limit = unlimited;         ///< rad/s or m/s
  double acceleration_limit = unlimited;  ///< rad/s^2 or m/s^2
  double effort_limit = unlimited;        ///< N m or N
  WaterParameters water{};                ///< only scenes that name Underwater see it
};

/// Fluent builder of LinkParameters; every call returns a changed copy. Start with revolute() or prismatic().
class Link {
  template <class Change>
  constexpr Link with(Change change) const {
    Link changed = *this;
    change(changed.p_);
    return changed;
  }  // before its uses: clang needs it for constants

 public:
  constexpr explicit Link(JointType type) { p_.type = type; }

  constexpr const LinkParameters& parameters() const { return p_; }

  /// Link length in m: distance from frame i-1 to the joint axis, along x of frame i-1.
  constexpr Link a(double metres) const {
    return with([&](auto& p) { p.a = metres; });
  }
  /// Link twist in radians, about x of frame i-1. Use alpha_deg for right angles.
  constexpr Link alpha(double radians) const {
    return with([&](auto& p) { p.alpha = Angle::from_radians(radians); });
  }
  /// Link twist in degrees; 0, 90, 180, -90 are exact and cost nothing.
  constexpr Link alpha_deg(double degrees) const {
    return with([&](auto& p) { p.alpha = Angle::from_degrees(degrees); });
  }
  /// Joint offset in m along z of frame i; for a prismatic joint the offset added to its position.
  constexpr Link d(double metres) const {
    return with([&](auto& p) { p.d = metres; });
  }
  /// Angle in radians about z of frame i; for a revolute joint the offset added to its position.
  constexpr Link theta(double radians) const {
    return with([&](auto& p) { p.theta = Angle::from_radians(radians); });
  }
  /// The same in degrees, exact for multiples of 90.
  constexpr Link theta_deg(double degrees) const {
    return with([&](auto& p) { p.theta = Angle::from_degrees(degrees); });
  }

  /// Mass in kg; 0 is legitimate.
  constexpr Link mass(double kg) const {
    return with([&](auto& p) { p.mass = kg; });
  }
  /// Centre of mass in m, in frame i.
  constexpr Link com(double x, double y, double z) const {
    return with([&](auto& p) { p.com[0] = x, p.com[1] = y, p.com[2] = z; });
  }
  /// Inertia tensor in kg m^2 about the centre of mass, axes of frame i; products are tensor entries (-integral x y
  /// dm).
  constexpr Link inertia_com(double xx, double yy, double zz, double xy = 0.0, double xz = 0.0, double yz = 0.0) const {
    return with([&](auto& p) {
      p.inertia_com[0] = xx, p.inertia_com[1] = yy, p.inertia_com[2] = zz;
      p.inertia_com[3] = xy, p.inertia_com[4] = xz, p.inertia_com[5] = yz;
    });
  }
  /// Inertia tensor in kg m^2 about the origin of frame i; give mass and com before it.
  constexpr Link inertia_origin(double xx, double yy, double zz, double xy = 0.0, double xz = 0.0,
                                double yz = 0.0) const {
    const double m = p_.mass, x = p_.com[0], y = p_.com[1], z = p_.com[2];
    return inertia_com(xx - m * (y * y + z * z), yy - m * (x * x + z * z), zz - m * (x * x + y * y), xy + m * x * y,
                       xz + m * x * z, yz + m * y * z);
  }

  /// Rotor inertia in kg m^2 on the motor side and gear ratio (motor turns a joint turn): adds gear^2 J to the joint.
  constexpr Link rotor_inertia(double kg_m2, double gear = 1.0) const {
    return with([&](auto& p) { p.rotor_inertia = kg_m2, p.gear = gear; });
  }
  /// Viscous friction on the joint side, N m s/rad or N s/m.
  constexpr Link viscous(double coefficient) const {
    return with([&](auto& p) { p.viscous = coefficient; });
  }
  /// Coulomb friction on the joint side, N m or N, the same in both directions; 0 at rest.
  constexpr Link coulomb(double magnitude) const { return coulomb(magnitude, -magnitude); }
  /// Coulomb friction torque while moving forward (>= 0) and while moving backward (<= 0).
  constexpr Link coulomb(double forward, double backward) const {
    return with([&](auto& p) { p.coulomb_forward = forward, p.coulomb_backward = backward; });
  }
  /// Stribeck effect: friction falls from `static_effort` (N m or N, in either direction) at breakaway to the Coulomb
  /// friction; at `speed` (rad/s or m/s) half of the difference is left.
  constexpr Link stribeck(double static_effort, double speed) const {
    return with([&](auto& p) { p.static_friction = static_effort, p.stribeck_speed = speed; });
  }
  /// Below this speed (rad/s or m/s) Coulomb and Stribeck friction go through 0 smoothly instead of stepping.
  constexpr Link smooth_speed(double speed) const {
    return with([&](auto& p) { p.smooth_speed = speed; });
  }
  /// A spring across the joint: the drive exerts stiffness (q - rest_position), N m/rad or N/m, against it.
  constexpr Link spring(double stiffness, double rest_position = 0.0) const {
    return with([&](auto& p) { p.spring_stiffness = stiffness, p.spring_rest = rest_position; });
  }

  /// Position limits, rad or m.
  constexpr Link position_limits(double min, double max) const {
    return with([&](auto& p) { p.position_min = min, p.position_max = max; });
  }
  /// Largest speed, rad/s or m/s.
  constexpr Link speed_limit(double max) const {
    return with([&](auto& p) { p.speed_limit = max; });
  }
  /// Largest acceleration, rad/s^2 or m/s^2.
  constexpr Link acceleration_limit(double max) const {
    return with([&](auto& p) { p.acceleration_limit = max; });
  }
  /// Largest effort, N m or N.
  constexpr Link effort_limit(double max) const {
    return with([&](auto& p) { p.effort_limit = max; });
  }

  /// Added mass in kg along the axes of frame i and added inertia in kg m^2 about them, at the centre of buoyancy.
  constexpr Link added_mass(double mx, double my, double mz, double ix = 0.0, double iy = 0.0, double iz = 0.0) const {
    return with([&](auto& p) {
      p.water.added_mass[0] = mx, p.water.added_mass[1] = my, p.water.added_mass[2] = mz;
      p.water.added_inertia[0] = ix, p.water.added_inertia[1] = iy, p.water.added_inertia[2] = iz;
    });
  }
  /// Mass of the water that the link displaces, kg, and its centre of buoyancy in frame i, m.
  constexpr Link buoyancy(double displaced_kg, double x, double y, double z) const {
    return with([&](auto& p) {
      p.water.displaced_mass = displaced_kg;
      p.water.centre[0] = x, p.water.centre[1] = y, p.water.centre[2] = z;
    });
  }
  /// Drag in proportion to the velocity of the centre of buoyancy along the axes of frame i, N s/m, and to the angular
  /// velocity about them, N m s/rad.
  constexpr Link drag_linear(double x, double y, double z, double rx = 0.0, double ry = 0.0, double rz = 0.0) const {
    return with([&](auto& p) {
      const double values[] = {x, y, z, rx, ry, rz};
      for (int i = 0; i < 6; ++i)
        p.water.drag_linear[i] = values[i];
    });
  }
  /// The same in proportion to speed times its magnitude, axis by axis: N s^2/m^2, N m s^2/rad^2.
  constexpr Link drag_quadratic(double x, double y, double z, double rx = 0.0, double ry = 0.0, double rz = 0.0) const {
    return with([&](auto& p) {
      const double values[] = {x, y, z, rx, ry, rz};
      for (int i = 0; i < 6; ++i)
        p.water.drag_quadratic[i] = values[i];
    });
  }

  /// Index of the link that carries this joint (0 is the first), or LinkParameters::base. Default: the link before.
  constexpr Link parent(int index) const {
    return with([&](auto& p) { p.parent = index; });
  }
  /// Where this joint leaves a parent that carries several: before alpha and a, a turn in radians about and a shift in
  /// m along the parent's z axis (Khalil and Kleinfinger's tree parameters gamma and b). Use branch_deg for right
  /// angles.
  constexpr Link branch(double gamma, double b) const {
    return with([&](auto& p) { p.gamma = Angle::from_radians(gamma), p.b = b; });
  }
  /// The same with gamma in degrees; 0, 90, 180, -90 are exact and cost nothing.
  constexpr Link branch_deg(double gamma, double b) const {
    return with([&](auto& p) { p.gamma = Angle::from_degrees(gamma), p.b = b; });
  }

 private:
  LinkParameters p_;
};

/// A link that turns about its z axis.
constexpr Link revolute() { return Link(JointType::revolute); }
/// A link that slides along its z axis.
constexpr Link prismatic() { return Link(JointType::prismatic); }

}  // namespace axial
