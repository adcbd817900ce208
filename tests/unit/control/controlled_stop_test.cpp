// A controlled stop: from any speed to rest along the declared decelerations, inside the limits, then held; in float,
// double and fixed point. In the loop with a plant: tests/property/control/controlled_stop_test.cpp.
#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <cmath>
#include <random>

#include "arms.hpp"

using namespace axial;

namespace {

constexpr FallBackTimes times{5, 50, 100};
struct Stop {
  static constexpr double period = 1e-3;
};

template <class R_, class T_>
struct Case {
  using R = R_;
  using T = T_;
};
using Cases = control_tests::Arms<Case>;

template <class C>
class ControlledStop : public testing::Test {
 protected:
  using R = typename C::R;
  using T = typename C::T;
  using Real = Joints<R, double>;
  static constexpr int n = R::chain.size;
  static const LinkParameters& link(int i) { return R::chain.links[i]; }

  static Request<R, T> request(const Real& q, const Real& qd, const Real& qdd = {}) {
    if constexpr (is_stored_v<T>) {
      return to_fixed_request<R, std::int32_t>(q, qd, qdd);
    } else {
      Request<R, T> r;
      for (int i = 0; i < n; ++i)
        r.q[i] = static_cast<T>(q[i]), r.qd[i] = static_cast<T>(qd[i]), r.qdd[i] = static_cast<T>(qdd[i]);
      return r;
    }
  }
  template <class Values>
  static Real real(const Values& values) {
    if constexpr (is_stored_v<T>) {
      return to_real<double>(values);
    } else {
      Real out{};
      for (int i = 0; i < n; ++i)
        out[i] = static_cast<double>(values[i]);
      return out;
    }
  }
  /// The turn of an angle's word that is within the joint's range.
  static Real within(Real q) {
    for (int i = 0; i < n && is_stored_v<T>; ++i)
      if (link(i).type == JointType::revolute) {
        const double middle = 0.5 * (link(i).position_min + link(i).position_max);
        q[i] = middle + std::remainder(q[i] - middle, 6.283185307179586);
      }
    return q;
  }
  /// In a word every angle is within a range of a whole turn.
  static bool ends(int i) {
    return !is_stored_v<T> || link(i).type == JointType::prismatic ||
           link(i).position_max - link(i).position_min < 6.283185307179586;
  }
  /// A part of the range, of a joint's position.
  static Real position(double share) {
    Real q{};
    for (int i = 0; i < n; ++i)
      q[i] = link(i).position_min + share * (link(i).position_max - link(i).position_min);
    return q;
  }
  static Real speed(double share) {
    Real qd{};
    for (int i = 0; i < n; ++i)
      qd[i] = share * link(i).speed_limit;
    return qd;
  }
  static constexpr double tolerance = std::is_same_v<T, double> ? 1e-9 : 2e-5;

  /// Lets the patience pass and the arm brake; the number of ticks of braking.
  template <class Check>
  int brake(FallBack<R, T, Stop>& fall_back, const Check& check) {
    for (int k = 0; k < times.patience; ++k)
      fall_back.advance(1);
    int ticks = 0;
    while (fall_back.phase() == DrivePhase::fading && ticks < 5000) {
      check(within(real(fall_back.wanted().q)), real(fall_back.wanted().qd), real(fall_back.wanted().qdd));
      fall_back.advance(1);
      ++ticks;
    }
    EXPECT_EQ(fall_back.phase(), DrivePhase::holding);
    return ticks;
  }
};
TYPED_TEST_SUITE(ControlledStop, Cases);

}  // namespace

// v / a seconds, half the acceleration limit where nothing is declared, and v^2 / 2a of way.
TYPED_TEST(ControlledStop, TakesTheTimeAndTheWayOfTheDeclaredDeceleration) {
  using F = TestFixture;
  FallBack<typename F::R, typename F::T, Stop> fall_back(times);
  const auto q = F::position(0.3), qd = F::speed(0.4);
  ASSERT_TRUE(fall_back.follow(F::request(q, qd), {}));
  const int ticks = this->brake(fall_back, [](auto&&...) {});
  double longest = 0.0;
  const auto end = F::within(F::real(fall_back.wanted().q));
  for (int i = 0; i < F::n; ++i) {
    const double a = 0.5 * F::link(i).acceleration_limit, v = qd[i];
    longest = std::fmax(longest, v / a);
    EXPECT_NEAR(end[i], q[i] + v * times.patience * Stop::period + v * v / (2.0 * a), a * 1e-6 + F::tolerance) << i;
    EXPECT_EQ(F::real(fall_back.wanted().qd)[i], 0.0);
  }
  EXPECT_NEAR(ticks, longest / Stop::period, 1.01);
}

