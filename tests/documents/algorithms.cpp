// doc/guides/choosing.md, doc/measurements/counts.md, doc/guides/scenes.md, doc/measurements/separation.md,
// doc/measurements/simulation.md, doc/measurements/plant.md: lines in a control loop.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/cost.hpp>
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/integrators.hpp>
#include <axial/simulation/integrators.hpp>
#include <axial/simulation/step_limit.hpp>
#include <cmath>
#include <robots/puma560.hpp>

namespace {

using Robot = robots::Puma560;
constexpr axial::Joints<Robot, float> q{0.1F, -0.4F, 0.3F, 0.2F, 0.5F, -0.6F}, qd{0.5F, 0.2F, -0.3F, 0.1F, 0.4F, 0.2F},
    qdd{1.0F, -1.0F, 2.0F, 1.0F, 0.5F, 0.1F};

TEST(Counts, AreConstants) {
  using MyScene = Robot;
#include "counts-1.inc"
}

TEST(Choosing, EveryFormIsTheSameTorque) {
#include "choosing-1.inc"
#include "choosing-2.inc"
  axial::Inputs<Known, float> in;
  for (int i = 0; i < 6; ++i)
    in.turns[i] = {std::sin(q[i]), std::cos(q[i])};
  const auto plain = axial::inverse_dynamics<Plain>(q, qd, qdd), small = axial::inverse_dynamics<Small>(q, qd, qdd),
             known = axial::inverse_dynamics<Known>(q, qd, qdd, in);
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(small[i], plain[i], 1e-4F);
    EXPECT_NEAR(known[i], plain[i], 1e-4F);
  }
}

TEST(Scenes, PayloadIsAnInput) {
#include "scenes-1.inc"
  using Bare = axial::Scene<Robot, axial::Gravity, axial::RotorInertia, axial::Friction>;
  const auto light = axial::inverse_dynamics<Bare>(q, qd, qdd);
  EXPECT_GT(std::abs(tau[1] - light[1]), 1.0F);
}

TEST(Separation, TermsMakeTheTorque) {
#include "separation-1.inc"
  const auto whole = axial::inverse_dynamics<Robot>(q, qd, qdd);
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(tau[i], whole[i], 1e-4F);
    EXPECT_EQ(G.G[i], terms.G[i]);
  }
}

TEST(Simulation, AStepIsTaken) {
  const axial::Joints<Robot, float> tau{};
#include "simulation-1.inc"
  EXPECT_TRUE(status.ok());
  EXPECT_NE(x.qd[1], 0.0F);
  EXPECT_GT(most, 0.0F);
}

TEST(Plant, AStepIsTaken) {
#include "plant-1.inc"
  EXPECT_TRUE(status.ok());
  EXPECT_NE(x.qd[1].raw, 0);
}

}  // namespace
