// Errors relative to each joint's largest torque, by hand.
#include <host_sim/figures/compare/joint_errors.hpp>
#include <oracle/scalar.hpp>

#include <gtest/gtest.h>

#include <limits>

using compare::JointErrors;

TEST(JointErrors, AreRelativeToEachJointsLargestTorque) {
  JointErrors errors(2);
  errors.add(0, 2.5, 2.0), errors.add(1, 10.0, 10.0);   // 0.5 of what becomes 4
  errors.add(0, -3.5, -4.0), errors.add(1, 1.0, -1.0);  // 0.5 again, 2 of 10
  errors.add(0, 1.0, 1.0), errors.add(1, 0.0, 0.0);     // later and smaller
  EXPECT_DOUBLE_EQ(errors.worst(), 0.2);
  const double squares = 2 * 0.125 * 0.125 + 0.2 * 0.2;
  EXPECT_DOUBLE_EQ(errors.rms(), std::sqrt(squares / 6.0)) << "of three states and two joints";
}
TEST(JointErrors, AJointWithoutTorqueHasNone) {
  JointErrors errors(2);
  errors.add(0, 1.5, 1.0), errors.add(1, 0.25, 0.0);
  EXPECT_DOUBLE_EQ(errors.worst(), 0.5);
  EXPECT_DOUBLE_EQ(errors.rms(), std::sqrt(0.25 / 2.0));
}
TEST(JointErrors, WhatIsNoNumberIsNoSmallError) {
  for (const bool of_the_value : {true, false}) {
    JointErrors errors(2);
    const double none = std::numeric_limits<double>::quiet_NaN();
    errors.add(0, of_the_value ? none : 1.0, of_the_value ? 1.0 : none), errors.add(1, 1.0, 1.0);
    errors.add(0, 1.0, 1.0), errors.add(1, 1.0, 1.0);
    EXPECT_FALSE(errors.worst() <= 1e9) << of_the_value;
    EXPECT_FALSE(errors.rms() <= 1e9) << of_the_value;
  }
}
TEST(JointErrors, OfFinerNumbersAreNotThoseOfDouble) {
  JointErrors errors(1);
  const oracle::quad one = 1.0;
  errors.add(0, one + oracle::quad(0x1p-80), one);
  EXPECT_EQ(errors.worst(), 0x1p-80);
}