// While requests are young the motion goes on with its acceleration: q + v t + a t^2 / 2.
TYPED_TEST(ControlledStop, BeginsWhereTheMotionHasGot) {
  using F = TestFixture;
  FallBack<typename F::R, typename F::T, Stop> fall_back(times);
  auto q = F::position(0.4), qd = F::speed(-0.2), qdd = qd;
  for (int i = 0; i < F::n; ++i)
    qdd[i] = 0.5 * F::link(i).acceleration_limit;
  ASSERT_TRUE(fall_back.follow(F::request(q, qd, qdd), {}));
  for (int k = 0; k < times.patience - 1; ++k)
    fall_back.advance(1);
  const double t = (times.patience - 1) * Stop::period;
  for (int i = 0; i < F::n; ++i) {
    EXPECT_NEAR(F::real(fall_back.wanted().q)[i], q[i] + qd[i] * t + 0.5 * qdd[i] * t * t, F::tolerance);
    EXPECT_NEAR(F::real(fall_back.wanted().qd)[i], qd[i] + qdd[i] * t, F::tolerance);
  }
}

// Drawn motions, near the limits and up to full speed: never outside them, never braked harder than declared, and where
// the usual deceleration does within the limits, by that.
TYPED_TEST(ControlledStop, StaysInsideThePositionLimitsWhereTheSpeedAllows) {
  using F = TestFixture;
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int k = 0; k < 200; ++k) {
    typename F::Real q{}, qd{};
    for (int i = 0; i < F::n; ++i) {
      const auto& l = F::link(i);
      // As fast as the whole acceleration limit still brakes before the end, less what the patience takes.
      const double way = (l.position_max - l.position_min) * unit(engine), towards = unit(engine) < 0.5 ? -1.0 : 1.0;
      q[i] = towards > 0 ? l.position_max - way : l.position_min + way;
      const double a = l.acceleration_limit, late = a * times.patience * Stop::period;
      const double most = std::sqrt(late * late + 1.9 * a * way) - late;
      qd[i] = towards * std::fmin(most, l.speed_limit) * (k % 2 == 0 ? 1.0 : unit(engine));
    }
    FallBack<typename F::R, typename F::T, Stop> fall_back(times);
    ASSERT_TRUE(fall_back.follow(F::request(q, qd), {}));
    this->brake(fall_back, [&](const auto& at, const auto& v, const auto& a) {
      for (int i = 0; i < F::n; ++i) {
        const auto& l = F::link(i);
        if (!F::ends(i)) continue;
        ASSERT_GE(at[i], l.position_min - F::tolerance) << k << ' ' << i;
        ASSERT_LE(at[i], l.position_max + F::tolerance) << k << ' ' << i;
        ASSERT_LE(std::fabs(a[i]), l.acceleration_limit * (1.0 + F::tolerance) + F::tolerance);
        ASSERT_LE(v[i] * a[i], 0.0) << "it brakes";
        ASSERT_LE(v[i] * v[i],
                  2.02 * l.acceleration_limit * (v[i] > 0 ? l.position_max - at[i] : at[i] - l.position_min) + 1e-3)
            << "what is left of the way is enough";
      }
    });
  }
}

// Beyond that it brakes as hard as declared, and the arm is held at the limit.
TYPED_TEST(ControlledStop, WhoComesTooFastIsHeldAtTheLimit) {
  using F = TestFixture;
  FallBack<typename F::R, typename F::T, Stop> fall_back(times);
  ASSERT_TRUE(fall_back.follow(F::request(F::position(0.9999), F::speed(1.0)), {}));
  this->brake(fall_back, [](auto&&...) {});
  const auto end = F::within(F::real(fall_back.wanted().q)), limit = F::position(1.0);
  for (int i = 0; i < F::n; ++i)
    if (F::ends(i)) {
      EXPECT_NEAR(end[i], limit[i], F::tolerance * (1.0 + std::fabs(limit[i]))) << i;
    }
}

