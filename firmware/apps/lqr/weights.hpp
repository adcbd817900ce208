#pragma once
/// What the regulator weighs: on each joint so large an error is worth the declared effort limit. Speeds are not
/// weighed.

namespace axial::apps {

constexpr double worth_effort_rad = 0.03, worth_effort_m = 0.01;

/// 1/rad^2 or 1/m^2
constexpr double position_weight(bool slides) {
  const double error = slides ? worth_effort_m : worth_effort_rad;
  return 1.0 / (error * error);
}
/// 1/(N m)^2 or 1/N^2
constexpr double effort_weight(double effort_limit) { return 1.0 / (effort_limit * effort_limit); }

}  // namespace axial::apps
