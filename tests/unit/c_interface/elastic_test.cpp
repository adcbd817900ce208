// The feed-forward of elastic joints has in C the bits that it has in C++, in float and double.
#include <axial/c_interface/elastic.hpp>

#include <limits>

#include <gtest/gtest.h>

#include <robots/scara.hpp>

#include "elastic_c_side.h"

namespace {

/// The last joint, the slide, is rigid.
struct ElasticScara {
  static constexpr auto chain = [] {
    auto chain = robots::Scara::chain;
    chain.links[0].stiffness = 6000.0, chain.links[1].stiffness = 2500.0;
    for (auto& link : chain.links)
      link.rotor_inertia = 1e-4, link.gear = 50.0, link.viscous = 0.5;
    return chain;
  }();
};
using Rubbed = axial::Scene<ElasticScara, axial::Gravity, axial::RotorInertia, axial::Friction, axial::ElasticJoints>;

}  // namespace

AXIAL_C_EXPORT(elastic_arm, ElasticScara, float)
AXIAL_C_EXPORT_ELASTIC(elastic_arm, ElasticScara, float)
AXIAL_C_EXPORT(double_elastic_arm, Rubbed, double)
AXIAL_C_EXPORT_ELASTIC(double_elastic_arm, Rubbed, double)

namespace {

constexpr double values[5][3] = {
    {0.7, -1.1, 0.125}, {1.5, -2.0, 0.5}, {4.0, 9.0, -3.0}, {20.0, -40.0, 10.0}, {-300.0, 200.0, 100.0}};

template <class Motion>
Motion motion() {
  Motion all;
  for (int k = 0; k < 5; ++k)
    for (int i = 0; i < 3; ++i)
      all.of[k].of[i] = static_cast<std::decay_t<decltype(all.of[k].of[i])>>(values[k][i]);
  return all;
}

template <class S, class T, class Motion, class Answers>
void expect_equal(const Motion& x, const Answers& answers) {
  const auto of = [&](int k) { return axial::Joints<ElasticScara, T>{x.of[k].of[0], x.of[k].of[1], x.of[k].of[2]}; };
  const auto motors = axial::elastic_feedforward<S>(of(0), of(1), of(2), of(3), of(4));
  EXPECT_EQ(answers.status.code, AXIAL_OK);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(answers.motors.tau_m.of[i], motors.tau_m[i]) << i;
    EXPECT_EQ(answers.motors.theta.of[i], motors.theta[i]) << i;
    EXPECT_EQ(answers.motors.thetad.of[i], motors.thetad[i]) << i;
    EXPECT_EQ(answers.motors.tau_l.of[i], motors.tau_l[i]) << i;
  }
  EXPECT_NE(answers.motors.tau_m.of[1], answers.motors.tau_l.of[1]) << "a motor has a rotor";
  EXPECT_NE(answers.motors.theta.of[1], x.of[0].of[1]) << "a spring gives way";
  EXPECT_EQ(answers.motors.theta.of[2], x.of[0].of[2]) << "a rigid joint does not";
}

}  // namespace

TEST(CElasticJoints, InFloatEqualCxx) {
  const auto x = motion<elastic_arm_motion>();
  expect_equal<ElasticScara, float>(x, ask_elastic_arm_motors(&x));
}
TEST(CElasticJoints, OfASceneInDoubleEqualCxx) {
  const auto x = motion<double_elastic_arm_motion>();
  expect_equal<Rubbed, double>(x, ask_double_elastic_arm_motors(&x));
}

TEST(CElasticJoints, RefuseWhatIsNotFiniteAndLeaveTheResult) {
  for (int k = 0; k < 5; ++k) {
    SCOPED_TRACE(k);
    auto x = motion<elastic_arm_motion>();
    x.of[k].of[1] = std::numeric_limits<float>::quiet_NaN();
    elastic_arm_elastic result{};
    result.tau_m.of[0] = 7.0F;
    const axial_status status =
        elastic_arm_elastic_feedforward(&x.of[0], &x.of[1], &x.of[2], &x.of[3], &x.of[4], &result);
    EXPECT_EQ(status.code, AXIAL_NOT_FINITE);
    EXPECT_EQ(status.joint, 1);
    EXPECT_EQ(result.tau_m.of[0], 7.0F);
  }
}

TEST(CElasticJoints, RefuseNullPointers) {
  const elastic_arm_joints x{};
  elastic_arm_elastic result;
  EXPECT_EQ(elastic_arm_elastic_feedforward(&x, &x, &x, &x, nullptr, &result).code, AXIAL_NULL_ARGUMENT);
  EXPECT_EQ(elastic_arm_elastic_feedforward(&x, &x, &x, nullptr, &x, &result).code, AXIAL_NULL_ARGUMENT);
  EXPECT_EQ(elastic_arm_elastic_feedforward(&x, &x, &x, &x, &x, nullptr).code, AXIAL_NULL_ARGUMENT);
}
