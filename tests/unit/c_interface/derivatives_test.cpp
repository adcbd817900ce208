// Derivatives in C have the bits that they have in C++, in float, double and fixed point.
#include <axial/c_interface/derivatives.hpp>
#include <axial/fixed/c_interface/derivative_formats.hpp>

#include <limits>

#include <gtest/gtest.h>

#include <robots/scara.hpp>

#include "c_side.h"

AXIAL_C_EXPORT_DERIVATIVES(arm, robots::Scara, float)
AXIAL_C_EXPORT(double_arm, robots::Scara, double)
AXIAL_C_EXPORT_DERIVATIVES(double_arm, robots::Scara, double)
AXIAL_C_EXPORT_DERIVATIVES(fixed_arm, robots::Scara, fixed32)
AXIAL_C_EXPORT_DERIVATIVE_FORMATS(fixed_arm, robots::Scara)

namespace {

using robots::Scara;

template <class CMatrix, class Matrix>
void expect_same(const CMatrix& c, const Matrix& m) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_EQ(c.of[i][j], m(i, j)) << i << " " << j;
}

template <class T, class Answers, class C>
void expect_equal(const Answers& answers, const C& q, const C& qd, const C& x) {
  const auto of = [](const C& c) { return axial::Joints<Scara, T>{c.of[0], c.of[1], c.of[2]}; };
  EXPECT_EQ(answers.inverse_status.code, AXIAL_OK);
  EXPECT_EQ(answers.forward_status.code, AXIAL_OK);
  const auto inverse = axial::inverse_dynamics_derivatives<Scara>(of(q), of(qd), of(x));
  const auto forward = axial::forward_dynamics_derivatives<Scara>(of(q), of(qd), of(x));
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(answers.inverse.tau.of[i], inverse.tau[i]);
    EXPECT_EQ(answers.forward.qdd.of[i], forward.qdd[i]);
  }
  expect_same(answers.inverse.mass_matrix, inverse.M);
  expect_same(answers.inverse.dtau_dq, inverse.dtau_dq);
  expect_same(answers.inverse.dtau_dqd, inverse.dtau_dqd);
  expect_same(answers.forward.inverse_mass_matrix, forward.M_inverse);
  expect_same(answers.forward.dqdd_dq, forward.dqdd_dq);
  expect_same(answers.forward.dqdd_dqd, forward.dqdd_dqd);
}

const arm_joints q{{0.7F, -1.1F, 0.125F}}, qd{{1.5F, -2.0F, 0.5F}}, x{{4.0F, 9.0F, -3.0F}};

}  // namespace

TEST(CDerivatives, InFloatEqualCxx) { expect_equal<float>(ask_arm_derivatives(&q, &qd, &x), q, qd, x); }
TEST(CDerivatives, InDoubleEqualCxx) {
  const double_arm_joints p{{0.7, -1.1, 0.125}}, v{{1.5, -2.0, 0.5}}, a{{4.0, 9.0, -3.0}};
  expect_equal<double>(ask_double_arm_derivatives(&p, &v, &a), p, v, a);
}

