// Currents that windings stand: heat against its closed form, limits that fold back and never let it pass 1.
#include <gtest/gtest.h>
#include <algorithm>
#include <axial/axial.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <robots/scara.hpp>

using namespace axial;

namespace {

using Code = Status::Code;

struct Arm {
  static constexpr auto chain =
      axial::chain(gravity(0.0, 0.0, -10.0), revolute().mass(1).inertia_com(0.1, 0.1, 0.1).effort_limit(100),
                   prismatic().mass(1).effort_limit(1000));
};

/// 10 N m for ever and 30 N m at the peak; 50 N and 100 N.
constexpr DriveRating turning =
    DriveRating().continuous_current(2.0).peak_current(6.0).time_constant_s(4.0).torque_constant(0.0625, 100.0, 0.8);
constexpr DriveRating sliding = DriveRating()
                                    .continuous_current(1.0)
                                    .peak_current(2.0)
                                    .time_constant_s(2.0)
                                    .torque_constant(0.05, 1000.0)
                                    .fold_back(0.5);
constexpr double period = 1.0 / 1024.0;

template <class T>
class CurrentLimit : public testing::Test {
 protected:
  using J = Joints<Arm, T>;
  static constexpr CurrentLimits<Arm, T> limits = current_limits<Arm, T>({turning, sliding}, period);
  static_assert(limits.status.ok());
  static constexpr double eps = std::numeric_limits<T>::epsilon();

  WindingHeat<Arm, T> cold() const {
    WindingHeat<Arm, T> state;
    state.heat[0] = state.heat[1] = T(0);
    return state;
  }
};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(CurrentLimit, Numbers);

/// What heats a winding of continuous effort c, in long double, from what was let through.
struct Winding {
  long double c, time_constant, heat;
  void warm(long double effort) {
    const long double square = effort / c * (effort / c);
    heat = square + (heat - square) * std::exp(-static_cast<long double>(period) / time_constant);
  }
};

}  // namespace

TYPED_TEST(CurrentLimit, StartsAsIfHot) {
  WindingHeat<Arm, TypeParam> state;
  Joints<Arm, TypeParam> tau{TypeParam(-200), TypeParam(20)};
  const Status status = limit_currents(state, this->limits, tau);
  EXPECT_EQ(status.code, Code::current_limit);
  EXPECT_EQ(status.joint, 0);
  EXPECT_TRUE(status.met());
  EXPECT_NEAR(tau[0], -10.0, 10.0 * 10.0 * this->eps) << "the continuous effort";
  EXPECT_EQ(tau[1], TypeParam(20));
}

TYPED_TEST(CurrentLimit, ColdWindingsTakeThePeak) {
  auto state = this->cold();
  Joints<Arm, TypeParam> tau{TypeParam(29.99), TypeParam(-99.99)};
  EXPECT_TRUE(limit_currents(state, this->limits, tau).ok());
  EXPECT_EQ(tau[0], TypeParam(29.99));
  EXPECT_EQ(tau[1], TypeParam(-99.99));
  tau = {TypeParam(12), TypeParam(150)};
  const Status status = limit_currents(state, this->limits, tau);
  EXPECT_EQ(status.code, Code::current_limit);
  EXPECT_EQ(status.joint, 1);
  EXPECT_NEAR(tau[1], 100.0, 100.0 * 10.0 * this->eps);
  EXPECT_EQ(state.last[1], tau[1]);
}

// h(t) = (i/i_c)^2 (1 - exp(-t/time constant)), and back along exp(-t/time constant).
TYPED_TEST(CurrentLimit, HeatsAndCoolsAsTheClosedForm) {
  auto state = this->cold();
  const double tolerance = std::max(1e-12, 40.0 * this->eps);
  for (int n = 1; n <= 4096; ++n) {
    Joints<Arm, TypeParam> tau{TypeParam(9), TypeParam(-35)};
    EXPECT_TRUE(limit_currents(state, this->limits, tau).ok());
    const double t = n * period;
    ASSERT_NEAR(state.heat[0], 0.81 * -std::expm1(-t / 4.0), tolerance) << n;
    ASSERT_NEAR(state.heat[1], 0.49 * -std::expm1(-t / 2.0), tolerance) << n;
  }
  const double hot = 0.81 * -std::expm1(-1.0);
  for (int n = 1; n <= 4096; ++n) {
    Joints<Arm, TypeParam> tau{};
    EXPECT_TRUE(limit_currents(state, this->limits, tau).ok());
    ASSERT_NEAR(state.heat[0], hot * std::exp(-n * period / 4.0), tolerance) << n;
  }
}

