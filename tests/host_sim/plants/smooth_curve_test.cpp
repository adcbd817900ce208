#include <host_sim/robots/trajectory/smooth_curve.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using host_sim::PathLimits;
using host_sim::PathState;
using host_sim::SmoothCurve;

const PathLimits shapes[] = {
    {0.5, 2.0, 1e3},    // cruises; ramps as steep as the acceleration allows
    {0.5, 2.0, 4.0},    // cruises; ramps as bent as the jerk allows
    {100.0, 2.0, 1e3},  // too short a way to cruise
    {100.0, 90.0, 5.0},
};
constexpr int steps = 20000;
constexpr double rounding = 1e-12;

template <class Check>
void each_shape(const Check& check) {
  for (const PathLimits& limits : shapes) {
    SCOPED_TRACE(limits.jerk);
    check(limits, SmoothCurve(limits));
  }
}

TEST(SmoothCurve, RestsAtBothEndsExactly) {
  each_shape([](const PathLimits&, const SmoothCurve& curve) {
    EXPECT_EQ(curve.at(0.0).s, 0.0);
    const PathState end = curve.at(curve.duration());
    EXPECT_EQ(end.s, 1.0);
    EXPECT_EQ(end.speed, 0.0);
    EXPECT_NEAR(curve.at(0.5 * curve.duration()).s, 0.5, rounding);
  });
}

TEST(SmoothCurve, ReachesALimitAndPassesNone) {
  each_shape([](const PathLimits& limits, const SmoothCurve& curve) {
    double speed = 0.0, acceleration = 0.0, jerk = 0.0;
    for (int i = 0; i <= steps; ++i) {
      const PathState x = curve.at(curve.duration() * i / steps);
      speed = std::max(speed, x.speed / limits.speed);
      acceleration = std::max(acceleration, std::abs(x.acceleration) / limits.acceleration);
      jerk = std::max(jerk, std::abs(x.jerk) / limits.jerk);
    }
    EXPECT_LE(std::max({speed, acceleration, jerk}), 1.0 + rounding);
    EXPECT_GE(std::max(acceleration, jerk), 0.999);
  });
}

/// Differences of second order of each derivative are the next one; the fourth has no jump either.
TEST(SmoothCurve, HasFourContinuousDerivatives) {
  each_shape([](const PathLimits&, const SmoothCurve& curve) {
    const double h = curve.duration() / steps;
    double largest[5] = {};
    const auto values = [&](int i) {
      const PathState x = curve.at(h * i);
      return std::vector<double>{x.s, x.speed, x.acceleration, x.jerk, x.snap};
    };
    for (int i = 0; i <= steps; ++i)
      for (std::size_t k = 0; k < 5; ++k)
        largest[k] = std::max(largest[k], std::abs(values(i)[k]));
    for (int i = 1; i < steps; ++i) {
      const auto before = values(i - 1), here = values(i), after = values(i + 1);
      for (std::size_t k = 0; k < 4; ++k)  // one step moves a derivative by some thousandths of its largest value
        EXPECT_NEAR((after[k] - before[k]) / (2.0 * h), here[k + 1], 2e-3 * largest[k + 1]) << k << " at " << i;
      EXPECT_LE(std::abs(after[4] - here[4]), 4e-3 * largest[4]) << i;
    }
  });
}

}  // namespace
