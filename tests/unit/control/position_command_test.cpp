// Positions told to drives that take no torque: what they exert, what is limited, what is refused.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace axial;

namespace {

using Code = Status::Code;

/// A pendulum that lifts, and a slide.
struct Arm {
  static constexpr auto chain =
      axial::chain(gravity(0.0, -10.0, 0.0),
                   revolute().mass(2).com(0.5, 0, 0).inertia_com(0, 0.1, 0.1).position_limits(-1.0, 2.0).viscous(0.5),
                   prismatic().mass(1).alpha_deg(90).position_limits(0.5, 0.75));
};

template <class T>
class PositionCommandOf : public testing::Test {
 protected:
  using J = Joints<Arm, T>;
  const J middle{T(0.5), T(0.625)};
  PositionLoop<Arm, T> loop{{T(40), T(2000)}};
  PositionCommandState<Arm, T> state{{T(0.25), T(0.5625)}};

  void expect_refused(const J& q, const J& tau, Code code, int joint) {
    const auto before = state.last;
    const auto answer = position_command<Arm>(state, loop, q, tau);
    EXPECT_EQ(answer.status.code, code);
    EXPECT_EQ(answer.status.joint, joint);
    EXPECT_FALSE(answer.status.met());
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(answer.q[i], before[i]);
      EXPECT_EQ(state.last[i], before[i]);
    }
  }
  void expect_limited(const J& tau, int joint, T command) {
    const auto answer = position_command<Arm>(state, loop, middle, tau);
    EXPECT_EQ(answer.status.code, Code::command_limit);
    EXPECT_EQ(answer.status.joint, joint);
    EXPECT_TRUE(answer.status.met());
    EXPECT_EQ(answer.q[joint], command);
    EXPECT_EQ(state.last[joint], command);
  }
};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(PositionCommandOf, Numbers);

}  // namespace

TYPED_TEST(PositionCommandOf, IsAheadByTheEffortOverTheStiffness) {
  const Joints<Arm, TypeParam> tau{TypeParam(10), TypeParam(-125)};
  const auto answer = position_command<Arm>(this->state, this->loop, this->middle, tau);
  EXPECT_TRUE(answer.status.ok());
  EXPECT_EQ(answer.q[0], TypeParam(0.75));
  EXPECT_EQ(answer.q[1], TypeParam(0.5625));
  EXPECT_EQ(this->state.last[0], answer.q[0]);
}

TYPED_TEST(PositionCommandOf, IsLimitedToTheRangeOfTheJoint) {
  this->expect_limited({TypeParam(70), TypeParam(0)}, 0, TypeParam(2.0));
  this->expect_limited({TypeParam(-70), TypeParam(0)}, 0, TypeParam(-1.0));
  this->expect_limited({TypeParam(0), TypeParam(260)}, 1, TypeParam(0.75));
  this->expect_limited({TypeParam(0), TypeParam(-260)}, 1, TypeParam(0.5));
}

TYPED_TEST(PositionCommandOf, IsLimitedToTheLargestOffset) {
  this->loop.largest_offset = {TypeParam(0.25), TypeParam(0.0625)};
  this->expect_limited({TypeParam(11), TypeParam(0)}, 0, TypeParam(0.75));
  this->expect_limited({TypeParam(-11), TypeParam(0)}, 0, TypeParam(0.25));
  this->expect_limited({TypeParam(0), TypeParam(200)}, 1, TypeParam(0.6875));
  const auto at = position_command<Arm>(this->state, this->loop, this->middle, {TypeParam(10), TypeParam(-125)});
  EXPECT_TRUE(at.status.ok()) << "the largest offset itself is none too many";
}

TYPED_TEST(PositionCommandOf, NamesTheFirstJointThatIsLimited) {
  this->expect_limited({TypeParam(70), TypeParam(260)}, 0, TypeParam(2.0));
}

TYPED_TEST(PositionCommandOf, AnEffortThatOverflowsTheQuotientIsLimitedToo) {
  this->loop.stiffness[1] = std::numeric_limits<TypeParam>::min();
  this->expect_limited({TypeParam(0), TypeParam(100)}, 1, TypeParam(0.75));
  this->expect_limited({TypeParam(0), TypeParam(-100)}, 1, TypeParam(0.5));
}

TYPED_TEST(PositionCommandOf, ADriveThatDoesNotSagIsToldTheDesiredPosition) {
  this->loop.stiffness = {std::numeric_limits<TypeParam>::infinity(), std::numeric_limits<TypeParam>::infinity()};
  const auto answer = position_command<Arm>(this->state, this->loop, this->middle, {TypeParam(70), TypeParam(-260)});
  EXPECT_TRUE(answer.status.ok());
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(answer.q[i], this->middle[i]);
}

