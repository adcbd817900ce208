#pragma once
/// A smooth motion inside the limits that a robot declares: every joint a sine about the middle of its range.

#include <axial/axial.hpp>

#include "../states.hpp"

namespace axial::apps::run {

constexpr double period_s = 4.0;  ///< of the slowest joint
constexpr double used = 0.8;      ///< of what the limits allow
constexpr int samples = 41;       ///< one period, both ends included
constexpr double step_s = period_s / (samples - 1);

/// Where one joint stands at time t (s): rad or m, and its first two derivatives.
struct Motion {
  double q = 0.0, qd = 0.0, qdd = 0.0;
};

constexpr double least(double a, double b) { return a < b ? a : b; }

/// Joint i's turn rate: joints are out of step with each other, so that every pair of speeds occurs.
constexpr double rate(int i) { return 6.283185307179586476925 / period_s * (1.0 + 0.25 * (i % 4)); }

/// Limits that are missing are those of states.hpp.
template <class Robot>
constexpr Motion motion(int i, double t) {
  const auto& limits = reach_of<Robot>.joints[i];
  const double w = rate(i);
  const double amplitude =
      used * least(static_cast<double>(limits.position),
                   least(static_cast<double>(limits.speed) / w, static_cast<double>(limits.acceleration) / (w * w)));
  auto wave = sincos(w * t);
  if (wave.cos < 1e-9 && wave.cos > -1e-9)
    wave.cos = 0.0;  // at rest in every number system: friction depends on the sign
  return {static_cast<double>(limits.middle) + amplitude * wave.sin, amplitude * w * wave.cos,
          -amplitude * w * w * wave.sin};
}

}  // namespace axial::apps::run
