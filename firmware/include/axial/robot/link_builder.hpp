// What every builder of a link names alike, whichever frames its geometry is written in.
#pragma once

#include <axial/robot/given.hpp>
#include <axial/robot/link_parameters.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Fluent builder of LinkParameters: all but a and alpha, which Self names. Every call returns a changed copy.
/// "Its frame" is the link's own: frame i of Self's convention.
template <class Self>
class LinkBuilder {
 public:
  /// A link with all else at the defaults of LinkParameters.
  constexpr explicit LinkBuilder(JointType type) { p_.type = type; }

  constexpr const LinkParameters& parameters() const { return p_; }  ///< the description as fields
  constexpr const detail::Given& given() const { return given_; }    ///< what has been named, for chain()'s checks

 protected:
  using Quantity = detail::Quantity;  ///< what a call names

  /// A copy that `change`, called with its fields, has changed.
  template <class Change>
  constexpr Self changed(Change change) const {
    Self copy = static_cast<const Self&>(*this);
    change(copy.p_);
    return copy;
  }
  /// A copy in which `change` has set a quantity that is named once.
  template <class Change>
  constexpr Self with(Quantity quantity, Change change) const {
    Self changed = static_cast<const Self&>(*this);
    changed.given_.note(quantity);
    change(changed.p_);
    return changed;
  }  // before its uses: clang needs it for constants

 public:
  /// Joint offset in m along the joint's axis; for a prismatic joint the offset added to its position.
  constexpr Self d(double metres) const {
    return with(Quantity::d, [&](auto& p) { p.d = metres; });
  }
  /// Angle in radians about the joint's axis; for a revolute joint the offset added to its position.
  constexpr Self theta(double radians) const {
    return with(Quantity::theta, [&](auto& p) { p.theta = Angle::from_radians(radians); });
  }
  /// theta() in degrees, exact for multiples of 90.
  constexpr Self theta_deg(double degrees) const {
    return with(Quantity::theta, [&](auto& p) { p.theta = Angle::from_degrees(degrees); });
  }

  /// Mass in kg; 0 is legitimate.
  constexpr Self mass(double kg) const {
    return with(Quantity::mass, [&](auto& p) { p.mass = kg; });
  }
  /// Centre of mass in m, in its frame.
  constexpr Self com(double x, double y, double z) const {
    return with(Quantity::com, [&](auto& p) { p.com[0] = x, p.com[1] = y, p.com[2] = z; });
  }
  /// Inertia tensor in kg m^2 about the centre of mass, axes of its frame; products are tensor entries (-integral x y
  /// dm).
  constexpr Self inertia_com(double xx, double yy, double zz, double xy = 0.0, double xz = 0.0, double yz = 0.0) const {
    return with(Quantity::inertia, [&](auto& p) {
      p.inertia_com[0] = xx, p.inertia_com[1] = yy, p.inertia_com[2] = zz;
      p.inertia_com[3] = xy, p.inertia_com[4] = xz, p.inertia_com[5] = yz;
    });
  }
  /// Inertia tensor in kg m^2 about the origin of its frame; give mass and com before it.
  constexpr Self inertia_origin(double xx, double yy, double zz, double xy = 0.0, double xz = 0.0,
                                double yz = 0.0) const {
    const double m = p_.mass, x = p_.com[0], y = p_.com[1], z = p_.com[2];
    Self shifted = inertia_com(xx - m * (y * y + z * z), yy - m * (x * x + z * z), zz - m * (x * x + y * y),
                               xy + m * x * y, xz + m * x * z, yz + m * y * z);
    shifted.given_.inertia_about_origin = true;
    return shifted;
  }