// The peak is there until the heat is 0.8: t = -4 s ln(1 - 0.8/9).
TYPED_TEST(CurrentLimit, ThePeakLastsAsLongAsTheClosedFormSays) {
  auto state = this->cold();
  int calls = 0;
  for (Joints<Arm, TypeParam> tau{TypeParam(1000), TypeParam(0)};; ++calls, tau = {TypeParam(1000), TypeParam(0)}) {
    (void)limit_currents(state, this->limits, tau);
    if (tau[0] < TypeParam(29.999)) break;
  }
  EXPECT_NEAR(calls * period, -4.0 * std::log1p(-0.8 / 9.0), 3.0 * period);
}

TYPED_TEST(CurrentLimit, FallsInAStraightLineOfTheHeat) {
  for (const double h : {0.0, 0.5, 0.8, 0.85, 0.9, 0.95, 1.0, 1.2}) {
    const double room = std::clamp((1.0 - h) / 0.2, 0.0, 1.0);
    const auto allowed = allowed_effort(this->limits.joints[0], TypeParam(h));
    EXPECT_NEAR(allowed, 10.0 + 20.0 * room, 400.0 * this->eps) << h;
  }
}

// Any requests: the heat of what was let through, by a model of its own, never passes 1; limits and efforts never
// change faster than stated.
TYPED_TEST(CurrentLimit, TheHeatNeverPassesWhatTheWindingStands) {
  std::mt19937 engine(23);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double hottest = 0.0;
  for (int trial = 0; trial < 40; ++trial) {
    auto state = trial % 2 == 0 ? this->cold() : WindingHeat<Arm, TypeParam>{};
    const long double start = trial % 2 == 0 ? 0.0L : 1.0L;
    Winding windings[] = {{10.0L, 4.0L, start}, {50.0L, 2.0L, start}};
    Joints<Arm, TypeParam> request{};
    TypeParam allowed[] = {allowed_effort(this->limits.joints[0], state.heat[0]),
                           allowed_effort(this->limits.joints[1], state.heat[1])};
    int left = 0;
    for (int n = 0; n < 20000; ++n) {
      const bool changed = --left < 0;
      if (changed) {  // a duty cycle: on, off, back, in any lengths
        left = static_cast<int>(1.0 / (0.0003 + unit(engine) * unit(engine)));
        for (int i = 0; i < 2; ++i)
          request[i] = TypeParam((unit(engine) < 0.3 ? 0.0 : 400.0) * (unit(engine) - 0.5));
      }
      auto tau = request;
      const auto before = state.last;
      (void)limit_currents(state, this->limits, tau);
      for (int i = 0; i < 2; ++i) {
        windings[i].warm(tau[i]);
        ASSERT_LE(windings[i].heat, 1.0L) << trial << ", " << n;
        ASSERT_LE(state.heat[i], TypeParam(1));
        ASSERT_NEAR(state.heat[i], static_cast<double>(windings[i].heat), 60.0 * this->eps);
        hottest = std::max(hottest, static_cast<double>(state.heat[i]));
        const TypeParam now = allowed_effort(this->limits.joints[i], state.heat[i]);
        const double most = static_cast<double>(this->limits.joints[i].steepest_change) + 400.0 * this->eps;
        ASSERT_LE(std::fabs(static_cast<double>(now - allowed[i])), most);
        if (!changed) {
          ASSERT_LE(std::fabs(static_cast<double>(before[i] - tau[i])), most);
        }
        allowed[i] = now;
      }
    }
  }
  EXPECT_GT(hottest, 0.999) << "it gets there";
}

