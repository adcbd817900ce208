#include <host_sim/robots/trajectory/s_curve.hpp>

#include <algorithm>
#include <cmath>

namespace host_sim {

SCurve::SCurve(const PathLimits& limits) : jerk_(limits.jerk) {
  const double v = limits.speed, a = limits.acceleration, j = limits.jerk;
  const bool reaches_acceleration = v * j >= a * a;
  jerk_time_ = reaches_acceleration ? a / j : std::sqrt(v / j);
  ramp_ = reaches_acceleration ? jerk_time_ + v / a : 2.0 * jerk_time_;
  cruise_ = 1.0 / v - ramp_;
  if (cruise_ >= 0.0) return;

  cruise_ = 0.0;  // too short a way to reach the speed limit
  const double half = 0.5 * a / j;
  if (1.0 >= 2.0 * a * a * a / (j * j)) {
    jerk_time_ = a / j;
    ramp_ = half + std::sqrt(half * half + 1.0 / a);
  } else {
    jerk_time_ = std::cbrt(0.5 / j);
    ramp_ = 2.0 * jerk_time_;
  }
}

PathState SCurve::at(double time) const {
  if (time <= 0.0) return {};
  if (time >= duration()) return {1.0, 0.0, 0.0};
  if (time <= 0.5 * duration()) return first_half(time);
  const PathState mirrored = first_half(duration() - time);  // the profile is symmetric; so it ends at 1 exactly
  return {1.0 - mirrored.s, mirrored.speed, -mirrored.acceleration};
}

PathState SCurve::first_half(double time) const {
  const double segments[] = {jerk_time_, ramp_ - 2.0 * jerk_time_, jerk_time_};
  const double jerks[] = {jerk_, 0.0, -jerk_};
  PathState x;
  for (int i = 0; i < 3 && time > 0.0; ++i) {
    const double t = std::min(time, segments[i]), j = jerks[i];
    x = {x.s + t * (x.speed + t * (x.acceleration / 2.0 + t * j / 6.0)), x.speed + t * (x.acceleration + t * j / 2.0),
         x.acceleration + t * j};
    time -= segments[i];
  }
  if (time > 0.0) x = {x.s + x.speed * time, x.speed, 0.0};
  return x;
}

}  // namespace host_sim
