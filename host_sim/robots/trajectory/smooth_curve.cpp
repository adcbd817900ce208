#include <host_sim/robots/trajectory/smooth_curve.hpp>

#include <algorithm>
#include <cmath>

namespace host_sim {

namespace {

constexpr double steepest = 35.0 / 16.0;                 // slope of the ramp at its middle
const double most_bent = 84.0 / (5.0 * std::sqrt(5.0));  // its second derivative, at (1 - 1/sqrt 5)/2

}  // namespace

SmoothCurve::SmoothCurve(const PathLimits& limits) {
  const double a = limits.acceleration / steepest, j = limits.jerk / most_bent;
  speed_ = std::min({limits.speed, std::sqrt(a), std::cbrt(j)});  // the latter two: ramps that meet in the middle
  ramp_ = std::max(speed_ / a, std::sqrt(speed_ / j));
  cruise_ = std::max(0.0, 1.0 / speed_ - ramp_);
  if (cruise_ == 0.0) ramp_ = 1.0 / speed_;
}

PathState SmoothCurve::at(double time) const {
  if (time <= 0.0) return {};
  if (time >= duration()) return {1.0, 0.0, 0.0};
  if (time <= 0.5 * duration()) return first_half(time);
  const PathState x = first_half(duration() - time);  // the profile is symmetric; so it ends at 1 exactly
  return {1.0 - x.s, x.speed, -x.acceleration, x.jerk, -x.snap};
}

PathState SmoothCurve::first_half(double time) const {
  if (time >= ramp_) return {0.5 * speed_ * ramp_ + speed_ * (time - ramp_), speed_, 0.0};
  const double x = time / ramp_, y = 1.0 - x, x2 = x * x, x4 = x2 * x2;
  const double v = speed_, a = v / ramp_, j = a / ramp_, s = j / ramp_;
  return {v * ramp_ * x4 * x * (7.0 - x * (14.0 - x * (10.0 - 2.5 * x))),
          v * x4 * (35.0 - x * (84.0 - x * (70.0 - 20.0 * x))), a * 140.0 * x2 * x * y * y * y,
          j * 420.0 * x2 * y * y * (y - x), s * 840.0 * x * y * (1.0 - 5.0 * x * y)};
}

}  // namespace host_sim