TYPED_TEST(CurrentLimit, TheStatedChangeIsReached) {
  auto state = this->cold();
  double steepest = 0.0;
  TypeParam last = allowed_effort(this->limits.joints[0], state.heat[0]);
  for (int n = 0; n < 4096; ++n) {
    Joints<Arm, TypeParam> tau{TypeParam(1000), TypeParam(0)};
    (void)limit_currents(state, this->limits, tau);
    const TypeParam now = allowed_effort(this->limits.joints[0], state.heat[0]);
    steepest = std::max(steepest, static_cast<double>(last - now)), last = now;
  }
  const double stated = this->limits.joints[0].steepest_change;
  EXPECT_NEAR(stated, 20.0 / 0.2 * -std::expm1(-period / 4.0) * (9.0 - 0.8), 1e-5);
  EXPECT_GT(steepest, 0.9 * stated);
}

TYPED_TEST(CurrentLimit, HoldsTheContinuousEffortForEver) {
  auto state = this->cold();
  Joints<Arm, TypeParam> tau{};
  for (int n = 0; n < 100000; ++n) {
    tau = {TypeParam(1000), TypeParam(-1000)};
    (void)limit_currents(state, this->limits, tau);
  }
  EXPECT_NEAR(tau[0], 10.0, 0.001);
  EXPECT_NEAR(tau[1], -50.0, 0.005);
  for (int n = 0; n < 1000; ++n) {
    tau = {TypeParam(9.99), TypeParam(49.99)};
    EXPECT_TRUE(limit_currents(state, this->limits, tau).ok());
  }
}

TYPED_TEST(CurrentLimit, WhatIsNoNumberLeavesTheLastEffortsAndTheHeatIsOneStill) {
  constexpr TypeParam infinity = std::numeric_limits<TypeParam>::infinity();
  auto state = this->cold();
  Joints<Arm, TypeParam> good{TypeParam(25), TypeParam(-20)};
  (void)limit_currents(state, this->limits, good);
  for (const TypeParam bad : {TypeParam(NAN), infinity, -infinity})
    for (int joint = 0; joint < 2; ++joint) {
      const auto before = state.heat[0];
      auto tau = good;
      tau[joint] = bad;
      const Status status = limit_currents(state, this->limits, tau);
      EXPECT_EQ(status.code, Code::not_finite);
      EXPECT_EQ(status.joint, joint);
      EXPECT_FALSE(status.met());
      EXPECT_EQ(tau[0], TypeParam(25));
      EXPECT_EQ(tau[1], TypeParam(-20));
      EXPECT_GT(state.heat[0], before) << "the drive still exerts it";
    }
  for (int n = 0; n < 4096; ++n) {
    Joints<Arm, TypeParam> tau{TypeParam(NAN), TypeParam(NAN)};
    EXPECT_EQ(limit_currents(state, this->limits, tau).joint, 0);
    ASSERT_LE(state.heat[0], TypeParam(1));
    good = tau;
  }
  EXPECT_LT(good[0], TypeParam(15)) << "and the last one is limited, too";
}

TYPED_TEST(CurrentLimit, WindingsOfMinutesWarmByLessThanARounding) {
  const auto slow = turning.time_constant_s(2000.0);
  const auto limits = current_limits<Arm, TypeParam>({slow, slow}, period);
  ASSERT_TRUE(limits.status.ok());
  auto state = this->cold();
  for (int n = 0; n < 1024 * 1000; ++n) {
    Joints<Arm, TypeParam> tau{TypeParam(8), TypeParam(0)};
    (void)limit_currents(state, limits, tau);
  }
  EXPECT_NEAR(state.heat[0], 0.64 * -std::expm1(-0.5), 1e-6);
}