TEST(CDerivatives, InFixedPointEqualCxx) {
  using T = axial::Fixed32;
  const fixed_arm_joints p{{1 << 28, -(1 << 29), 1 << 27}}, v{{1 << 26, 1 << 25, 1 << 24}},
      a{{1 << 22, 1 << 21, 1 << 20}};
  const auto answers = ask_fixed_arm_derivatives(&p, &v, &a);
  const auto into = [](auto values, const fixed_arm_joints& c) {
    for (int i = 0; i < 3; ++i)
      values[i].raw = c.of[i];
    return values;
  };
  const auto q_words = into(axial::Positions<Scara, T>{}, p);
  const auto qd_words = into(axial::Velocities<Scara, T>{}, v);
  const auto inverse =
      axial::inverse_dynamics_derivatives<Scara>(q_words, qd_words, into(axial::Accelerations<Scara, T>{}, a));
  const auto forward =
      axial::forward_dynamics_derivatives<Scara>(q_words, qd_words, into(axial::EffortsOf<Scara, T>{}, a));
  EXPECT_EQ(answers.inverse_status.code, AXIAL_OK);
  EXPECT_EQ(answers.forward_status.code, static_cast<int>(forward.qdd.status.code));
  EXPECT_EQ(answers.forward_status.joint, forward.qdd.status.joint);
  fixed_arm_derivative_formats formats;
  ASSERT_EQ(ask_derivative_formats(&formats).code, AXIAL_OK);
  const auto expect = [](const fixed_arm_matrix& c, const fixed_arm_matrix& exponents, const auto& m) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        EXPECT_EQ(c.of[i][j], m(i, j).raw) << i << " " << j;
        EXPECT_EQ(exponents.of[i][j], m.exponent(i, j)) << i << " " << j;
      }
  };
  expect(answers.inverse.mass_matrix, formats.mass_matrix, inverse.M);
  expect(answers.inverse.dtau_dq, formats.dtau_dq, inverse.dtau_dq);
  expect(answers.inverse.dtau_dqd, formats.dtau_dqd, inverse.dtau_dqd);
  expect(answers.forward.inverse_mass_matrix, formats.inverse_mass_matrix, forward.M_inverse);
  expect(answers.forward.dqdd_dq, formats.dqdd_dq, forward.dqdd_dq);
  expect(answers.forward.dqdd_dqd, formats.dqdd_dqd, forward.dqdd_dqd);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(answers.inverse.tau.of[i], inverse.tau[i].raw);
    EXPECT_EQ(answers.forward.qdd.of[i], forward.qdd[i].raw);
  }
  EXPECT_NE(forward.dqdd_dq(0, 1).raw, 0);
}

TEST(CDerivatives, InFixedPointRefuseWhatIsBeyondTheLimits) {
  const fixed_arm_joints p{{1 << 28, 0, 0}}, v{{0, INT32_MAX, 0}}, x{};
  fixed_arm_inverse_derivatives inverse{};
  inverse.tau.of[0] = 7;
  EXPECT_EQ(fixed_arm_inverse_dynamics_derivatives(&p, &v, &x, &inverse).code, AXIAL_SPEED_LIMIT);
  EXPECT_EQ(inverse.tau.of[0], 7);
  fixed_arm_forward_derivatives forward{};
  forward.qdd.of[0] = 8;
  EXPECT_EQ(fixed_arm_forward_dynamics_derivatives(&p, &v, &x, &forward).joint, 1);
  EXPECT_EQ(forward.qdd.of[0], 8);
  EXPECT_EQ(ask_derivative_formats(nullptr).code, AXIAL_NULL_ARGUMENT);
}

TEST(CDerivatives, RefuseWhatIsNotFiniteAndLeaveTheResult) {
  arm_joints bad = q;
  bad.of[1] = std::numeric_limits<float>::quiet_NaN();
  arm_inverse_derivatives inverse{};
  inverse.tau.of[0] = 7.0F;
  const axial_status status = arm_inverse_dynamics_derivatives(&q, &qd, &bad, &inverse);
  EXPECT_EQ(status.code, AXIAL_NOT_FINITE);
  EXPECT_EQ(status.joint, 1);
  EXPECT_EQ(inverse.tau.of[0], 7.0F);
  arm_forward_derivatives forward{};
  forward.qdd.of[0] = 8.0F;
  EXPECT_EQ(arm_forward_dynamics_derivatives(&q, &bad, &x, &forward).joint, 1);
  const axial_status refused = arm_forward_dynamics_derivatives(&q, &qd, &bad, &forward);
  EXPECT_EQ(refused.code, AXIAL_NOT_FINITE);
  EXPECT_EQ(refused.joint, 1) << "the effort that is no number, not the first answer";
  EXPECT_EQ(forward.qdd.of[0], 8.0F);
}

TEST(CDerivatives, RefuseNullPointers) {
  arm_inverse_derivatives inverse;
  EXPECT_EQ(arm_inverse_dynamics_derivatives(&q, &qd, nullptr, &inverse).code, AXIAL_NULL_ARGUMENT);
  EXPECT_EQ(arm_inverse_dynamics_derivatives(&q, &qd, &x, nullptr).code, AXIAL_NULL_ARGUMENT);
  EXPECT_EQ(arm_forward_dynamics_derivatives(&q, &qd, &x, nullptr).code, AXIAL_NULL_ARGUMENT);
}
