#include <host_sim/boards/demo/bounds.hpp>

#include <host_sim/robots/robots/fixed_format.hpp>
#include <host_sim/tools/output/progress.hpp>

#include <algorithm>
#include <cmath>

namespace host_sim {

namespace {

constexpr double float_rounding = 0x1p-24;

using Values = std::vector<double>;

/// |change| of the exact torques by a step of every single coordinate, all added to `moved`.
void add_steps(const Robot& robot, const Sample& sample, Values SetPoint::*quantity, const Values& steps,
               Values& moved) {
  for (std::size_t j = 0; j < steps.size(); ++j) {
    SetPoint stepped = sample.asked;
    (stepped.*quantity)[j] += steps[j];
    const Values torque = exact_torque(robot, stepped);
    for (std::size_t i = 0; i < moved.size(); ++i)
      moved[i] += std::abs(torque[i] - sample.exact[i]);
  }
}

/// To first order, which is all there is at 1e-9.
Values moved_by_rounding(const Robot& robot, const FixedFormat& format, const Sample& sample) {
  Values moved(sample.exact.size(), 0.0);
  add_steps(robot, sample, &SetPoint::q, format.q, moved);
  add_steps(robot, sample, &SetPoint::qd, format.qd, moved);
  add_steps(robot, sample, &SetPoint::qdd, format.qdd, moved);
  return moved;
}

}  // namespace

std::vector<double> float_bounds(const std::vector<double>& scales) {
  std::vector<double> bounds;
  for (const double scale : scales)
    bounds.push_back(float_bound(static_cast<int>(scales.size())) * scale);
  return bounds;
}

std::vector<double> fixed32_bounds(const Recording& recording, const Robot& robot) {
  const FixedFormat format = fixed32_format(robot.name);
  Values bounds(format.torque.size(), 0.0);
  Progress progress("bounding errors", recording.samples.size());
  std::size_t done = 0;
  for (const Sample& sample : recording.samples) {
    const Values moved = moved_by_rounding(robot, format, sample);
    for (std::size_t i = 0; i < bounds.size(); ++i)
      bounds[i] = std::max(bounds[i], format.torque[i] + moved[i] + float_rounding * std::abs(sample.exact[i]));
    progress.at(++done);
  }
  return bounds;
}

}  // namespace host_sim