TYPED_TEST(PositionCommandOf, WhatIsNoPositionIsRefused) {
  constexpr TypeParam infinity = std::numeric_limits<TypeParam>::infinity();
  for (const TypeParam bad : {TypeParam(NAN), infinity, -infinity}) {
    this->expect_refused({bad, TypeParam(0.6)}, {}, Code::not_finite, 0);
    this->expect_refused({TypeParam(0), bad}, {}, Code::not_finite, 1);
    this->expect_refused(this->middle, {bad, TypeParam(0)}, Code::not_finite, 0);
    this->expect_refused(this->middle, {TypeParam(0), bad}, Code::not_finite, 1);
  }
  this->expect_refused({TypeParam(2.001), TypeParam(0.6)}, {}, Code::position_limit, 0);
  this->expect_refused({TypeParam(0), TypeParam(0.49)}, {}, Code::position_limit, 1);
}

TYPED_TEST(PositionCommandOf, AStiffnessOrAnOffsetThatMeansNothingIsRefused) {
  for (const TypeParam bad : {TypeParam(NAN), TypeParam(0), TypeParam(-1)}) {
    this->loop.stiffness[1] = bad;
    this->expect_refused(this->middle, {}, Code::input_limit, 1);
  }
  this->loop.stiffness[1] = TypeParam(1);
  for (const TypeParam bad : {TypeParam(NAN), TypeParam(-1)}) {
    this->loop.largest_offset[0] = bad;
    this->expect_refused(this->middle, {}, Code::input_limit, 0);
  }
}

TYPED_TEST(PositionCommandOf, AfterARefusalTheDrivesStayWhereTheyWereTold) {
  const auto told = position_command<Arm>(this->state, this->loop, this->middle, {TypeParam(1), TypeParam(2)}).q;
  this->expect_refused({TypeParam(NAN), TypeParam(0.6)}, {}, Code::not_finite, 0);
  EXPECT_EQ(this->state.last[0], told[0]);
  EXPECT_EQ(this->state.last[1], told[1]);
}

// The documented cost of a wrong stiffness: tau (1/k - 1/k') of the drive's own stiffness k'.
TEST(PositionCommandTo, AWrongStiffnessCostsWhatItSays) {
  using S = Scene<Arm, Gravity, RotorInertia, Friction>;
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> share(0.5, 2.0);
  for (int trial = 0; trial < 100; ++trial) {
    const Joints<Arm, double> q{share(engine) - 1.0, 0.6}, qd{0.1, 0.0}, qdd{share(engine), 0.0};
    const auto tau = inverse_dynamics<S>(q, qd, qdd);
    const PositionLoop<S, double> assumed{{150.0 * share(engine), 4000.0}};
    const double own = 150.0;
    PositionCommandState<S, double> state{q};
    const auto answer = position_command<S>(state, assumed, q, tau);
    ASSERT_TRUE(answer.status.ok());
    const double held = answer.q[0] - tau[0] / own;  // where the drive exerts tau
    EXPECT_NEAR(held - q[0], tau[0] * (1.0 / assumed.stiffness[0] - 1.0 / own), 1e-14);
    EXPECT_NEAR((held - q[0]) / (tau[0] / own), own / assumed.stiffness[0] - 1.0, 1e-12);
  }
}

// A damped servo against a pendulum, integrated: it follows without sagging where the command carries the damping too.
TEST(PositionCommandTo, ADampedServoFollowsWhereItsDampingIsAdded) {
  const double k = 60.0, d = 2.0, step = 1e-5;
  for (const bool told : {true, false}) {
    double q = 0.2, qd = 0.0, largest = 0.0;
    PositionCommandState<Arm, double> state{{0.2, 0.6}};
    for (int n = 0; n < 100000; ++n) {
      const double t = n * step;
      const Joints<Arm, double> to{0.2 + 0.3 * (1.0 - std::cos(2.0 * t)), 0.6}, speed{0.6 * std::sin(2.0 * t), 0.0},
          acceleration{1.2 * std::cos(2.0 * t), 0.0};
      auto tau = inverse_dynamics<Arm>(to, speed, acceleration);
      tau[0] += d * speed[0];
      if (!told) tau = {};
      const auto answer = position_command<Arm>(state, {{k, 4000.0}}, to, tau);
      const Joints<Arm, double> efforts{k * (answer.q[0] - q) - d * qd, 0.0};
      // The slide is held: its weight acts at the pendulum, too.
      const auto bias = bias_torque<Arm>(Joints<Arm, double>{q, 0.6}, Joints<Arm, double>{qd, 0.0});
      const auto inertia = mass_matrix<Arm>(Joints<Arm, double>{q, 0.6});
      qd += step * (efforts[0] - bias[0]) / inertia(0, 0), q += step * qd;
      largest = std::fmax(largest, std::fabs(q - to[0]));
    }
    if (told)
      EXPECT_LT(largest, 0.002);
    else
      EXPECT_GT(largest, 0.1);
  }
}

TEST(PositionCommandTo, IsAConstantExpression) {
  constexpr double command = [] {
    PositionCommandState<Arm, double> state{};
    return position_command<Arm>(state, {{40.0, 2000.0}}, Joints<Arm, double>{0.5, 0.625},
                                 Joints<Arm, double>{10.0, 0.0})
        .q[0];
  }();
  EXPECT_EQ(command, 0.75);
}
