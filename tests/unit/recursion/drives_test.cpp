#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cmath>

using namespace axial;

namespace {

// Massless: the effort of a drive is what its friction and spring take.
struct Drives {
  static constexpr auto chain = axial::chain(
      revolute().viscous(0.5), revolute().coulomb(2.0, -1.0), revolute().coulomb(2.0, -1.0).stribeck(3.0, 0.25),
      revolute().coulomb(2.0, -1.0).smooth_speed(0.5),
      revolute().viscous(0.5).coulomb(2.0, -1.0).stribeck(3.0, 0.25).smooth_speed(0.5), revolute().spring(4.0, 0.75));
};
using Unrolled = Scene<Drives, Friction, JointSprings>;
using Compact = Scene<Drives, Friction, JointSprings, Looped>;
using J = Joints<Drives, double>;

template <class S = Unrolled>
J efforts(double speed, double position = 0.0) {
  J q{}, qd{};
  for (int i = 0; i < J::size; ++i)
    q[i] = position, qd[i] = speed;
  return bias_torque<S>(q, qd);
}

}  // namespace

TEST(Friction, IsZeroAtRest) {
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(efforts(0.0)[i], 0.0) << i;
    EXPECT_EQ(efforts<Compact>(0.0)[i], 0.0) << i;
  }
}

TEST(Friction, CoulombStepsWithTheSignOfTheSpeed) {
  EXPECT_EQ(efforts(1e-300)[1], 2.0);
  EXPECT_EQ(efforts(-1e-300)[1], -1.0);
  EXPECT_EQ(efforts(0.5)[0], 0.25);
}

TEST(Friction, StribeckFallsFromBreakawayToCoulomb) {
  EXPECT_NEAR(efforts(1e-12)[2], 3.0, 1e-12);
  EXPECT_NEAR(efforts(-1e-12)[2], -3.0, 1e-12);
  EXPECT_NEAR(efforts(0.25)[2], 2.5, 1e-15) << "half way at the Stribeck speed";
  EXPECT_NEAR(efforts(-0.25)[2], -2.0, 1e-15);
  EXPECT_NEAR(efforts(1e3)[2], 2.0, 1e-7);
}

TEST(Friction, SmoothSpeedTakesTheStepAway) {
  EXPECT_NEAR(efforts(1e-9)[3], 2.0 * 1.5 * 2e-9, 1e-20) << "slope 3/2 of the dry friction over the smooth speed";
  EXPECT_NEAR(efforts(0.25)[3], 2.0 * 0.6875, 1e-15);
  EXPECT_EQ(efforts(0.5)[3], 2.0);
  EXPECT_EQ(efforts(-0.5)[3], -1.0);
  EXPECT_EQ(efforts(40.0)[3], 2.0);
  for (double v = -0.6; v < 0.6; v += 0.001)
    for (int i : {3, 4})
      EXPECT_LT(std::fabs(efforts(v + 0.001)[i] - efforts(v)[i]), 0.025) << "continuous at " << v;
}

TEST(Friction, NotANumberStaysNone) {
  for (int i = 0; i < 5; ++i) {
    EXPECT_FALSE(is_finite(efforts(NAN)[i])) << i;
    EXPECT_FALSE(is_finite(efforts<Compact>(NAN)[i])) << i;
  }
}

TEST(Friction, LoopedEqualsUnrolled) {
  for (double v : {-3.0, -0.5, -0.1, -1e-9, 0.0, 1e-9, 0.2, 0.5, 7.0})
    for (int i = 0; i < J::size; ++i)
      EXPECT_NEAR(efforts<Compact>(v, 0.5)[i], efforts(v, 0.5)[i], 1e-15) << v << ' ' << i;
}

TEST(Spring, PullsTowardsItsRestPosition) {
  EXPECT_EQ(efforts(0.0, 1.0)[5], 1.0);
  EXPECT_EQ(efforts(0.0, 0.5)[5], -1.0);
  EXPECT_EQ(gravity_torque<Unrolled>(J{0, 0, 0, 0, 0, 1.0})[5], 1.0);
}

TEST(Drives, ABareRobotHasNone) {
  for (double v : {-1.0, 0.0, 1.0}) {
    J q{}, qd{};
    for (int i = 0; i < J::size; ++i)
      q[i] = qd[i] = v;
    for (int i = 0; i < J::size; ++i)
      EXPECT_EQ((bias_torque<Scene<Drives, Gravity>>(q, qd)[i]), 0.0);
  }
}

namespace {

struct Wheel {
  static constexpr auto chain =
      axial::chain(revolute().mass(1).inertia_com(1, 1, 0.5).viscous(3).coulomb(2).spring(4, 0.5));
};

template <class... Route>
void expect_drives_to_slow_the_wheel() {
  using S = Scene<Wheel, Friction, JointSprings, Route...>;
  using W = Joints<Wheel, double>;
  EXPECT_NEAR((forward_dynamics<S>(W{0.5}, W{2.0}, W{0.0})[0]), -(3 * 2.0 + 2) / 0.5, 1e-13);
  EXPECT_NEAR((forward_dynamics<S>(W{0.5}, W{-2.0}, W{0.0})[0]), (3 * 2.0 + 2) / 0.5, 1e-13);
  EXPECT_NEAR((forward_dynamics<S>(W{1.0}, W{0.0}, W{0.0})[0]), -4 * 0.5 / 0.5, 1e-13);
  EXPECT_NEAR((forward_dynamics<S>(W{1.0}, W{2.0}, W{3 * 2.0 + 2 + 4 * 0.5})[0]), 0.0, 1e-13);
}

}  // namespace

TEST(Drives, SlowAJointByEveryRouteOfForwardDynamics) {
  expect_drives_to_slow_the_wheel<ArticulatedBody>();
  expect_drives_to_slow_the_wheel<SplitArticulatedBody>();
  expect_drives_to_slow_the_wheel<CompositeBody>();
  expect_drives_to_slow_the_wheel<ArticulatedBody, Looped>();
}
