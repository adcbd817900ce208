// What a link of a robot is: geometry (MDH), inertia, drive, friction, limits, and what water does to it.
#pragma once

#include <axial/scalar/sincos.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Water about a body in axes of its frame; diagonals, about the centre of buoyancy. Scenes that name Underwater see
/// it.
struct WaterParameters {
  double added_mass[3] = {0.0, 0.0, 0.0};                     ///< kg
  double added_inertia[3] = {0.0, 0.0, 0.0};                  ///< kg m^2
  double displaced_mass = 0.0;                                ///< kg of water
  double centre[3] = {0.0, 0.0, 0.0};                         ///< m, centre of buoyancy
  double drag_linear[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};     ///< N s/m (3), N m s/rad (3)
  double drag_quadratic[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};  ///< N s^2/m^2 (3), N m s^2/rad^2 (3)
};

/// A constant angle: its value in radians and its sine-cosine pair.
struct Angle {
  double radians = 0.0;  ///< its value
  double cos = 1.0;      ///< its cosine
  double sin = 0.0;      ///< its sine
  /// From radians; sine and cosine are the library's own, within 1 ulp.
  static constexpr Angle from_radians(double radians) {
    if (!(radians > -1e9 && radians < 1e9)) return {radians, radians, radians};
    const auto pair = sincos(radians);
    return {radians, pair.cos, pair.sin};
  }
  /// From degrees; multiples of 90 have exact sines and cosines, so that structural zeros are recognised.
  static constexpr Angle from_degrees(double degrees) {
    constexpr double radian = 3.14159265358979323846 / 180.0;
    if (!(degrees > -1e9 && degrees < 1e9)) return {degrees, degrees, degrees};
    const auto quarters = static_cast<long long>(degrees / 90.0);
    if (static_cast<double>(quarters) * 90.0 != degrees) return from_radians(degrees * radian);
    constexpr double sines[] = {0.0, 1.0, 0.0, -1.0};
    const auto quadrant = static_cast<unsigned>(((quarters % 4) + 4) % 4);
    return {degrees * radian, sines[(quadrant + 1) % 4], sines[quadrant]};
  }
};

/// How a joint moves its link: about or along its z axis.
enum class JointType : unsigned char { revolute, prismatic };

/// Which drives move a joint, where that is not one of its own alone. Drives are numbered by the joints that own them
/// (robot/drive_matrix.hpp).
struct JointDrives {
  static constexpr int most = 6;  ///< drives of one joint
  int count = 0;                  ///< how many are named; an own drive that is not counts once, unless `complete`
  int of[most] = {};              ///< index of the joint that owns the drive, or of the one that this joint follows
  double ratio[most] = {};        ///< rad or m of the joint per unit of the drive
  double offset = 0.0;            ///< rad or m of a joint that follows another
  bool follows = false;           ///< moves as joint of[0] does: ratio[0] q + offset
  bool complete = false;          ///< nothing but what is named moves the joint

  /// Adds a drive by the index of its joint, `units` rad or m of this joint per unit of the drive.
  constexpr void name(int drive, double units) {
    if (count < most) of[count] = drive, ratio[count] = units;
    ++count;
  }
};

/// What a link is, in SI units and radians. Frame i is fixed to link i, its z axis is joint i's axis; the transform
/// from frame i-1 to frame i is Rx(alpha) Tx(a) Rz(theta) Tz(d) (modified Denavit-Hartenberg); in a tree it starts from
/// the parent's frame, and Rz(gamma) Tz(b) may come before it. All fields are inputs as written by the author of the
/// robot; the algorithms use LinkConstants, derived from them.
struct LinkParameters {
  static constexpr double unlimited = std::numeric_limits<double>::infinity();  ///< no limit
  static constexpr int previous = -2;                                           ///< parent: the link before this one
  static constexpr int base = -1;                                               ///< parent: the fixed base

  JointType type = JointType::revolute;  ///< of the joint that moves this link
  int parent = previous;                 ///< index of the link that carries this joint, or base
  double b = 0.0;                        ///< m, along z of the parent's frame, before all else
  Angle gamma;                           ///< rad, about z of the parent's frame
  double a = 0.0;                        ///< m, along x of frame i-1
  Angle alpha;                           ///< rad, about x of frame i-1
  double d = 0.0;                        ///< m, along z of frame i; a prismatic joint's offset
  Angle theta;                           ///< rad, about z of frame i; a revolute joint's offset
  double mass = 0.0;                     ///< kg
  double com[3] = {0.0, 0.0, 0.0};       ///< m, centre of mass in frame i
  double inertia_com[6] = {
      0.0, 0.0, 0.0, 0.0, 0.0, 0.0};  ///< kg m^2: xx yy zz xy xz yz about the centre of mass,
                                      ///< tensor entries (products with their sign), axes of frame i
  double rotor_inertia = 0.0;         ///< kg m^2, on the motor side
  double gear = 1.0;                  ///< motor turns per joint turn
  int rotor_carrier = previous;       ///< link on which the rotor turns, inboard of its joint; previous: the parent
  double rotor_axis[3] = {0.0, 0.0, 0.0};  ///< direction in the carrier's frame; all 0: the joint's own axis
  double viscous = 0.0;                    ///< N m s/rad or N s/m, on the joint side
  double coulomb_forward = 0.0;            ///< N m or N, friction while moving forward (>= 0)
  double coulomb_backward = 0.0;           ///< N m or N, friction while moving backward (<= 0)
  double static_friction = 0.0;            ///< N m or N, breakaway effort in either direction; 0: no Stribeck effect
  double stribeck_speed = 0.0;             ///< rad/s or m/s, where half of the breakaway beyond Coulomb is left
  double smooth_speed = 0.0;              ///< rad/s or m/s, below which dry friction goes through 0 smoothly; 0: a step
  double spring_stiffness = 0.0;          ///< N m/rad or N/m, of a spring across the joint
  double spring_rest = 0.0;               ///< rad or m, where the spring exerts nothing
  double stiffness = unlimited;           ///< N m/rad or N/m, between drive and link; unlimited: rigid
  double position_min = -unlimited;       ///< rad or m
  double position_max = unlimited;        ///< rad or m
  double speed_limit = unlimited;         ///< rad/s or m/s
  double acceleration_limit = unlimited;  ///< rad/s^2 or m/s^2
  double effort_limit = unlimited;        ///< N m or N
  JointDrives drives{};                   ///< drives that it shares with other joints
  double drive_min = -unlimited;          ///< rad or m, least position of its own drive, where it is shared
  double drive_max = unlimited;           ///< rad or m, largest position of its own drive
  double drive_speed_limit = unlimited;   ///< rad/s or m/s, of its own drive
  double drive_acceleration_limit = unlimited;  ///< rad/s^2 or m/s^2, of its own drive
  WaterParameters water{};                      ///< only scenes that name Underwater see it

  /// Whether limits were given to its own drive.
  constexpr bool has_drive_limits() const {
    return !(drive_min <= -unlimited && drive_max >= unlimited && drive_speed_limit >= unlimited &&
             drive_acceleration_limit >= unlimited);
  }
};

namespace detail {
/// Whether a limit was declared.
constexpr bool is_bounded(double limit) { return limit < (std::numeric_limits<double>::max)(); }
}  // namespace detail

}  // namespace axial

#include <axial/options/end.hpp>
