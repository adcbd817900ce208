// Joints that are held, in words: dry friction that sticks and end stops that do not yield. Closed forms, momentum, and
// the same method in double.
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/sticking.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <robots/puma560.hpp>
#include <robots/wrist_arm.hpp>

namespace {

using namespace axial;

/// A step of 1 ms of drives that are not stiff.
template <int joints>
struct Soft {
  static constexpr double step = 1e-3;
  static constexpr double stiffness[joints] = {}, damping[joints] = {};
};
template <class S>
using Method = StickingFor<Soft<joint_count<S>>>;
template <class S>
using Words = Motion<S, Fixed32>;
template <class S>
using Numbers = Joints<robot_of<S>, double>;

template <class S>
Held<S, Fixed32> pulled(const Numbers<S>& tau) {
  const auto kept = to_fixed<EffortsOf<S, Fixed32>>(tau);
  EXPECT_TRUE(kept.status.ok());
  return {kept.values, {}};
}
template <class S>
Words<S> at(const Numbers<S>& q, const Numbers<S>& qd = {}) {
  Words<S> x;
  x.q = to_fixed<Positions<robot_of<S>, Fixed32>>(q).values;
  x.qd = to_fixed<Velocities<robot_of<S>, Fixed32>>(qd).values;
  return x;
}
template <class S>
bool move(Words<S>& x, const Held<S, Fixed32>& held, int steps) {
  bool ok = true;
  for (int k = 0; k < steps; ++k)
    ok = advance<Method<S>>(x, held).ok() && ok;
  return ok;
}
template <class S>
Status stopped_step(Words<S>& x, const Held<S, Fixed32>& held) {
  return advance<Method<S>>(x, WithEndStops<S, Fixed32, Held<S, Fixed32>>(held, {}));
}
template <class S>
bool move_between_stops(Words<S>& x, const Held<S, Fixed32>& held, int steps) {
  bool ok = true;
  for (int k = 0; k < steps; ++k)
    ok = stopped_step(x, held).ok() && ok;
  return ok;
}
template <class Values>
double value(const Values& values, int i) {
  return to_real<double>(values)[i];
}
template <class X>
bool rests(const X& x, const X& where) {
  bool same = true;
  for (int i = 0; i < X::joints; ++i)
    same = same && x.q[i] == where.q[i] && x.q_rest[i] == where.q_rest[i] && x.qd[i].raw == 0 && x.qd_rest[i] == 0;
  return same;
}

/// A block on a track.
struct Block {
  static constexpr auto chain = axial::chain(gravity(0.0, 0.0, 0.0), prismatic()
                                                                         .mass(2.0)
                                                                         .coulomb(5.0, -4.0)
                                                                         .position_limits(-0.5, 0.5)
                                                                         .speed_limit(4.0)
                                                                         .acceleration_limit(10.0)
                                                                         .effort_limit(20.0));
};
using OnTrack = Scene<Block, Friction>;
using Sliding = Scene<Block>;

constexpr double rod = 0.4, bob = 1.5;
/// A pendulum on the end of an arm whose joint is stiff with rust, and the pendulum alone.
struct Rusty {
  static constexpr auto chain = axial::chain(gravity(0.0, -9.81, 0.0),
                                             revolute()
                                                 .mass(3.0)
                                                 .com(0.3, 0, 0)
                                                 .inertia_com(0.1, 0.1, 0.1)
                                                 .coulomb(200.0)
                                                 .speed_limit(10.0)
                                                 .acceleration_limit(100.0)
                                                 .effort_limit(300.0),
                                             revolute()
                                                 .a(0.6)
                                                 .mass(bob)
                                                 .com(rod, 0, 0)
                                                 .inertia_com(0.01, 0.01, 0.01)
                                                 .coulomb(0.02)
                                                 .speed_limit(10.0)
                                                 .acceleration_limit(100.0)
                                                 .effort_limit(20.0));
};
struct Alone {
  static constexpr auto chain = axial::chain(gravity(0.0, -9.81, 0.0), revolute()
                                                                           .mass(bob)
                                                                           .com(rod, 0, 0)
                                                                           .inertia_com(0.01, 0.01, 0.01)
                                                                           .coulomb(0.02)
                                                                           .speed_limit(10.0)
                                                                           .acceleration_limit(100.0)
                                                                           .effort_limit(20.0));
};

constexpr double upper = 1.2, hand = 0.5, wheel = 0.3;
/// Two wheels, the second on the rim of the first, between stops.
struct Wheels {
  static constexpr auto chain = axial::chain(
      gravity(0.0, 0.0, 0.0),
      revolute().mass(1.0).inertia_com(0.6, 0.6, upper).speed_limit(8.0).acceleration_limit(50.0).effort_limit(20.0),
      revolute()
          .a(wheel)
          .mass(2.0)
          .com(0.2, 0.0, 0.0)
          .inertia_com(0.3, 0.3, hand)
          .position_limits(-0.5, 0.7)
          .speed_limit(8.0)
          .acceleration_limit(50.0)
          .effort_limit(20.0));
};
using TwoWheels = Scene<Wheels>;
/// Momentum of the wheels about the first axis, by hand: the second's centre is 0.2 m off its axis.
double spin_of(double q2, double w1, double w2) {
  const double c = 0.2 * std::cos(q2), s = 0.2 * std::sin(q2), spin = w1 + w2;
  const double x = wheel + c, y = s, vx = -w2 * s - w1 * y, vy = w1 * x + w2 * c;
  return upper * w1 + hand * spin + 2.0 * (x * vy - y * vx);
}

}  // namespace

