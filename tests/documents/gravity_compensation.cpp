// doc/guides/gravity_compensation.md: an arm that a hand moves, a trajectory, the same in fixed point.
#include <gtest/gtest.h>

#include <cmath>

#include <axial/fixed.hpp>
#include <robots/panda.hpp>

namespace {
namespace floating {

#include "gravity_compensation-1.inc"
#include "gravity_compensation-2.inc"
#include "gravity_compensation-3.inc"

using Joints = axial::Joints<Robot, float>;
const Joints q{0.1F, -0.4F, 0.3F, -1.2F, 0.5F, 1.6F, 0.2F};

TEST(GravityCompensationPage, TheArmFloatsOnceTheTorqueHasComeUp) {
  begin();
  Joints torque{}, last{};
  for (int k = 0; k < 100; ++k) {
    EXPECT_TRUE(guide(q, torque));
    for (int i = 0; i < 7; ++i)
      EXPECT_LE(std::fabs(torque[i] - last[i]), 1.001F * state.output.step[i]);
    last = torque;
  }
  const auto weight = axial::gravity_torque<Arm>(q, in);
  for (int i = 0; i < 7; ++i)
    EXPECT_FLOAT_EQ(torque[i], weight[i]);
  Joints bad = q;
  bad[3] = NAN;
  EXPECT_FALSE(guide(bad, torque));
  EXPECT_FLOAT_EQ(torque[1], weight[1]);
}

TEST(GravityCompensationPage, ATrajectoryGoesOnFromThere) {
  begin();
  Joints torque{};
  for (int k = 0; k < 100; ++k)
    guide(q, torque);
  const Joints before = torque;
  EXPECT_TRUE(follow({q, {}, {}, {}}, {q, {}, {}}, torque));
  for (int i = 0; i < 7; ++i)
    EXPECT_NEAR(torque[i], before[i], 1e-3F);
  Joints ahead = q;
  ahead[0] += 0.01F;
  EXPECT_TRUE(follow({ahead, {}, {}, {}}, {q, {}, {}}, torque));
  EXPECT_GT(torque[0], before[0]);
}

TEST(GravityCompensationPage, FixedPointDoesTheSame) {
  begin();
  const axial::Joints<Robot, double> at{0.1, -0.4, 0.3, -1.2, 0.5, 1.6, 0.2};
  const auto wanted =
      axial::to_fixed_request<Arm, std::int32_t>(at, axial::Joints<Robot, double>{}, axial::Joints<Robot, double>{});
  const auto answer = tick(wanted, {wanted.q, wanted.qd, wanted.status});
  EXPECT_TRUE(answer.status.ok());
  const auto weight = axial::gravity_torque<Arm>(q, in);
  for (int i = 0; i < 7; ++i)
    EXPECT_NEAR(axial::to_real<float>(answer.tau)[i], weight[i], 1e-3F);
}

}  // namespace floating
}  // namespace
