// Where a quantity of a link stands: among its formats and among its ranges.
#pragma once

#include <axial/fixed/bounds/mechanism.hpp>

#include <axial/options/begin.hpp>

namespace axial::bounds {

/// The largest size of each quantity of a link, in the order of `all_formats`; negative until one is noted.
class LinkSizes {
 public:
  static constexpr int count = static_cast<int>(sizeof(all_formats) / sizeof(all_formats[0]));  ///< quantities

  constexpr LinkSizes() {
    for (double& size : of)
      size = -1.0;
  }
  double of[count]{};  ///< SI
};

/// The members of LinkFormat and LinkRange that hold a quantity.
struct Place {
  int LinkFormat::*format;  ///< its exponent
  Ball LinkRange::*range;   ///< its bound

  /// The quantity's place among the sizes.
  constexpr int index() const {
    int k = 0;
    while (all_formats[k] != format)
      ++k;
    return k;
  }
};

/// Where each quantity stands.
///@{
constexpr Place place_of(quantity::AngularVelocity) {
  return {&LinkFormat::angular_velocity, &LinkRange::angular_velocity};
}
constexpr Place place_of(quantity::AngularAcceleration) {
  return {&LinkFormat::angular_acceleration, &LinkRange::angular_acceleration};
}
constexpr Place place_of(quantity::LinearAcceleration) {
  return {&LinkFormat::linear_acceleration, &LinkRange::linear_acceleration};
}
constexpr Place place_of(quantity::Moment) { return {&LinkFormat::moment, &LinkRange::moment}; }
constexpr Place place_of(quantity::Force) { return {&LinkFormat::force, &LinkRange::force}; }
constexpr Place place_of(quantity::RotationalInertia) {
  return {&LinkFormat::rotational_inertia, &LinkRange::rotational_inertia};
}
constexpr Place place_of(quantity::FirstMoment) { return {&LinkFormat::first_moment, &LinkRange::first_moment}; }
constexpr Place place_of(quantity::Mass) { return {&LinkFormat::mass, &LinkRange::mass}; }
constexpr Place place_of(quantity::JointInertia) { return {&LinkFormat::joint_inertia, &LinkRange::joint_inertia}; }
constexpr Place place_of(quantity::JointEffort) { return {&LinkFormat::joint_effort, &LinkRange::joint_effort}; }
constexpr Place place_of(quantity::GravityAcceleration) { return {&LinkFormat::gravity, &LinkRange::gravity}; }
constexpr Place place_of(quantity::Length) { return {&LinkFormat::length, &LinkRange::length}; }
constexpr Place place_of(quantity::LinearVelocity) {
  return {&LinkFormat::linear_velocity, &LinkRange::linear_velocity};
}
constexpr Place place_of(quantity::AxisAcceleration) {
  return {&LinkFormat::axis_acceleration, &LinkRange::axis_acceleration};
}
constexpr Place place_of(quantity::FlowMoment) { return {&LinkFormat::flow_moment, &LinkRange::flow_moment}; }
constexpr Place place_of(quantity::FlowMomentum) { return {&LinkFormat::flow_momentum, &LinkRange::flow_momentum}; }
constexpr Place place_of(quantity::UnitMoment) { return {&LinkFormat::unit_moment, &LinkRange::unit_moment}; }
constexpr Place place_of(quantity::UnitForce) { return {&LinkFormat::unit_force, &LinkRange::unit_force}; }
constexpr Place place_of(quantity::PositionMoment) {
  return {&LinkFormat::position_moment, &LinkRange::position_moment};
}
constexpr Place place_of(quantity::PositionForce) { return {&LinkFormat::position_force, &LinkRange::position_force}; }
///@}

/// Room that a quantity needs, as a multiple of its norm. Two entries of a matrix' diagonal may have opposite signs,
/// those of an inertia where parameters are regrouped: their difference is what a turn multiplies.
template <class Quantity>
inline constexpr double room_for =
    std::is_same_v<Quantity, quantity::RotationalInertia> || std::is_same_v<Quantity, quantity::FlowMoment> ? 2.0 : 1.0;

}  // namespace axial::bounds

#include <axial/options/end.hpp>