  /// Rotor inertia in kg m^2 on the motor side and gear ratio (motor turns per joint turn): adds gear^2 J to the joint.
  constexpr Self rotor_inertia(double kg_m2, double gear = 1.0) const {
    return with(Quantity::rotor_inertia, [&](auto& p) { p.rotor_inertia = kg_m2, p.gear = gear; });
  }
  /// Viscous friction on the joint side, N m s/rad or N s/m.
  constexpr Self viscous(double coefficient) const {
    return with(Quantity::viscous, [&](auto& p) { p.viscous = coefficient; });
  }
  /// Coulomb friction on the joint side, N m or N, the same in both directions; 0 at rest.
  constexpr Self coulomb(double magnitude) const { return coulomb(magnitude, -magnitude); }
  /// Coulomb friction torque while moving forward (>= 0) and while moving backward (<= 0).
  constexpr Self coulomb(double forward, double backward) const {
    return with(Quantity::coulomb, [&](auto& p) { p.coulomb_forward = forward, p.coulomb_backward = backward; });
  }
  /// Stribeck effect: friction falls from `static_effort` (N m or N, in either direction) at breakaway to the Coulomb
  /// friction; at `speed` (rad/s or m/s) half of the difference is left.
  constexpr Self stribeck(double static_effort, double speed) const {
    return with(Quantity::stribeck, [&](auto& p) { p.static_friction = static_effort, p.stribeck_speed = speed; });
  }
  /// Below this speed (rad/s or m/s) Coulomb and Stribeck friction go through 0 smoothly instead of stepping.
  constexpr Self smooth_speed(double speed) const {
    return with(Quantity::smooth_speed, [&](auto& p) { p.smooth_speed = speed; });
  }
  /// A spring across the joint: the drive exerts stiffness (q - rest_position), N m/rad or N/m, against it.
  constexpr Self spring(double stiffness, double rest_position = 0.0) const {
    return with(Quantity::spring, [&](auto& p) { p.spring_stiffness = stiffness, p.spring_rest = rest_position; });
  }
  /// Stiffness of the transmission between drive and link (harmonic drive, belt), on the joint side, N m/rad or N/m.
  constexpr Self stiffness(double value) const {
    return with(Quantity::stiffness, [&](auto& p) { p.stiffness = value; });
  }

  /// Position limits, rad or m.
  constexpr Self position_limits(double min, double max) const {
    return with(Quantity::position_limits, [&](auto& p) { p.position_min = min, p.position_max = max; });
  }
  /// Position limits of a revolute joint in degrees.
  constexpr Self position_limits_deg(double min, double max) const {
    constexpr double radian = 3.14159265358979323846 / 180.0;
    Self limited = position_limits(min * radian, max * radian);
    limited.given_.degrees_of_a_slide = p_.type == JointType::prismatic;
    return limited;
  }
  /// Largest speed, rad/s or m/s.
  constexpr Self speed_limit(double max) const {
    return with(Quantity::speed_limit, [&](auto& p) { p.speed_limit = max; });
  }
  /// Largest acceleration, rad/s^2 or m/s^2.
  constexpr Self acceleration_limit(double max) const {
    return with(Quantity::acceleration_limit, [&](auto& p) { p.acceleration_limit = max; });
  }
  /// Largest effort, N m or N.
  constexpr Self effort_limit(double max) const {
    return with(Quantity::effort_limit, [&](auto& p) { p.effort_limit = max; });
  }

  /// Its joint is moved by the drive of joint k besides its own: q = own drive + ratio drive_k. With k its own index:
  /// how far its own drive moves it. Several calls add up. doc/guides/shared_drives.md.
  constexpr Self driven_by(int k, double ratio = 1.0) const {
    return changed([&](auto& p) { p.drives.name(k, ratio); });
  }
  /// Its joint has no drive of its own: driven_by() says what moves it.
  constexpr Self passive() const {
    return changed([](auto& p) { p.drives.complete = true; });
  }
  /// Its joint has no drive and moves as joint k does: q = ratio q_k + offset (rad or m), whatever drives joint k. What
  /// keeps a rod of a parallelogram parallel, the second finger of a gripper.
  constexpr Self mimic(int k, double ratio = 1.0, double offset = 0.0) const {
    return changed([&](auto& p) {
      p.drives.name(k, ratio), p.drives.follows = p.drives.complete = true, p.drives.offset = offset;
    });
  }
  /// Limits of its own drive where other joints share it: position (rad or m), speed and acceleration. Its effort
  /// limit, rotor and friction are the drive's in any case; a joint's own limits hold besides.
  constexpr Self drive_limits(double min, double max, double speed = LinkParameters::unlimited,
                              double acceleration = LinkParameters::unlimited) const {
    return changed([&](auto& p) {
      p.drive_min = min, p.drive_max = max;
      p.drive_speed_limit = speed, p.drive_acceleration_limit = acceleration;
    });
  }

  /// Keeps numbers that no robot should have, as their source gives them (doc/guides/description_rules.md):
  /// accept(axial::as_published). What means nothing, such as a negative mass, stays refused.
  constexpr Self accept(AsPublished) const {
    Self accepted = static_cast<const Self&>(*this);
    accepted.given_.accepted = true;
    return accepted;
  }

 private:
  LinkParameters p_;
  detail::Given given_;
};

}  // namespace axial

#include <axial/options/end.hpp>
