// Cycles of robots whose joints share drives: of the drives, within the limits of both. G is written by hand.
#include <host_sim/plants/loop/cycle.hpp>
#include <host_sim/plants/simulation/models.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <robots/robots.hpp>

using namespace host_sim;

namespace {

using Rows = std::vector<std::vector<double>>;

std::vector<double> times(const Rows& g, const std::vector<double>& u) {
  std::vector<double> q;
  for (const auto& row : g) {
    q.push_back(0.0);
    for (std::size_t k = 0; k < u.size(); ++k)
      q.back() += row[k] * u[k];
  }
  return q;
}

/// Largest share of a limit that is used.
struct Shares {
  double position = 0.0, speed = 0.0, acceleration = 0.0;
};

/// Of all drives by `of_drives`, of all joints by the links' own limits.
template <class R>
Shares expect_within(const Rows& g) {
  const auto trajectory = loop::cycle_of(R::name);
  const auto joints = simulation::robot_links(R::name);
  Shares most;
  const auto look = [&](const axial::LinkParameters& link, double q, double qd, double qdd) {
    EXPECT_GE(q, link.position_min - 1e-12);
    EXPECT_LE(q, link.position_max + 1e-12);
    most.speed = std::max(most.speed, std::fabs(qd) / link.speed_limit);
    most.acceleration = std::max(most.acceleration, std::fabs(qdd) / link.acceleration_limit);
  };
  for (const SetPoint& at : trajectory) {
    EXPECT_EQ(at.q.size(), g.front().size());
    const auto q = times(g, at.q), qd = times(g, at.qd), qdd = times(g, at.qdd);
    for (std::size_t i = 0; i < joints.size(); ++i)
      look(joints[i], q[i], qd[i], qdd[i]);
    for (std::size_t k = 0; k < at.q.size(); ++k)
      look(axial::scene_of<R>::Robot::chain.links[k], at.q[k], at.qd[k], at.qdd[k]);
  }
  return most;
}

}  // namespace

TEST(Cycles, OfSharedDrivesKeepTheLimitsOfDrivesAndOfJoints) {
  constexpr double lead = 0.020 / (2 * 3.14159265358979323846);
  const Rows quill{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, lead, -lead}, {0, 0, 0, 1}};
  const Rows wrist{{1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, -1, 1, 0, 0}, {0, 0, 0, 0.5, 0.5}, {0, 0, 0, 0.5, -0.5}};
  for (const Shares& most : {expect_within<robots::ScaraQuill>(quill), expect_within<robots::WristArm>(wrist)}) {
    EXPECT_LE(most.speed, 0.9 + 1e-9);
    EXPECT_LE(most.acceleration, 0.9 + 1e-9);
    EXPECT_GE(std::max(most.speed, most.acceleration), 0.89) << "a limit is what decides";
  }
}

TEST(Cycles, OfSharedDrivesHaveNoSmoothForm) { EXPECT_THROW(loop::cycle_of("scara_quill", true), std::runtime_error); }
