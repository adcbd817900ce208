// doc/guides/derivatives.md.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/cost.hpp>
#include <axial/fixed.hpp>
#include <cmath>
#include <robots/panda.hpp>
#include <robots/puma560.hpp>
#include <robots/roarm_m2.hpp>
#include <robots/scara.hpp>

namespace {

using Robot = robots::Puma560;
constexpr axial::Joints<Robot, float> q{0.1F, -0.4F, 0.3F, 0.2F, 0.5F, -0.6F}, qd{0.5F, 0.2F, -0.3F, 0.1F, 0.4F, 0.2F},
    qdd{1.0F, -1.0F, 2.0F, 1.0F, 0.5F, 0.1F}, tau{1.0F, 2.0F, 3.0F, 0.5F, 0.25F, 0.125F},
    dq{0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F}, dqd{}, dqdd{}, dtau{};

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

TEST(DerivativesGuide, AlongADirectionIsTheJacobiansColumn) {
  const int i = 1, j = 2;
#include "derivatives-3.inc"
  EXPECT_NEAR(change, (axial::inverse_dynamics_derivatives<Robot>(q, qd, qdd).dtau_dq(i, j)), 1e-5F);
  EXPECT_NEAR(reaction, (axial::forward_dynamics_derivatives<Robot>(q, qd, tau).dqdd_dq(i, j)), 1e-4F);
}

TEST(DerivativesGuide, TheRegressorHasWhatALinkWeighs) {
  const int i = 1, j = 2;
#include "derivatives-4.inc"
  EXPECT_EQ(by_mass, y(i, 10 * j));
  EXPECT_EQ(by_any, y(i, j, axial::InertialParameter::xx));
  EXPECT_EQ(by_rotor, qdd[i]);
}

TEST(DerivativesGuide, WordsHaveAnExponentAndACertifiedError) {
  const auto wanted = axial::to_fixed_request<Robot, std::int32_t>(q, qd, qdd);
  ASSERT_TRUE(wanted.status.ok());
#include "derivatives_fixed-1.inc"
#include "derivatives_fixed-2.inc"
  EXPECT_NEAR(slope, (axial::inverse_dynamics_derivatives<Robot>(q, qd, qdd).dtau_dq(1, 2)), 1e-5);
  const auto effort = axial::inverse_dynamics<Robot>(q, qd, qdd);
  EXPECT_TRUE(proved.qdd.status.ok());
  EXPECT_NEAR(mobile, (axial::forward_dynamics_derivatives<Robot>(q, qd, effort).M_inverse(1, 2)), 1e-5);
  EXPECT_LT(within, 1e-5);
}

TEST(DerivativesGuide, CostsAreAsItSays) {
#include "derivatives-5.inc"
  SUCCEED() << "the compiler has checked it";
}

TEST(DerivativesGuide, OfTheToolAreSlopesOfItsJacobian) {
  const axial::ForceVector<axial::Vec3<float>, axial::Vec3<float>> wrench{{0.0F, 0.0F, 0.0F}, {10.0F, 0.0F, -20.0F}};
#include "derivatives-6.inc"
  const auto bias = axial::bias_acceleration(jacobian, qd);
  float sum = 0.0F;
  for (int k = 0; k < 6; ++k)
    sum += rate[k].linear.x * qd[k];
  EXPECT_NEAR(sum, bias.linear.x, 1e-6F);
  EXPECT_EQ(slope(1, 2), slope(2, 1));
}

}  // namespace