TEST(HeldWords, HoldABlockForAMinuteToTheLastBit) {
  auto x = at<OnTrack>({0.123456789});
  const auto before = x;
  ASSERT_TRUE(move(x, pulled<OnTrack>({4.99}), 60'000));
  EXPECT_TRUE(rests(x, before));
  ASSERT_TRUE(move(x, pulled<OnTrack>({-3.99}), 1000));
  EXPECT_TRUE(rests(x, before));
  ASSERT_TRUE(move(x, pulled<OnTrack>({-4.2}), 1000));
  EXPECT_NEAR(value(x.q, 0), 0.123456789 - 0.5 * (0.2 / 2.0), 1e-4);
}

// A block that was thrown is slowed by a = C / m and stops where v^2 / 2 a says, for good.
TEST(HeldWords, StopABlockThatWasThrown) {
  for (const double speed : {1.0, -0.7}) {
    auto x = at<OnTrack>({0.0}, {speed});
    ASSERT_TRUE(move(x, {}, 2000));
    const double slows = speed > 0.0 ? 2.5 : -2.0;
    EXPECT_EQ(x.qd[0].raw, 0);
    EXPECT_NEAR(value(x.q, 0), speed * speed / (2.0 * slows), 1e-3 * std::fabs(speed)) << speed;
    const auto there = x;
    ASSERT_TRUE(move(x, {}, 1000));
    EXPECT_TRUE(rests(x, there));
  }
}

TEST(HeldWords, LockAJointForTheOthers) {
  using S = Scene<Rusty, Gravity, Friction>;
  using Free = Scene<Alone, Gravity, Friction>;
  auto x = at<S>({0.0, -0.8});
  auto y = at<Free>({-0.8});
  for (int k = 0; k < 2000; ++k) {
    ASSERT_TRUE(advance<Method<S>>(x, Held<S, Fixed32>{}).ok());
    ASSERT_TRUE(advance<Method<Free>>(y, Held<Free, Fixed32>{}).ok());
    ASSERT_NEAR(value(x.q, 1), value(y.q, 0), 1e-6);
  }
  EXPECT_EQ(x.q[0].raw, 0);
  EXPECT_GT(std::fabs(value(x.q, 1) + 0.8), 0.01);
}

TEST(HeldWords, EndASwingWithinTheDeadBand) {
  using Free = Scene<Alone, Gravity, Friction>;
  auto x = at<Free>({0.0});
  ASSERT_TRUE(move(x, {}, 200'000));
  EXPECT_EQ(x.qd[0].raw, 0);
  EXPECT_LE(std::fabs(bob * 9.81 * rod * std::cos(value(x.q, 0))), 0.021);
}

namespace {
using Puma = Scene<robots::Puma560, Gravity, RotorInertia, Friction>;
constexpr double pose[] = {0.3, -0.7, 1.9, 0.2, 0.4, -0.5};
}  // namespace

// Beside the torques that hold its weight an arm is pulled by nine tenths of what its joints' friction is.
TEST(HeldWords, HoldAnArmForTenSecondsToTheLastBit) {
  Numbers<Puma> q;
  for (int i = 0; i < 6; ++i)
    q[i] = pose[i];
  auto tau =
      gravity_torque<Puma>(Positions<robots::Puma560, double>{pose[0], pose[1], pose[2], pose[3], pose[4], pose[5]});
  Numbers<Puma> pull;
  for (int i = 0; i < 6; ++i) {
    const auto& link = robots::Puma560::chain.links[i];
    pull[i] = tau[i] + 0.9 * (i % 2 == 0 ? link.coulomb_forward : link.coulomb_backward);
  }
  auto x = at<Puma>(q);
  const auto before = x;
  ASSERT_TRUE(move(x, pulled<Puma>(pull), 10'000));
  EXPECT_TRUE(rests(x, before));
  // A third more and the elbow gives way, forwards; what it does to the shoulder moves that, but not the base.
  pull[2] += 0.3 * robots::Puma560::chain.links[2].coulomb_forward;
  ASSERT_TRUE(move(x, pulled<Puma>(pull), 20));
  EXPECT_GT(x.qd[2].raw, 0);
  EXPECT_TRUE(x.q[0] == before.q[0]);
}

// Let go and pulled about, an arm goes the way that StickingEuler takes in double.
TEST(HeldWords, GoTheWayOfDouble) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  for (int run = 0; run < 12; ++run) {
    Numbers<Puma> q, pull;
    for (int i = 0; i < 6; ++i)
      q[i] = pose[i] + 0.3 * draw(generator),
      pull[i] = 0.2 * robots::Puma560::chain.links[i].effort_limit * draw(generator);
    auto x = at<Puma>(q);
    const auto held = pulled<Puma>(pull);
    Motion<Puma, double> y;
    Held<Puma, double> same;
    for (int i = 0; i < 6; ++i)
      y.q[i] = value(x.q, i), same.tau[i] = value(held.tau, i);
    for (int k = 0; k < 150; ++k) {
      const Status status = advance<Method<Puma>>(x, held);
      ASSERT_TRUE(status.ok()) << run << ' ' << k << ' ' << static_cast<int>(status.code) << ' ' << status.joint;
      ASSERT_TRUE(advance<StickingEuler>(y, 1e-3, same).ok());
    }
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(value(x.q, i), y.q[i], 2e-5) << run << ' ' << i;
  }
}

// --- stops

TEST(HeldWords, ArriveAtAStopAndRest) {
  for (const double speed : {3.0, -3.0, 0.01})
    for (int start = 0; start < 16; ++start) {  // sixteenths of a step before the stop
      auto x = at<Sliding>({std::copysign(0.49, speed) - speed * 1e-3 * start / 16.0}, {speed});
      double fastest = 0.0;
      for (int k = 0; k < 2000; ++k) {
        ASSERT_TRUE(stopped_step(x, Held<Sliding, Fixed32>{}).ok());
        ASSERT_LE(std::fabs(value(x.q, 0)), 0.5 + 1e-9);
        fastest = std::max(fastest, std::fabs(value(x.qd, 0)));
      }
      EXPECT_LE(fastest, std::fabs(speed) * (1.0 + 1e-6));
      EXPECT_NEAR(value(x.q, 0), std::copysign(0.5, speed), 1e-8);
      const auto there = x;
      ASSERT_TRUE(move_between_stops(x, pulled<Sliding>({std::copysign(20.0, speed)}), 10'000));
      EXPECT_TRUE(rests(x, there)) << "pressed against it";
    }
}

// A stop does not hold what leaves it: x = a t^2 / 2 from there on.
TEST(HeldWords, LeaveAStopAsIfThereWereNone) {
  for (const double side : {1.0, -1.0}) {
    auto x = at<Sliding>({side * 0.49}, {side});
    ASSERT_TRUE(move_between_stops(x, pulled<Sliding>({side * 5.0}), 100));
    ASSERT_NEAR(value(x.q, 0), side * 0.5, 1e-8);
    ASSERT_TRUE(move_between_stops(x, pulled<Sliding>({-side * 4.0}), 300));
    EXPECT_NEAR(value(x.q, 0), side * (0.5 - 0.5 * 2.0 * 0.3 * (0.3 + 1e-3)), 1e-7) << "semi-implicit";
    EXPECT_NEAR(value(x.qd, 0), -side * 0.6, 1e-7);
  }
}
// Friction holds at a stop, too: the stop pushes back what is more, and is not needed for less.
TEST(HeldWords, StickAtAStop) {
  auto x = at<OnTrack>({0.49}, {2.0});
  ASSERT_TRUE(move_between_stops(x, {}, 100));
  const auto there = x;
  for (const double effort : {0.0, 12.0, -3.9, 4.0, -3.9}) {
    ASSERT_TRUE(move_between_stops(x, pulled<OnTrack>({effort}), 1000));
    EXPECT_TRUE(rests(x, there)) << effort;
  }
  ASSERT_TRUE(move_between_stops(x, pulled<OnTrack>({-6.0}), 200));
  EXPECT_NEAR(value(x.q, 0), 0.5 - 0.5 * 1.0 * 0.2 * 0.201, 1e-6);
}

// What a joint loses to a stop the rest of the robot keeps: momentum about the first axis, which nothing drives.
TEST(HeldWords, KeepMomentumWhenAStopIsHit) {
  for (const double speed : {4.0, -4.0}) {
    auto x = at<TwoWheels>({0.2, speed > 0.0 ? 0.69 : -0.49}, {-0.5 * speed, speed});
    const double before = spin_of(value(x.q, 1), value(x.qd, 0), value(x.qd, 1));
    ASSERT_TRUE(move_between_stops(x, {}, 5));
    EXPECT_NEAR(value(x.qd, 1), 0.0, 0.01) << "but for what the first one's turning makes of it";
    EXPECT_NEAR(value(x.q, 1), speed > 0.0 ? 0.7 : -0.5, 1e-4);
    EXPECT_NEAR(spin_of(value(x.q, 1), value(x.qd, 0), value(x.qd, 1)), before, 2e-3) << "first order";
  }
}
// Pressed against its stop it is a part of the first: one inertia, by hand.
TEST(HeldWords, TurnAsOneBodyWithAJointAtItsStop) {
  auto x = at<TwoWheels>({0.0, 0.7});
  const double whole = spin_of(0.7, 1.0, 0.0), effort = -6.0;  // which throws the second against its stop
  ASSERT_TRUE(move_between_stops(x, pulled<TwoWheels>({effort, 0.0}), 400));
  EXPECT_NEAR(value(x.qd, 0), effort / whole * 0.4, 1e-6);
  EXPECT_NEAR(value(x.q, 1), 0.7, 1e-8);
  EXPECT_EQ(x.qd[1].raw, 0);
  ASSERT_TRUE(move_between_stops(x, pulled<TwoWheels>({-effort, 0.0}), 100));
  EXPECT_LT(value(x.q, 1), 0.69) << "braked, it leaves the stop";
}

namespace {

/// Both joints of the wheels end, and rub.
struct Worn {
  static constexpr auto chain = axial::chain(gravity(0.0, -9.81, 0.0),
                                             revolute()
                                                 .mass(1.0)
                                                 .com(0.1, 0.0, 0.0)
                                                 .inertia_com(0.06, 0.06, 0.1)
                                                 .coulomb(2.0, -3.0)
                                                 .position_limits(-0.4, 0.4)
                                                 .speed_limit(8.0)
                                                 .acceleration_limit(50.0)
                                                 .effort_limit(20.0),
                                             revolute()
                                                 .a(wheel)
                                                 .mass(2.0)
                                                 .com(0.2, 0.0, 0.0)
                                                 .inertia_com(0.03, 0.03, 0.05)
                                                 .coulomb(1.0)
                                                 .position_limits(-0.5, 0.7)
                                                 .speed_limit(8.0)
                                                 .acceleration_limit(50.0)
                                                 .effort_limit(20.0));
};
using Rubbing = Scene<Worn, Gravity, Friction>;

/// Whether what holds joint i in a step from x to y may: `pull` is what is left of its efforts but for dry friction.
bool is_held_rightly(int i, double pull, const Words<Rubbing>& x, const Words<Rubbing>& y) {
  const auto& link = Worn::chain.links[i];
  const double ways = value(x.qd, i), v = value(y.qd, i), near = 1e-7, slight = 2e-3;
  const bool high = value(y.q, i) > link.position_max - near, low = value(y.q, i) < link.position_min + near;
  const double most = y.qd[i].raw == 0 || ways > 0.0 || v > 0.0 ? link.coulomb_forward : link.coulomb_backward;
  const double least = y.qd[i].raw == 0 || ways < 0.0 || v < 0.0 ? link.coulomb_backward : link.coulomb_forward;
  return pull > (low ? -1e9 : least - slight) && pull < (high ? 1e9 : most + slight);
}

}  // namespace

// From first principles: what is left of tau - bias - M a is dry friction, of no more than it has and against the way,
// or a stop that only pushes.
TEST(HeldWords, HoldByNoMoreThanFrictionAndStopsHave) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  using Frictionless = Scene<Worn, Gravity>;
  int held = 0, stopped = 0, wrong = 0;
  constexpr int states = 4000;
  for (int k = 0; k < states; ++k) {
    Numbers<Rubbing> q, qd, tau;
    for (int i = 0; i < 2; ++i) {
      const auto& link = Worn::chain.links[i];
      const double ends[] = {link.position_min + 1e-3, link.position_max - 1e-3, link.position_max, link.position_min};
      q[i] = k % 3 == 0 ? 0.3 * draw(generator) : ends[(k + 3 * i) / (1 + i) % 4];
      qd[i] = k % 5 == 0 ? 0.0 : 3.0 * draw(generator), tau[i] = 15.0 * draw(generator);
    }
    const auto x = at<Rubbing>(q, qd);
    auto y = x;
    const auto held_efforts = pulled<Rubbing>(tau);
    ASSERT_TRUE(stopped_step(y, held_efforts).ok()) << k;
    Positions<Worn, double> where{value(x.q, 0), value(x.q, 1)};
    Velocities<Worn, double> speed{value(x.qd, 0), value(x.qd, 1)};
    Accelerations<Worn, double> a{1e3 * (value(y.qd, 0) - speed[0]), 1e3 * (value(y.qd, 1) - speed[1])};
    const auto needed = inverse_dynamics<Frictionless>(where, speed, a);
    for (int i = 0; i < 2; ++i) {
      const bool right = is_held_rightly(i, value(held_efforts.tau, i) - needed[i], x, y);
      wrong += !right;
      held += y.qd[i].raw == 0;
      stopped += std::fabs(value(y.q, i) - (value(y.qd, i) >= 0.0 ? Worn::chain.links[i].position_max
                                                                  : Worn::chain.links[i].position_min)) < 1e-7;
    }
  }
  EXPECT_GT(held, states / 10);
  EXPECT_GT(stopped, states / 10);
  EXPECT_EQ(wrong, 0);
}

// What is put beyond a limit is not thrown back: it stays, told, until it is pulled inside.
TEST(HeldWords, StayBeyondALimitUntilPulledBack) {
  auto x = at<TwoWheels>({0.0, 0.0});
  x.q[1].raw = detail::raw_angle(0.9);
  const auto there = x;
  for (int k = 0; k < 100; ++k)
    ASSERT_EQ(stopped_step(x, pulled<TwoWheels>({0.0, 3.0})).code, Status::Code::position_limit);
  EXPECT_TRUE(x.q[1] == there.q[1] && x.qd[1].raw == 0);
  for (int k = 0; k < 400; ++k)
    static_cast<void>(stopped_step(x, pulled<TwoWheels>({0.0, -3.0})));
  EXPECT_LT(value(x.q, 1), 0.7);
}

TEST(HeldWords, LeaveAStateAloneThatIsBeyondItsLimits) {
  auto x = at<TwoWheels>({0.0, 0.1});
  x.qd[0].raw = (std::numeric_limits<std::int32_t>::max)();
  const auto before = x;
  EXPECT_EQ(stopped_step(x, pulled<TwoWheels>({1.0, 1.0})).code, Status::Code::speed_limit);
  EXPECT_TRUE(x.q[1] == before.q[1] && x.qd[0].raw == before.qd[0].raw && x.steps == 0);
}

// Any words at all: a status, and of a state that is kept every speed is within its limit.
TEST(HeldWords, AnswerAnyState) {
  std::mt19937 generator(11);
  std::uniform_int_distribution<std::int32_t> word((std::numeric_limits<std::int32_t>::min)(),
                                                   (std::numeric_limits<std::int32_t>::max)());
  int kept = 0;
  for (int k = 0; k < 20'000; ++k) {
    Words<TwoWheels> x;
    Held<TwoWheels, Fixed32> held;
    for (int i = 0; i < 2; ++i)
      x.q[i].raw = word(generator), x.qd[i].raw = word(generator) >> (k % 3), held.tau[i].raw = word(generator);
    const auto before = x;
    const Status status = stopped_step(x, held);
    const bool moved = x.steps == 1;
    kept += moved;
    for (int i = 0; i < 2; ++i)
      if (moved)
        ASSERT_LE(std::fabs(value(x.qd, i)), 8.0 + 1e-6) << k;
      else
        ASSERT_TRUE(!status.ok() && x.q[i] == before.q[i] && x.qd[i].raw == before.qd[i].raw) << k;
  }
  EXPECT_GT(kept, 1000);
}

// --- what is stiff besides, and joints that share drives

namespace {

/// A wheel of 10^-3 kg m^2 with friction, and what holds it: 10^5 N m/rad.
struct Wheel {
  static constexpr auto chain = axial::chain(gravity(0.0, 0.0, 0.0), revolute()
                                                                         .mass(1.0)
                                                                         .inertia_com(1e-3, 1e-3, 1e-3)
                                                                         .coulomb(20.0)
                                                                         .viscous(0.1)
                                                                         .position_limits(-0.5, 0.5)
                                                                         .speed_limit(20.0)
                                                                         .acceleration_limit(1e4)
                                                                         .effort_limit(300.0));
};
using Stiff = Scene<Wheel, Friction>;
struct Servo {
  static constexpr double step = 1e-3, stiffness[] = {1e5}, damping[] = {0.5};
};
constexpr auto effort_of = [](double q, double qd) {
  return -Servo::stiffness[0] * (q - 0.25) - Servo::damping[0] * qd;
};
constexpr auto servo = [](const auto& where, auto& tau, auto&) { tau[0] = effort_of(where.q[0], where.qd[0]); };
constexpr auto servo_in_words = [](const auto& where, auto& tau, auto&) {
  tau = to_fixed<EffortsOf<Stiff, Fixed32>>(Joints<Wheel, double>{effort_of(value(where.q, 0), value(where.qd, 0))})
            .values;
};
constexpr auto told = [](const auto& where, auto& tau, auto& in, auto& stiffness) {
  servo(where, tau, in);
  stiffness.stiffness[0] = Servo::stiffness[0], stiffness.damping[0] = Servo::damping[0];
};

}  // namespace

TEST(HeldWords, TakeDrivesOfAnyStiffness) {
  for (const double start : {0.2502, 0.2501, 0.2498, 0.2515}) {
    auto x = at<Stiff>({start});
    Motion<Stiff, double> y, z;
    y.q[0] = z.q[0] = value(x.q, 0);
    for (int k = 0; k < 300; ++k) {
      ASSERT_TRUE(advance<StickingFor<Servo>>(x, servo_in_words).ok());
      ASSERT_TRUE(advance<StickingEuler>(y, 1e-3, told).ok());
      ASSERT_TRUE(advance<StickingFor<Servo>>(z, servo).ok());
      ASSERT_NEAR(value(x.q, 0), y.q[0], 1e-8) << start << ' ' << k;
      ASSERT_EQ(z.q[0], y.q[0]) << "in double it is StickingEuler of a drive that tells the same";
    }
    EXPECT_EQ(x.qd[0].raw, 0);
    EXPECT_LE(Servo::stiffness[0] * std::fabs(value(x.q, 0) - 0.25), 20.01) << "within the dead band";
  }
}

namespace {
using Wrist = Scene<robots::WristArm, Gravity, RotorInertia, Friction>;
constexpr int drives = joint_count<Wrist>;
}  // namespace

// Drives that joints share: what is held is a drive, and so is what stops, at drive_limits().
TEST(HeldWords, GoTheWayOfDoubleWhereJointsShareDrives) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  for (int run = 0; run < 6; ++run) {
    Numbers<Wrist> u, pull;
    for (int k = 0; k < drives; ++k) {
      const auto& drive = scene_of<Wrist>::Robot::chain.links[k];
      u[k] = 0.5 * (drive.position_max + drive.position_min) + 0.2 * draw(generator);
      pull[k] = 3.0 * drive.coulomb_forward * draw(generator);
    }
    auto x = at<Wrist>(u);
    const auto held = pulled<Wrist>(pull);
    Motion<Wrist, double> y;
    Held<Wrist, double> same;
    for (int k = 0; k < drives; ++k)
      y.q[k] = value(x.q, k), same.tau[k] = value(held.tau, k);
    for (int k = 0; k < 100; ++k) {
      ASSERT_TRUE(advance<Method<Wrist>>(x, held).ok()) << run << ' ' << k;
      ASSERT_TRUE(advance<StickingEuler>(y, 1e-3, same).ok());
    }
    for (int k = 0; k < drives; ++k)
      EXPECT_NEAR(value(x.q, k), y.q[k], 2e-5) << run << ' ' << k;
  }
}
namespace {
/// What holds the drives where they are at first.
struct WristServo {
  static constexpr double step = 1e-3;
  static constexpr double stiffness[] = {2e4, 3e4, 2e4, 500.0, 500.0}, damping[] = {20.0, 20.0, 10.0, 1.0, 1.0};
};
}  // namespace
TEST(HeldWords, TakeStiffDrivesThatJointsShare) {
  constexpr double start[] = {0.3, 0.5, -0.4, 0.2, -0.3}, rest[] = {0.31, 0.49, -0.41, 0.22, -0.32};
  auto x = at<Wrist>({start[0], start[1], start[2], start[3], start[4]});
  Motion<Wrist, double> y;
  for (int k = 0; k < drives; ++k)
    y.q[k] = value(x.q, k);
  const auto effort = [&](int k, double u, double ud) {
    return -WristServo::stiffness[k] * (u - rest[k]) - WristServo::damping[k] * ud;
  };
  const auto in_words = [&](const auto& where, auto& tau, auto&) {
    Numbers<Wrist> all;
    for (int k = 0; k < drives; ++k)
      all[k] = effort(k, value(where.q, k), value(where.qd, k));
    tau = to_fixed<EffortsOf<Wrist, Fixed32>>(all).values;
  };
  const auto telling = [&](const auto& where, auto& tau, auto&, auto& stiff) {
    for (int k = 0; k < drives; ++k) {
      const double most = scene_of<Wrist>::Robot::chain.links[k].effort_limit;
      tau[k] = std::fmin(most, std::fmax(-most, effort(k, where.q[k], where.qd[k])));
      stiff.stiffness[k] = WristServo::stiffness[k], stiff.damping[k] = WristServo::damping[k];
    }
  };
  for (int k = 0; k < 300; ++k) {
    ASSERT_TRUE(advance<StickingFor<WristServo>>(x, in_words).ok()) << k;
    ASSERT_TRUE(advance<StickingEuler>(y, 1e-3, telling).ok());
    for (int i = 0; i < drives; ++i)
      ASSERT_NEAR(value(x.q, i), y.q[i], 1e-6) << k << ' ' << i;
  }
  for (int k = 0; k < drives; ++k)
    EXPECT_NEAR(y.q[k], rest[k], 1e-2) << k;
}
TEST(HeldWords, StopDrivesThatJointsShare) {
  const auto& elbow = scene_of<Wrist>::Robot::chain.links[2];
  Numbers<Wrist> u{}, pull{};
  for (int k = 0; k < drives; ++k)
    u[k] = 0.5 *
           (scene_of<Wrist>::Robot::chain.links[k].position_max + scene_of<Wrist>::Robot::chain.links[k].position_min);
  u[1] = 2.5, u[2] = elbow.position_max - 0.01, pull[2] = 0.9 * elbow.effort_limit;
  auto x = at<Wrist>(u);
  for (int k = 0; k < 300; ++k)
    ASSERT_NE(stopped_step(x, pulled<Wrist>(pull)).code, Status::Code::saturated) << k;
  EXPECT_NEAR(value(x.q, 2), elbow.position_max, 1e-6);
  EXPECT_EQ(x.qd[2].raw, 0);
}