TYPED_TEST(CurrentLimit, ARatingThatMeansNothingLetsNothingThrough) {
  const DriveRating bad[] = {DriveRating(),
                             turning.continuous_current(0.0),
                             turning.continuous_current(-2.0),
                             turning.continuous_current(NAN),
                             turning.continuous_current(INFINITY),
                             turning.peak_current(1.9),
                             turning.peak_current(NAN),
                             turning.peak_current(INFINITY),
                             turning.torque_constant(0.0),
                             turning.torque_constant(-0.1),
                             turning.torque_constant(NAN),
                             turning.time_constant_s(0.0),
                             turning.time_constant_s(NAN),
                             turning.time_constant_s(INFINITY),
                             turning.peak_time_s(1.0),
                             turning.time_constant_s(0.0).peak_current(2.0).peak_time_s(1.0),
                             turning.fold_back(1.0),
                             turning.fold_back(-0.1),
                             turning.fold_back(NAN),
                             turning.time_constant_s(0.01)};  // too fast for the period
  for (const DriveRating& rating : bad) {
    const auto limits = current_limits<Arm, TypeParam>({turning, rating}, period);
    EXPECT_EQ(limits.status.code, Code::input_limit) << &rating - bad;
    EXPECT_EQ(limits.status.joint, 1);
    auto state = this->cold();
    Joints<Arm, TypeParam> tau{TypeParam(5), TypeParam(5)};
    const Status status = limit_currents(state, limits, tau);
    EXPECT_EQ(status.code, Code::current_limit);
    EXPECT_EQ(status.joint, 1);
    EXPECT_EQ(tau[0], TypeParam(5));
    EXPECT_EQ(tau[1], TypeParam(0));
  }
  for (const double none : {0.0, -1.0, double(NAN)})
    EXPECT_EQ((current_limits<Arm, TypeParam>({turning, sliding}, none).status.joint), 0);
}

TYPED_TEST(CurrentLimit, ARatingWhosePeakIsHardlyAboveTheContinuousCurrentIsOne) {
  for (const double peak : {2.0, 2.01, 3.0, 3.99}) {
    const auto limits = current_limits<Arm, TypeParam>({turning, turning.peak_current(peak)}, period);
    EXPECT_TRUE(limits.status.ok()) << peak;
    EXPECT_NEAR(allowed_effort(limits.joints[1], TypeParam(0)), 5.0 * peak, 1e-4) << peak;
  }
}

TEST(CurrentLimitOf, APeakTimeIsWhatAColdWindingStands) {
  for (const double ratio : {1.01, 1.5, 3.0, 20.0}) {
    const auto rating = DriveRating()
                            .continuous_current(2.0)
                            .peak_current(2.0 * ratio)
                            .peak_time_s(3.0)
                            .torque_constant(1.0)
                            .fold_back(0.0);
    EXPECT_NEAR(rating.time_constant(), -3.0 / std::log1p(-1.0 / (ratio * ratio)), 1e-9 * rating.time_constant());
  }
}

TEST(CurrentLimitOf, DecaysAsTheExponential) {
  for (double y = 1e-9; y < 60.0; y *= 1.37)
    EXPECT_NEAR(detail::decayed(y), -std::expm1(-y), 1e-14 * -std::expm1(-y)) << y;
  EXPECT_EQ(detail::decayed(0.0), 0.0);
}

// Behind track(): one status after the other, one memory of what the drives exert.
TEST(CurrentLimitOf, ComposesWithTrack) {
  using Robot = robots::Scara;
  constexpr auto rating =
      DriveRating().continuous_current(1.0).peak_current(3.0).peak_time_s(2.0).torque_constant(0.05, 100.0);
  constexpr auto limits = current_limits<Robot, float>({rating, rating, rating}, 1e-3);
  static_assert(limits.status.ok());
  SafeLoopState<Robot, float> state{};
  WindingHeat<Robot, float> windings;
  state.output.step = {0.5F, 0.5F, 0.5F};
  Request<Robot, float> desired{{0.4F, 0.3F, 0.05F}, {}, {}, {}};
  MeasuredMotion<Robot, float> measured{{0.1F, 0.3F, 0.05F}, {}, {}};
  const TrackingGains<Robot, float> gains{{500, 500, 500}, {}};
  Efforts<Robot, float> before{};
  bool limited = false;
  for (int n = 0; n < 3000; ++n) {
    auto answer = track<Robot>(state, desired, measured, gains);
    ASSERT_TRUE(answer.status.met());
    const Status status = limit_currents(windings, limits, answer.tau);
    ASSERT_TRUE(status.met());
    limited = limited || status.code == Code::current_limit;
    state.output.last = answer.tau;
    for (int i = 0; i < 3; ++i) {
      const float most = std::max(0.5F, limits.joints[i].steepest_change) * 1.00001F;
      ASSERT_LE(std::fabs(answer.tau[i] - before[i]), most) << n;
    }
    before = answer.tau;
  }
  EXPECT_TRUE(limited);
  EXPECT_NEAR(before[0], 5.0F, 0.01F);
}
