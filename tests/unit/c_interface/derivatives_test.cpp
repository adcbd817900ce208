// Derivatives in C have the bits that they have in C++, in float and double.
#include <axial/c_interface/derivatives.hpp>

#include <limits>

#include <gtest/gtest.h>

#include <robots/scara.hpp>

#include "c_side.h"

AXIAL_C_EXPORT_DERIVATIVES(arm, robots::Scara, float)
AXIAL_C_EXPORT(double_arm, robots::Scara, double)
AXIAL_C_EXPORT_DERIVATIVES(double_arm, robots::Scara, double)

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
  EXPECT_EQ(arm_forward_dynamics_derivatives(&q, &qd, &bad, &forward).code, AXIAL_NOT_FINITE);
  EXPECT_EQ(forward.qdd.of[0], 8.0F);
}

TEST(CDerivatives, RefuseNullPointers) {
  arm_inverse_derivatives inverse;
  EXPECT_EQ(arm_inverse_dynamics_derivatives(&q, &qd, nullptr, &inverse).code, AXIAL_NULL_ARGUMENT);
  EXPECT_EQ(arm_inverse_dynamics_derivatives(&q, &qd, &x, nullptr).code, AXIAL_NULL_ARGUMENT);
  EXPECT_EQ(arm_forward_dynamics_derivatives(&q, &qd, &x, nullptr).code, AXIAL_NULL_ARGUMENT);
}
