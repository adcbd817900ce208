// Which rule a description breaks first. The rules and their bounds: doc/guides/description_rules.md.
#pragma once

#include <axial/robot/drive_matrix.hpp>
#include <axial/robot/given.hpp>
#include <axial/robot/link_parameters.hpp>
#include <axial/robot/principal_moments.hpp>
#include <axial/robot/problems.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Bounds of what a robot can be.
namespace bound {
inline constexpr double length = 100.0;          // m
inline constexpr double position = 1000.0;       // rad
inline constexpr double turn = 6.2831853071796;  // rad, rounded up: 360 degrees are one turn
inline constexpr double mass = 1000.0;           // kg
inline constexpr double inertia_defect = 0.05;   // share by which published tensors miss what bodies have
}  // namespace bound

constexpr double magnitude_of(double x) { return x < 0.0 ? -x : x; }
constexpr bool finite(double x) {
  return x >= -(std::numeric_limits<double>::max)() && x <= (std::numeric_limits<double>::max)();
}
constexpr bool finite(const double* values, int count) {
  for (int i = 0; i < count; ++i)
    if (!finite(values[i])) return false;
  return true;
}
constexpr bool not_negative(const double* values, int count) {
  for (int i = 0; i < count; ++i)
    if (!(values[i] >= 0.0) || !finite(values[i])) return false;
  return true;
}
constexpr bool is_far(double metres) { return magnitude_of(metres) > bound::length; }
constexpr bool is_far(const double (&position)[3]) {
  return is_far(position[0]) || is_far(position[1]) || is_far(position[2]);
}

constexpr Problem geometry_problem(const LinkParameters& p, int index) {
  if (!finite(p.a) || !finite(p.d)) return Problem::a_or_d_is_not_finite;
  if (!finite(p.alpha.radians) || !finite(p.theta.radians)) return Problem::alpha_or_theta_is_not_finite;
  if (!finite(p.gamma.radians) || !finite(p.b)) return Problem::branch_is_not_finite;
  if (p.parent != LinkParameters::previous && (p.parent < LinkParameters::base || p.parent >= index))
    return Problem::parent_does_not_precede;
  return Problem::none;
}

/// Problem with the numbers of a joint that shares drives.
constexpr Problem drive_numbers_problem(const LinkParameters& p) {
  const JointDrives& d = p.drives;
  for (int n = 0; n < d.count && n < JointDrives::most; ++n)
    if (!finite(d.ratio[n]) || !finite(d.offset) || d.ratio[n] == 0.0)
      return Problem::drive_ratio_is_not_finite_or_zero;
  if (!(p.drive_min < p.drive_max && p.drive_speed_limit > 0.0 && p.drive_acceleration_limit > 0.0))
    return Problem::drive_limits_are_upside_down;
  return Problem::none;
}
/// Problem with what joint i makes of its chain's drives, of which G is made.
template <int N>
constexpr Problem shared_drives_problem(const DriveMatrix<N>& g, const LinkParameters& p, int i) {
  if (!g.is_there(i)) return Problem::drives_are_no_drives_of_the_chain;
  const bool has_limits = is_bounded(p.effort_limit) || p.has_drive_limits();
  const bool has_friction =
      p.viscous != 0.0 || p.coulomb_forward != 0.0 || p.coulomb_backward != 0.0 || p.static_friction != 0.0;
  if (g.drive_of(i) < 0 && (has_limits || has_friction || p.rotor_inertia != 0.0))
    return Problem::joint_without_drive_has_what_a_drive_has;
  return Problem::none;
}

constexpr Problem body_problem(const LinkParameters& p, const Given& given) {
  if (!finite(p.mass) || !finite(p.com, 3) || !finite(p.inertia_com, 6))
    return Problem::mass_com_or_inertia_is_not_finite;
  if (p.mass < 0.0) return Problem::mass_is_negative;
  if (given.body_after_inertia) return Problem::inertia_origin_precedes_mass_or_com;
  if (!finite(p.rotor_inertia) || !finite(p.gear) || (p.rotor_inertia != 0.0 && p.gear == 0.0))
    return Problem::rotor_inertia_or_gear_is_no_value;
  if (p.rotor_inertia < 0.0) return Problem::rotor_inertia_is_negative;
  return Problem::none;
}

