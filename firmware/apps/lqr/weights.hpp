#pragma once
/// What the regulator weighs: on each joint so large an error is worth the declared effort limit. Speeds are not
/// weighed.

#include <axial/axial.hpp>

namespace axial::apps {

constexpr double worth_effort_rad = 0.03, worth_effort_m = 0.01;

/// 1/rad^2 or 1/m^2
constexpr double position_weight(bool slides) {
  const double error = slides ? worth_effort_m : worth_effort_rad;
  return 1.0 / (error * error);
}
/// 1/(N m)^2 or 1/N^2
constexpr double effort_weight(double effort_limit) { return 1.0 / (effort_limit * effort_limit); }

/// Whether position i is in metres: of a slide, or of a drive that alone moves one.
template <class Scene>
constexpr bool is_in_metres(int i) {
  using Robot = robot_of<Scene>;
  if constexpr (detail::shares_drives_in<typename scene_of<Scene>::Robot>) {
    const int owner = detail::drive_matrix<Robot>.owner[i];
    return Robot::chain.links[owner].type == JointType::prismatic && detail::drive_matrix<Robot>.is_alone(owner);
  } else {
    return Robot::chain.links[i].type == JointType::prismatic;
  }
}

}  // namespace axial::apps
