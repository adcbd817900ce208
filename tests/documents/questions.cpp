// doc/guides/questions.md: a given load, pairs of an encoder, and what answers have.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cmath>
#include <robots/puma560.hpp>

namespace {

using Robot = robots::Puma560;

TEST(Questions, MembersAreThoseThatThePageNames) {
  const axial::Joints<Robot, float> q{0.1F, -0.4F, 0.3F, -1.2F, 0.5F, 1.6F}, qd{0.5F, 0.1F, 0.0F, 0.2F, 0.0F, 0.0F},
      qdd{1.0F, -1.0F, 0.0F, 0.0F, 0.5F, 0.0F};
#include "questions-1.inc"
  using Loaded = axial::Scene<Robot, axial::Gravity, axial::RotorInertia, axial::Payload>;
  axial::Inputs<Loaded, float> load{};
  load.payload = in.payload;
  const auto by_angles = axial::inverse_dynamics<Loaded>(q, qd, qdd, load);
  ASSERT_TRUE(acc.status.ok());
  for (int i = 0; i < axial::joint_count<Robot>; ++i) {
    EXPECT_NEAR(tau[i], by_angles[i], 1e-4F);
    EXPECT_NEAR(acc[i], qdd[i], 1e-2F);
    EXPECT_GT(M(i, i), 0.0F);
  }
  EXPECT_EQ(J[0].angular.z, 1.0F);
  EXPECT_EQ(frames.frames[0].rotation.z.z, 1.0F);
  EXPECT_TRUE(std::isfinite(frames.tool.position.x));
}

}  // namespace
