#include <host_sim/robots/trajectory/s_curve.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using host_sim::PathLimits;
using host_sim::PathState;
using host_sim::SCurve;

/// One set of limits for each shape that the profile can take.
struct Shape {
  const char* name;
  PathLimits limits;
};
const Shape shapes[] = {
    {"AllSevenSegments", {0.5, 2.0, 20.0}},
    {"AccelerationLimitNeverReached", {0.1, 5.0, 10.0}},
    {"SpeedLimitNeverReached", {100.0, 2.0, 20.0}},
    {"NeitherLimitReached", {100.0, 90.0, 5.0}},
    {"LongCruise", {1e-3, 1.0, 1e3}},
    {"AccelerationLimitNearlyReached", {0.2, 5.0, 100.0}},
    {"SmallAccelerationLimitReached", {0.1, 0.5, 4.0}},
};

class EveryShape : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(SCurve, EveryShape, testing::ValuesIn(shapes),
                         [](const auto& instance) { return instance.param.name; });

constexpr int steps = 4000;
constexpr double rounding = 1e-12;

TEST_P(EveryShape, RestsAtBothEndsExactly) {
  const SCurve curve(GetParam().limits);
  for (const double time : {-1.0, 0.0})
    EXPECT_EQ(curve.at(time).s, 0.0);
  for (const double past : {0.0, 1.0}) {
    const PathState end = curve.at(curve.duration() + past);
    EXPECT_EQ(end.s, 1.0);
    EXPECT_EQ(end.speed, 0.0);
    EXPECT_EQ(end.acceleration, 0.0);
  }
}

TEST_P(EveryShape, StaysInsideItsLimits) {
  const PathLimits limits = GetParam().limits;
  const SCurve curve(limits);
  for (int i = 0; i <= steps; ++i) {
    const PathState x = curve.at(curve.duration() * i / steps);
    EXPECT_GE(x.speed, -rounding);
    EXPECT_LE(x.speed, limits.speed * (1.0 + rounding));
    EXPECT_LE(std::abs(x.acceleration), limits.acceleration * (1.0 + rounding));
  }
}

/// A step of h changes s, speed and acceleration by no more than the next derivative's limit allows.
TEST_P(EveryShape, IsContinuousInPositionSpeedAndAcceleration) {
  const PathLimits limits = GetParam().limits;
  const SCurve curve(limits);
  const double h = curve.duration() / steps;
  for (int i = 0; i < steps; ++i) {
    const PathState a = curve.at(h * i), b = curve.at(h * (i + 1));
    EXPECT_LE(std::abs(b.s - a.s), limits.speed * h * (1.0 + 1e-9));
    EXPECT_LE(std::abs(b.speed - a.speed), limits.acceleration * h * (1.0 + 1e-9));
    EXPECT_LE(std::abs(b.acceleration - a.acceleration), limits.jerk * h * (1.0 + 1e-9));
  }
}

/// Trapezoidal sums of the derivatives give back the states: they are derivatives of one another.
TEST_P(EveryShape, SpeedAndAccelerationAreDerivatives) {
  const PathLimits limits = GetParam().limits;
  const SCurve curve(limits);
  const double h = curve.duration() / steps;
  double s = 0.0, speed = 0.0;
  for (int i = 0; i < steps; ++i) {
    const PathState a = curve.at(h * i), b = curve.at(h * (i + 1));
    s += 0.5 * h * (a.speed + b.speed);
    speed += 0.5 * h * (a.acceleration + b.acceleration);
    const double trapezoid_error = limits.jerk * h * h;  // of one step, times the four corners that the jerk has
    EXPECT_NEAR(speed, b.speed, trapezoid_error);
    EXPECT_NEAR(s, b.s, trapezoid_error * curve.duration());
  }
}

/// Fastest: some limit is active, or the way is too short for any and takes the time of pure jerk.
TEST_P(EveryShape, ReachesALimit) {
  const PathLimits limits = GetParam().limits;
  const SCurve curve(limits);
  double speed = 0.0, acceleration = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const PathState x = curve.at(curve.duration() * i / steps);
    speed = std::max(speed, x.speed);
    acceleration = std::max(acceleration, x.acceleration);
  }
  const double pure_jerk_time = 4.0 * std::cbrt(0.5 / limits.jerk);
  const bool at_a_limit = speed > 0.999 * limits.speed || acceleration > 0.999 * limits.acceleration ||
                          std::abs(curve.duration() - pure_jerk_time) < rounding;
  EXPECT_TRUE(at_a_limit);
}

}  // namespace
