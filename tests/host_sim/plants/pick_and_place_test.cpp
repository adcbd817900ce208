#include <host_sim/robots/trajectory/pick_and_place.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using host_sim::Cycle;
using host_sim::JointLimits;
using host_sim::SetPoint;
using host_sim::Trajectory;

const std::vector<JointLimits> limits = {{-2.0, 2.0, 3.0, 20.0}, {-1.5, 1.5, 5.0, 40.0}, {-0.2, 0.1, 0.5, 6.0}};

Cycle cycle() {
  Cycle cycle;
  cycle.robot = "test";
  cycle.way_points = {{"home", {0.0, 0.0, 0.0}, 0.0},
                      {"above", {1.2, -0.7, 0.0}, 0.01},
                      {"pick", {1.2, -0.7, -0.15}, 0.05},
                      {"home again", {0.0, 0.0, 0.0}, 0.0}};
  return cycle;
}

TEST(PickAndPlace, TicksAreEvenlySpaced) {
  const Trajectory trajectory = plan(cycle(), limits);
  for (std::size_t i = 0; i < trajectory.size(); ++i)
    EXPECT_DOUBLE_EQ(trajectory[i].time, 0.001 * static_cast<double>(i));
}

TEST(PickAndPlace, RestsAtEveryWayPointInOrder) {
  const Trajectory trajectory = plan(cycle(), limits);
  const std::vector<double> zero(limits.size(), 0.0);
  std::size_t tick = 0;
  for (const auto& way_point : cycle().way_points) {
    const auto rests = [&](const SetPoint& x) { return x.q == way_point.q && x.qd == zero && x.qdd == zero; };
    while (tick < trajectory.size() && !rests(trajectory[tick]))
      ++tick;
    EXPECT_LT(tick, trajectory.size()) << way_point.name;
  }
  EXPECT_EQ(tick + 1, trajectory.size());
}

TEST(PickAndPlace, StaysInsideSpeedAndAccelerationLimits) {
  for (const SetPoint& point : plan(cycle(), limits))
    for (std::size_t i = 0; i < limits.size(); ++i) {
      EXPECT_LE(std::abs(point.qd[i]), limits[i].speed * (1.0 + 1e-12));
      EXPECT_LE(std::abs(point.qdd[i]), limits[i].acceleration * (1.0 + 1e-12));
    }
}

TEST(PickAndPlace, IsContinuousFromTickToTick) {
  const Cycle c = cycle();
  const Trajectory trajectory = plan(c, limits);
  for (std::size_t k = 1; k < trajectory.size(); ++k)
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const SetPoint &a = trajectory[k - 1], &b = trajectory[k];
      const double jerk = limits[i].acceleration / c.jerk_time;
      EXPECT_LE(std::abs(b.q[i] - a.q[i]), limits[i].speed * c.tick * (1.0 + 1e-9));
      EXPECT_LE(std::abs(b.qd[i] - a.qd[i]), limits[i].acceleration * c.tick * (1.0 + 1e-9));
      EXPECT_LE(std::abs(b.qdd[i] - a.qdd[i]), jerk * c.tick * (1.0 + 1e-9));
    }
}

TEST(PickAndPlace, JointsMoveOnAStraightLine) {
  const Cycle c = cycle();
  const host_sim::Move move(c.way_points[0].q, c.way_points[1].q, limits, c);
  for (int i = 0; i <= 100; ++i) {
    const SetPoint point = move.at(move.duration() * i / 100);
    EXPECT_NEAR(point.q[0] * -0.7, point.q[1] * 1.2, 1e-15);
  }
}

TEST(PickAndPlace, DwellsAsLongAsAsked) {
  const Cycle c = cycle();
  int ticks = 0;
  for (const SetPoint& point : plan(c, limits))
    ticks += point.q == c.way_points[2].q ? 1 : 0;
  EXPECT_GE(ticks, 50);
  EXPECT_LE(ticks, 52);  // the moves before and after touch the way-point too
}

// Positions that torque rates can be asked of have two derivatives more, and are asked for by name.
TEST(PickAndPlace, IsSmoothWhereAsked) {
  for (const SetPoint& point : plan(cycle(), limits))
    EXPECT_TRUE(point.q3.empty() && point.q4.empty());
  Cycle smooth = cycle();
  smooth.smooth = true;
  const Trajectory trajectory = plan(smooth, limits);
  const double h = smooth.tick;
  double most = 0.0;
  for (std::size_t k = 1; k + 1 < trajectory.size(); ++k) {
    const SetPoint &before = trajectory[k - 1], &here = trajectory[k], &after = trajectory[k + 1];
    ASSERT_EQ(here.q3.size(), here.q.size());
    ASSERT_EQ(here.q4.size(), here.q.size());
    for (std::size_t i = 0; i < here.q.size(); ++i) {
      most = std::fmax(most, std::fabs(here.q3[i]));
      EXPECT_NEAR(here.q3[i], (after.qdd[i] - before.qdd[i]) / (2.0 * h), 5.0) << k << ", " << i;
      EXPECT_NEAR(here.qdd[i], (after.qd[i] - before.qd[i]) / (2.0 * h), 0.05) << k << ", " << i;
    }
  }
  EXPECT_GT(most, 50.0);
}

TEST(PickAndPlace, UtilisationSlowsTheCycle) {
  Cycle slow = cycle();
  slow.utilisation = 0.5;
  EXPECT_GT(plan(slow, limits).size(), plan(cycle(), limits).size());
}

/// What is said of a cycle that cannot be planned; nothing of one that can.
std::string refusal_of(const Cycle& bad, const std::vector<JointLimits>& of = limits) {
  try {
    plan(bad, of);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(PickAndPlace, RefusesAWayPointOutsideTheLimits) {
  for (std::size_t i = 0; i < limits.size(); ++i)
    for (const double wrong : {limits[i].position_min - 0.01, limits[i].position_max + 0.01, std::nan("")}) {
      Cycle bad = cycle();
      bad.way_points[1].q[i] = wrong;
      EXPECT_EQ(refusal_of(bad), "way-point '" + bad.way_points[1].name + "': joint " + std::to_string(i + 1) +
                                     " is outside its position limits");
    }
}

TEST(PickAndPlace, RefusesAWrongNumberOfJoints) {
  Cycle bad = cycle();
  bad.way_points[0].q.pop_back();
  EXPECT_EQ(refusal_of(bad), "way-point '" + bad.way_points[0].name + "' has 2 joints, the robot has 3");
}

TEST(PickAndPlace, RefusesAMoveWithoutAWay) {
  Cycle bad = cycle();
  bad.way_points[1].q = bad.way_points[0].q;
  EXPECT_EQ(refusal_of(bad), "way-point '" + bad.way_points[1].name + "' repeats the one before; give that a dwell");
  bad.way_points.resize(1);
  EXPECT_EQ(refusal_of(bad), "a cycle needs at least two way-points");
}

TEST(PickAndPlace, RefusesJointsWithoutLimits) {
  EXPECT_EQ(refusal_of(cycle()), "");
  for (std::size_t i = 0; i < limits.size(); ++i)
    for (double JointLimits::*limit : {&JointLimits::speed, &JointLimits::acceleration}) {
      auto unlimited = limits;
      unlimited[i].*limit = std::numeric_limits<double>::infinity();
      EXPECT_EQ(refusal_of(cycle(), unlimited),
                "joint " + std::to_string(i + 1) + " of " + cycle().robot +
                    " declares no speed or acceleration limit to plan a trajectory with");
    }
}

}  // namespace
