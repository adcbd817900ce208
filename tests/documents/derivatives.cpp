// doc/guides/derivatives.md.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/cost.hpp>
#include <cmath>
#include <robots/panda.hpp>
#include <robots/puma560.hpp>
#include <robots/scara.hpp>

namespace {

using Robot = robots::Puma560;
constexpr axial::Joints<Robot, float> q{0.1F, -0.4F, 0.3F, 0.2F, 0.5F, -0.6F}, qd{0.5F, 0.2F, -0.3F, 0.1F, 0.4F, 0.2F},
    qdd{1.0F, -1.0F, 2.0F, 1.0F, 0.5F, 0.1F}, tau{1.0F, 2.0F, 3.0F, 0.5F, 0.25F, 0.125F};

TEST(DerivativesGuide, ItsLinesCompileAndAgree) {
  const int i = 1, j = 2;
#include "derivatives-1.inc"
  EXPECT_TRUE(f.qdd.status.ok());
  EXPECT_EQ(torque, axial::inverse_dynamics<Robot>(q, qd, qdd)[i]);
  EXPECT_NEAR(mass, axial::mass_matrix<Robot>(q)(i, j), 1e-6F);
  EXPECT_NEAR(acceleration, axial::forward_dynamics<Robot>(q, qd, tau)[i], 1e-4F);
  EXPECT_NE(stiffness, damping);
  EXPECT_GT(std::abs(mobility * by_angle * by_speed), 0.0F);
#include "derivatives-2.inc"
  EXPECT_EQ(slopes.dtau_dqd(i, j), d.dtau_dqd(i, j));
}

TEST(DerivativesGuide, CostsAreAsItSays) {
#include "derivatives-3.inc"
  SUCCEED() << "the compiler has checked it";
}

}  // namespace