constexpr Problem rotor_problem(const LinkParameters& p, const Given& given, int index) {
  const auto& axis = p.rotor_axis;
  const bool is_zero = axis[0] == 0.0 && axis[1] == 0.0 && axis[2] == 0.0;
  if (!finite(axis, 3) || (is_zero && given.has(Quantity::rotor_axis))) return Problem::rotor_axis_is_no_direction;
  if (p.rotor_carrier != LinkParameters::previous &&
      (p.rotor_carrier < LinkParameters::base || p.rotor_carrier >= index))
    return Problem::rotor_carrier_does_not_precede;
  return Problem::none;
}

constexpr Problem friction_problem(const LinkParameters& p) {
  constexpr double least_speed = 1e-9;  // its inverse square is still a float
  if (!finite(p.viscous) || !finite(p.coulomb_forward) || !finite(p.coulomb_backward))
    return Problem::friction_is_not_finite;
  if (p.viscous < 0.0) return Problem::viscous_is_negative;
  if (p.coulomb_forward < 0.0 || p.coulomb_backward > 0.0) return Problem::coulomb_feeds_energy_in;
  if (!finite(p.static_friction) || !finite(p.stribeck_speed) || !finite(p.smooth_speed))
    return Problem::stribeck_or_smooth_speed_is_not_finite;
  if (p.static_friction != 0.0 && (p.static_friction < p.coulomb_forward || p.static_friction < -p.coulomb_backward))
    return Problem::stribeck_effort_is_below_coulomb;
  if (p.static_friction != 0.0 && p.stribeck_speed < least_speed) return Problem::stribeck_speed_is_too_small;
  if (p.smooth_speed != 0.0 && p.smooth_speed < least_speed) return Problem::smooth_speed_is_too_small;
  if (!finite(p.spring_stiffness) || !finite(p.spring_rest)) return Problem::spring_is_not_finite;
  if (!(p.stiffness > 0.0)) return Problem::stiffness_is_not_positive;
  return Problem::none;
}

constexpr Problem limit_problem(const LinkParameters& p, const Given& given) {
  if (!(p.position_min < p.position_max)) return Problem::position_limits_are_upside_down;
  if (given.degrees_of_a_slide) return Problem::position_limits_deg_of_a_slide;
  if (!(p.speed_limit > 0.0)) return Problem::speed_limit_is_not_positive;
  if (!(p.acceleration_limit > 0.0)) return Problem::acceleration_limit_is_not_positive;
  if (!(p.effort_limit > 0.0)) return Problem::effort_limit_is_not_positive;
  return Problem::none;
}

constexpr Problem water_problem(const WaterParameters& w) {
  if (!not_negative(w.added_mass, 3) || !not_negative(w.added_inertia, 3))
    return Problem::added_mass_is_negative_or_not_finite;
  if (!not_negative(&w.displaced_mass, 1) || !finite(w.centre, 3)) return Problem::buoyancy_is_negative_or_not_finite;
  if (!not_negative(w.drag_linear, 6) || !not_negative(w.drag_quadratic, 6))
    return Problem::drag_is_negative_or_not_finite;
  return Problem::none;
}

/// Numbers that mean nothing.
constexpr Problem structural_problem(const LinkParameters& p, const Given& given, int index) {
  const Problem found[] = {geometry_problem(p, index), body_problem(p, given),  rotor_problem(p, given, index),
                           friction_problem(p),        limit_problem(p, given), water_problem(p.water)};
  for (const Problem problem : found)
    if (problem != Problem::none) return problem;
  return Problem::none;
}

constexpr Problem twice_problem(unsigned twice, Problem first) {
  for (unsigned i = 0; twice != 0; ++i, twice >>= 1U)
    if ((twice & 1U) != 0) return static_cast<Problem>(static_cast<unsigned>(first) + i);
  return Problem::none;
}

