// C gets the bits that C++ gets, and a status for what C++ would not compile.
#include <axial/axial.hpp>
#include <axial/fixed.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <robots/scara.hpp>

#include "c_side.h"

namespace {

using robots::Scara;
constexpr int joints = 3;

const arm_joints q{{0.7F, -1.1F, 0.125F}}, qd{{1.5F, -2.0F, 0.5F}}, qdd{{4.0F, 9.0F, -3.0F}};

axial::Joints<Scara, float> real(const arm_joints& values) { return {values.of[0], values.of[1], values.of[2]}; }
auto fixed_request() { return axial::to_fixed_request<Scara, std::int32_t>(real(q), real(qd), real(qdd)); }

template <class Answer, class Values>
void expect_same(const Answer& c, const Values& values) {
  for (int i = 0; i < joints; ++i)
    if constexpr (std::is_same_v<std::decay_t<decltype(c.of[0])>, float>)
      EXPECT_EQ(c.of[i], values[i]) << "joint " << i;
    else
      EXPECT_EQ(c.of[i], values[i].raw) << "joint " << i;
}

TEST(CInterface, FloatEqualsCxx) {
  const arm_answers c = ask_arm(&q, &qd, &qdd);
  for (const axial_status& status : c.status)
    EXPECT_EQ(status.code, AXIAL_OK);
  EXPECT_EQ(c.safe_status.code, AXIAL_OK);
  const auto tau = axial::inverse_dynamics<Scara>(real(q), real(qd), real(qdd));
  expect_same(c.safe, tau);
  expect_same(c.inverse, tau);
  expect_same(c.gravity, axial::gravity_torque<Scara>(real(q)));
  expect_same(c.power, axial::actuator_power<Scara>(real(q), real(qd), real(qdd)));
  expect_same(c.acceleration, axial::forward_dynamics<Scara>(real(q), real(qd), tau));
}

TEST(CInterface, MatrixAndPoseEqualCxx) {
  const arm_answers c = ask_arm(&q, &qd, &qdd);
  const auto m = axial::mass_matrix<Scara>(real(q));
  for (int i = 0; i < joints; ++i)
    for (int j = 0; j < joints; ++j)
      EXPECT_EQ(c.mass.of[i][j], m(i, j));
  const auto tool = axial::forward_kinematics<Scara>(real(q)).tool;
  const float rotation[3][3] = {{tool.rotation.x.x, tool.rotation.x.y, tool.rotation.x.z},
                                {tool.rotation.y.x, tool.rotation.y.y, tool.rotation.y.z},
                                {tool.rotation.z.x, tool.rotation.z.y, tool.rotation.z.z}};
  EXPECT_EQ(std::memcmp(rotation, c.tool.rotation, sizeof rotation), 0);
  EXPECT_EQ(c.tool.position[0], tool.position.x);
  EXPECT_EQ(c.tool.position[1], tool.position.y);
  EXPECT_EQ(c.tool.position[2], tool.position.z);
}

TEST(CInterface, FixedEqualsCxx) {
  const auto request = fixed_request();
  fixed_arm_real real_q, real_qd, real_qdd;
  std::memcpy(&real_q, &q, sizeof q);
  std::memcpy(&real_qd, &qd, sizeof qd);
  std::memcpy(&real_qdd, &qdd, sizeof qdd);
  fixed_arm_joints c_q, c_qd, c_qdd;
  EXPECT_EQ(fixed_arm_to_fixed(&real_q, &real_qd, &real_qdd, &c_q, &c_qd, &c_qdd).code, AXIAL_OK);
  const fixed_arm_answers c = ask_fixed_arm(&c_q, &c_qd, &c_qdd);
  const auto tau = axial::inverse_dynamics<Scara>(request.q, request.qd, request.qdd);
  expect_same(c.power, axial::actuator_power<Scara>(request.q, request.qd, request.qdd));
  expect_same(c.safe, tau);
  expect_same(c.inverse, tau);
  expect_same(c.gravity, axial::gravity_torque<Scara>(request.q));
  expect_same(c.acceleration, axial::forward_dynamics<Scara>(request.q, request.qd, tau));
  fixed_arm_real back;
  fixed_arm_efforts_to_real(&c.inverse, &back);
  const arm_answers in_float = ask_arm(&q, &qd, &qdd);
  for (int i = 0; i < joints; ++i)
    EXPECT_NEAR(back.of[i], in_float.inverse.of[i], 2e-6 * 80.0) << "of the largest effort, 80 N m";
}

TEST(CInterface, FormatsTellTheValues) {
  fixed_arm_formats formats;
  ASSERT_EQ(fixed_arm_get_formats(&formats).code, AXIAL_OK);
  EXPECT_EQ(formats.revolute[0], 1);
  EXPECT_EQ(formats.revolute[2], 0);
  const auto request = fixed_request();
  EXPECT_NEAR(std::ldexp(request.q[2].raw, -formats.position[2]), 0.125, std::ldexp(1.0, -formats.position[2]));
  EXPECT_NEAR(std::ldexp(request.qd[1].raw, -formats.velocity[1]), -2.0, std::ldexp(1.0, -formats.velocity[1]));
  EXPECT_NEAR(std::ldexp(request.qdd[1].raw, -formats.acceleration[1]), 9.0, std::ldexp(1.0, -formats.acceleration[1]));
  const fixed_arm_joints raw_q{{request.q[0].raw, request.q[1].raw, request.q[2].raw}}, rest{};
  const fixed_arm_answers c = ask_fixed_arm(&raw_q, &rest, &rest);
  const arm_answers in_float = ask_arm(&q, &qd, &qdd);
  EXPECT_NEAR(std::ldexp(c.mass.of[0][1], -formats.mass_matrix[0][1]), in_float.mass.of[0][1], 1e-6);
  EXPECT_NEAR(std::ldexp(c.tool.position[0], -formats.length), in_float.tool.position[0], 1e-6);
  EXPECT_NEAR(std::ldexp(c.tool.rotation[0][0], -formats.rotation), in_float.tool.rotation[0][0], 1e-6);
  EXPECT_NEAR(std::ldexp(c.gravity.of[2], -formats.effort[2]), in_float.gravity.of[2], 1e-5);
  const fixed_arm_joints raw_qd{{request.qd[0].raw, request.qd[1].raw, request.qd[2].raw}};
  const fixed_arm_joints raw_qdd{{request.qdd[0].raw, request.qdd[1].raw, request.qdd[2].raw}};
  const fixed_arm_answers moving = ask_fixed_arm(&raw_q, &raw_qd, &raw_qdd);
  EXPECT_NEAR(std::ldexp(moving.power.of[0], -formats.power[0]), in_float.power.of[0], 1e-3);
}

TEST(CInterface, RefusesWhatIsNotFinite) {
  arm_joints bad = q, tau{{7.0F, 8.0F, 9.0F}};
  bad.of[1] = std::numeric_limits<float>::quiet_NaN();
  const axial_status status = arm_inverse_dynamics(&bad, &qd, &qdd, &tau);
  EXPECT_EQ(status.code, AXIAL_NOT_FINITE);
  EXPECT_EQ(status.joint, 1);
  EXPECT_EQ(tau.of[0], 7.0F) << "the result is untouched";
  EXPECT_EQ(arm_gravity(&bad, &tau).code, AXIAL_NOT_FINITE);
  EXPECT_EQ(arm_forward_dynamics(&q, &qd, &bad, &tau).code, AXIAL_NOT_FINITE);
  arm_pose pose;
  EXPECT_EQ(arm_tool_pose(&bad, &pose).joint, 1);
  arm_matrix m;
  EXPECT_EQ(arm_mass_matrix(&bad, &m).joint, 1);
}

// Numbers from which none follow: an angle of so many turns, a speed whose square overflows.
TEST(CInterface, RefusesWhatAnswersNoNumber) {
  arm_joints far = q, fast = qd, tau{{7.0F, 8.0F, 9.0F}};
  far.of[0] = 1e6F, fast.of[0] = 1e25F;
  arm_pose pose{};
  arm_matrix m{};
  for (const axial_status& status : {arm_inverse_dynamics(&far, &qd, &qdd, &tau), arm_gravity(&far, &tau),
                                     arm_tool_pose(&far, &pose), arm_mass_matrix(&far, &m)})
    EXPECT_EQ(status.code, AXIAL_ANGLE_RANGE);
  EXPECT_EQ(arm_inverse_dynamics(&q, &fast, &qdd, &tau).code, AXIAL_NOT_FINITE);
  EXPECT_EQ(tau.of[0], 7.0F) << "the result is untouched";
  EXPECT_EQ(pose.rotation[0][0], 0.0F);
  EXPECT_EQ(m.of[0][0], 0.0F);
}

TEST(CInterface, FixedRefusesWhatIsOutsideTheLimits) {
  const auto request = fixed_request();
  const fixed_arm_joints raw_q{{request.q[0].raw, request.q[1].raw, request.q[2].raw}}, rest{};
  const fixed_arm_joints fast{{0, std::numeric_limits<std::int32_t>::max(), 0}};
  fixed_arm_joints tau{{1, 2, 3}};
  const axial_status status = fixed_arm_inverse_dynamics(&raw_q, &fast, &rest, &tau);
  EXPECT_EQ(status.code, AXIAL_SPEED_LIMIT);
  EXPECT_EQ(status.joint, 1);
  EXPECT_EQ(tau.of[2], 3);
}

TEST(CInterface, FeedforwardKeepsTheLastSafeTorque) {
  arm_state state{};
  arm_joints first, second, fast = qd;
  ASSERT_EQ(arm_feedforward(&state, &q, &qd, &qdd, &first).code, AXIAL_OK);
  fast.of[0] = 4.5F;  // the limit is 4 rad/s
  const axial_status status = arm_feedforward(&state, &q, &fast, &qdd, &second);
  EXPECT_EQ(status.code, AXIAL_SPEED_LIMIT);
  EXPECT_EQ(status.joint, 0);
  EXPECT_EQ(std::memcmp(&first, &second, sizeof first), 0);
}

TEST(CInterface, NullPointersAreRefused) {
  arm_joints tau;
  arm_state state{};
  EXPECT_EQ(arm_feedforward(nullptr, &q, &qd, &qdd, &tau).code, AXIAL_NULL_ARGUMENT);
  EXPECT_EQ(arm_feedforward(&state, &q, &qd, &qdd, nullptr).code, AXIAL_NULL_ARGUMENT);
  EXPECT_EQ(arm_inverse_dynamics(&q, nullptr, &qdd, &tau).code, AXIAL_NULL_ARGUMENT);
  EXPECT_EQ(arm_gravity(nullptr, &tau).code, AXIAL_NULL_ARGUMENT);
  EXPECT_EQ(arm_forward_dynamics(&q, &qd, nullptr, &tau).code, AXIAL_NULL_ARGUMENT);
  EXPECT_EQ(arm_mass_matrix(&q, nullptr).code, AXIAL_NULL_ARGUMENT);
  EXPECT_EQ(arm_tool_pose(&q, nullptr).code, AXIAL_NULL_ARGUMENT);
  EXPECT_EQ(fixed_arm_get_formats(nullptr).code, AXIAL_NULL_ARGUMENT);
}

TEST(CInterface, EveryCodeHasItsText) {
  std::set<std::string> texts;
  for (int code = AXIAL_OK; code <= AXIAL_EFFORT_RATE; ++code) {
    EXPECT_STRNE(c_text(code), c_text(-1)) << code;
    EXPECT_STREQ(c_text(code), axial_code_text(code));
    EXPECT_STREQ(c_text(code), axial_status_text({code, -1}));
    EXPECT_STREQ(c_text(code), axial::status_text(static_cast<axial::Status::Code>(code))) << "C++ says the same";
    texts.insert(c_text(code));
  }
  texts.insert(c_text(AXIAL_NULL_ARGUMENT));
  EXPECT_EQ(texts.size(), 16u);
}

}  // namespace