TYPED_TEST(ControlledStop, ExertsInverseDynamicsOfBrakingAndThenGravity) {
  using F = TestFixture;
  using R = typename F::R;
  FallBack<R, typename F::T, Stop> fall_back(times);
  ASSERT_TRUE(fall_back.follow(F::request(F::position(0.5), F::speed(0.5)), {}));
  for (int k = 0; k < times.patience + 10; ++k)
    fall_back.advance(1);
  const auto& at = fall_back.wanted();
  const auto braking = inverse_dynamics<R>(F::real(at.q), F::real(at.qd), F::real(at.qdd));
  const auto tau = F::real(fall_back.torque());
  for (int i = 0; i < F::n; ++i) {
    const double most = F::link(i).effort_limit;
    EXPECT_NEAR(tau[i], std::fmax(-most, std::fmin(braking[i], most)), 2e-6 * most + F::tolerance) << i;
  }
  fall_back.advance(3000);
  EXPECT_EQ(fall_back.phase(), DrivePhase::disabled);
  FallBack<R, typename F::T, Stop> held(times);
  ASSERT_TRUE(held.follow(F::request(F::position(0.5), F::speed(0.1)), {}));
  this->brake(held, [](auto&&...) {});
  const auto weight = gravity_torque<R>(F::real(held.wanted().q)), exerted = F::real(held.torque());
  for (int i = 0; i < F::n; ++i)
    EXPECT_NEAR(exerted[i], weight[i], 1e-6 * F::link(i).effort_limit + F::tolerance) << i;
  held.advance(times.hold - 1);
  EXPECT_TRUE(held.enabled());
  held.advance(1);
  EXPECT_FALSE(held.enabled());
}

namespace {

/// 1 kg at 1 m: braking by 50 rad/s^2 asks for 50 N m, of which there are 20.
struct Weak {
  static constexpr auto chain = axial::chain(
      revolute().mass(1).com(1, 0, 0).position_limits(-3, 3).speed_limit(10).acceleration_limit(100).effort_limit(20));
};

}  // namespace

TYPED_TEST(ControlledStop, NeverExertsMoreThanDeclared) {
  FallBack<Weak, double, Stop> fall_back(times);
  ASSERT_TRUE(fall_back.follow(Request<Weak, double>{{0.0}, {10.0}, {}, {}}, {}));
  fall_back.advance(times.patience);
  EXPECT_EQ(fall_back.phase(), DrivePhase::fading);
  EXPECT_EQ(fall_back.torque()[0], -20.0);
}

TYPED_TEST(ControlledStop, LateTicksAreCaughtUp) {
  using F = TestFixture;
  FallBack<typename F::R, typename F::T, Stop> late(times), punctual(times);
  const auto r = F::request(F::position(0.5), F::speed(0.3));
  ASSERT_TRUE(late.follow(r, {}));
  ASSERT_TRUE(punctual.follow(r, {}));
  for (int k = 0; k < 30; ++k)
    punctual.advance(1);
  late.advance(30);
  for (int i = 0; i < F::n; ++i) {
    EXPECT_EQ(F::real(late.wanted().q)[i], F::real(punctual.wanted().q)[i]);
    EXPECT_EQ(F::real(late.torque())[i], F::real(punctual.torque())[i]);
  }
}

TYPED_TEST(ControlledStop, AGoodRequestEndsIt) {
  using F = TestFixture;
  FallBack<typename F::R, typename F::T, Stop> fall_back(times);
  ASSERT_TRUE(fall_back.follow(F::request(F::position(0.5), F::speed(0.5)), {}));
  fall_back.advance(20);
  EXPECT_EQ(fall_back.phase(), DrivePhase::fading);
  const auto again = F::request(F::position(0.6), F::speed(0.0));
  ASSERT_TRUE(fall_back.follow(again, {}));
  EXPECT_EQ(fall_back.phase(), DrivePhase::running);
  EXPECT_EQ(F::real(fall_back.torque())[0], 0.0);
}

namespace {
struct Gentle {
  static constexpr double period = 1e-3, deceleration[3] = {2.0, 3.0, 1.0};
};
}  // namespace

TEST(DeclaredDeceleration, IsThatOfTheStop) {
  FallBack<robots::Scara, double, Gentle> fall_back(times);
  const Request<robots::Scara, double> r{{0.0, 0.0, 0.05}, {1.0, -1.0, 0.01}, {}, {}};
  ASSERT_TRUE(fall_back.follow(r, {}));
  fall_back.advance(20);
  EXPECT_NEAR(fall_back.wanted().qdd[0], -2.0, 1e-9);
  EXPECT_NEAR(fall_back.wanted().qdd[1], 3.0, 1e-9);
}
