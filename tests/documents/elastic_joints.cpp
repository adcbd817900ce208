// doc/guides/elastic_joints.md.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/cost.hpp>
#include <axial/elastic/elastic_damping.hpp>
#include <robots/puma560.hpp>

namespace {

#include "elastic_joints-1.inc"
constexpr axial::Joints<Arm, float> q{0.25F, -0.5F}, qd{1.0F, 0.5F}, qdd{2.0F, -1.0F}, q3{4.0F, 8.0F},
    q4{-20.0F, 10.0F};

struct ElasticPuma {
  static constexpr auto chain = [] {
    auto chain = robots::Puma560::chain;
    for (auto& link : chain.links)
      link.stiffness = 12000.0;
    return chain;
  }();
};

TEST(ElasticJointsGuide, ItsLinesCompileAndAgree) {
  const int i = 1;
#include "elastic_joints-2.inc"
  EXPECT_NEAR(position, q[i] + spring / 2500.0F, 1e-7F);
  EXPECT_NE(speed, qd[i]);
#include "elastic_joints-3.inc"
  EXPECT_EQ(rubbed.tau_m[i], torque) << "none declared";
  EXPECT_TRUE(axial::check_finite(motor.tau_m, motor.theta, motor.thetad).ok());
#include "elastic_joints-4.inc"
  EXPECT_EQ(rate.taud[i], rates.taud[i]);
  EXPECT_NE(rates.taudd[i], 0.0F);
  EXPECT_NEAR(rate.tau[i], spring + 0.3F * qdd[i], 1e-5F) << "rigid joints move rotors as their links";
}

TEST(ElasticJointsGuide, DampingStaysClose) {
  const int i = 1;
#include "elastic_joints-2.inc"
#include "elastic_joints-6.inc"
  EXPECT_NE(damped.theta[1], position);
  EXPECT_NEAR(damped.theta[1], position, 12.0F / 2500.0F) << "speeds are below 10 rad/s";
  EXPECT_EQ(damped.tau_l[1], spring);
  EXPECT_EQ(damped.tau_m[1], torque) << "a first call: the deflection accelerates as without damping";
  EXPECT_NE(damped.thetad[1], speed);
}

TEST(ElasticJointsGuide, CostsAreAsItSays) {
#include "elastic_joints-5.inc"
  SUCCEED() << "the compiler has checked it";
}

}  // namespace