constexpr Problem length_problem(const LinkParameters& p) {
  if (is_far(p.a)) return Problem::a_is_beyond_100_m;
  if (is_far(p.d)) return Problem::d_is_beyond_100_m;
  if (is_far(p.b)) return Problem::b_of_branch_is_beyond_100_m;
  if (is_far(p.com)) return Problem::com_is_beyond_100_m;
  if (is_far(p.water.centre)) return Problem::buoyancy_centre_is_beyond_100_m;
  return Problem::none;
}

constexpr Problem turn_problem(const LinkParameters& p) {
  if (magnitude_of(p.alpha.radians) > bound::turn) return Problem::alpha_is_beyond_one_turn;
  if (magnitude_of(p.theta.radians) > bound::turn) return Problem::theta_is_beyond_one_turn;
  if (magnitude_of(p.gamma.radians) > bound::turn) return Problem::gamma_of_branch_is_beyond_one_turn;
  return Problem::none;
}

constexpr bool is_whole(double x) {
  return magnitude_of(x) < 1e9 && static_cast<double>(static_cast<long long>(x)) == x;
}
/// Whole numbers of which the larger is 90 to 400 are degrees; multiples of 100 are round numbers of radians too.
constexpr bool looks_like_degrees(double min, double max) {
  const double larger = magnitude_of(min) > magnitude_of(max) ? magnitude_of(min) : magnitude_of(max);
  return is_whole(min) && is_whole(max) && larger >= 90.0 && larger <= 400.0 && !is_whole(larger / 100.0);
}

constexpr Problem range_problem(const LinkParameters& p) {
  const auto is_beyond = [&](double most) {
    return (finite(p.position_min) && magnitude_of(p.position_min) > most) ||
           (finite(p.position_max) && magnitude_of(p.position_max) > most);
  };
  if (p.type == JointType::prismatic)
    return is_beyond(bound::length) ? Problem::position_limits_are_beyond_100_m : Problem::none;
  if (is_beyond(bound::position)) return Problem::position_limits_are_beyond_1000_rad;
  if (looks_like_degrees(p.position_min, p.position_max)) return Problem::position_limits_look_like_degrees;
  return Problem::none;
}

constexpr Problem inertia_problem(const LinkParameters& p, const Given& given) {
  const auto& j = p.inertia_com;
  const bool massless = p.mass == 0.0;
  if (massless && !(j[0] == 0.0 && j[1] == 0.0 && j[2] == 0.0 && j[3] == 0.0 && j[4] == 0.0 && j[5] == 0.0))
    return Problem::inertia_without_mass;
  if (!given.has(Quantity::mass) && !(p.com[0] == 0.0 && p.com[1] == 0.0 && p.com[2] == 0.0))
    return Problem::com_without_mass;
  if (physically_consistent(j, p.mass)) return Problem::none;
  const InertiaDefect defect = inertia_defect(principal_moments(j));
  if (defect.negative > bound::inertia_defect) return Problem::inertia_is_not_positive_definite;
  if (defect.triangle > bound::inertia_defect) return Problem::inertia_breaks_the_triangle_inequality;
  return Problem::none;
}

/// Numbers that no robot has, unless they are accepted as published.
constexpr Problem doubtful_problem(const LinkParameters& p, const Given& given, double heaviest) {
  const Problem found[] = {twice_problem(given.twice, Problem::a_is_given_twice),
                           length_problem(p),
                           turn_problem(p),
                           range_problem(p),
                           p.mass > heaviest ? Problem::mass_is_beyond_1000_kg : Problem::none,
                           inertia_problem(p, given)};
  for (const Problem problem : found)
    if (problem != Problem::none) return problem;
  return Problem::none;
}

/// The first rule that a link breaks; `index` counts from 0. A body that floats may be heavier: a ship.
constexpr Problem link_problem(const LinkParameters& p, const Given& given, int index, bool accepted,
                               double heaviest = bound::mass) {
  const Problem structural = structural_problem(p, given, index);
  if (structural != Problem::none || accepted || given.accepted) return structural;
  return doubtful_problem(p, given, heaviest);
}

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
