// The safe call of a control loop: feed-forward and feedback, clamped once, no faster than declared, gravity
// compensation where something is wrong.
#include "arms.hpp"
#include "safe_loop.hpp"

#include <algorithm>
#include <random>

using namespace axial;
using safe_loop::Case;
using safe_loop::Code;
using safe_loop::expect_status;

namespace {

using Cases = control_tests::MoreArms<Case>;

template <class C>
class Track : public testing::Test {
 protected:
  using S = typename C::S;
  using T = typename C::T;
  using Real = typename C::Real;
  static constexpr int n = C::n;

  // At the whole effort for an error of a tenth of the range, or of the largest speed.
  static Real stiffness() {
    Real k{};
    for (int i = 0; i < n; ++i)
      k[i] = 10.0 * C::link(i).effort_limit / (C::link(i).position_max - C::link(i).position_min);
    return k;
  }
  static Real damping() {
    Real d{};
    for (int i = 0; i < n; ++i)
      d[i] = 10.0 * C::link(i).effort_limit / C::link(i).speed_limit;
    return d;
  }
  static auto gains() { return C::gains(stiffness(), damping()); }
  static Real acceleration(double share) {
    Real qdd{};
    for (int i = 0; i < n; ++i)
      qdd[i] = (i % 2 == 0 ? -share : share) * C::link(i).acceleration_limit;
    return qdd;
  }
  static Real off(Real x, const Real& by) {
    for (int i = 0; i < n; ++i)
      x[i] += by[i];
    return x;
  }
  static Real weight(const Real& q) {
    Real tau = gravity_torque<S, double>(q);
    for (int i = 0; i < n; ++i)
      tau[i] = std::clamp(tau[i], -C::link(i).effort_limit, C::link(i).effort_limit);
    return tau;
  }
  static double rounding(int i) { return 20.0 * C::tolerance(i); }

  SafeLoopState<S, T> state_{};
};
TYPED_TEST_SUITE(Track, Cases);

/// Words beyond what the format allows of joint i's position, or what is not a number.
template <class C, class Q>
void spoil(Q& q, int i) {
  if constexpr (is_stored_v<typename C::T>)
    q[i].raw = fixed_limits_of<typename C::S, std::int32_t>.joints[i].max + 1;
  else
    q[i] = NAN;
}

}  // namespace

TYPED_TEST(Track, AddsTheFeedbackToTheFeedForwardAndClampsTheSumOnce) {
  using C = TypeParam;
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  int clamped = 0, free = 0;
  for (int k = 0; k < 100; ++k) {
    const auto q = C::position(0.5 + 0.3 * share(engine)), qd = C::speed(0.4 * share(engine));
    const auto qdd = this->acceleration(0.3 * share(engine));
    typename C::Real dq{}, dv{};
    const double size = k % 2 == 0 ? 0.002 : 0.15;
    for (int i = 0; i < C::n; ++i) {
      dq[i] = size * share(engine) * (C::link(i).position_max - C::link(i).position_min);
      dv[i] = size * share(engine) * C::link(i).speed_limit;
    }
    const auto exact = inverse_dynamics<typename C::S, double>(q, qd, qdd);
    const auto answer = track<typename C::S>(this->state_, C::request(q, qd, qdd),
                                             C::measured(this->off(q, dq), this->off(qd, dv)), this->gains());
    const auto found = C::real(answer.tau);
    int first = -1;
    for (int i = C::n; i-- > 0;) {
      const double sum = exact[i] - this->stiffness()[i] * dq[i] - this->damping()[i] * dv[i];
      const double most = C::link(i).effort_limit;
      EXPECT_NEAR(found[i], std::clamp(sum, -most, most), this->rounding(i)) << k << ", joint " << i;
      EXPECT_LE(std::fabs(found[i]), most * (1.0 + 1e-7));
      if (std::fabs(sum) > most) first = i;
    }
    expect_status(answer.status, first < 0 ? Code::ok : Code::effort_limit, first);
    (first < 0 ? free : clamped)++;
  }
  EXPECT_GT(clamped, 10);
  EXPECT_GT(free, 10);
}

TYPED_TEST(Track, CompensatesGravityWhereTheRequestIsBad) {
  using C = TypeParam;
  const auto q = C::position(0.55), qd = C::speed(0.3);
  const auto seen = C::measured(C::position(0.45), qd);
  const auto good = C::request(q, qd, this->acceleration(0.2));
  for (int i = 0; i < C::n; ++i) {
    for (int kind = 0; kind < 3; ++kind) {
      auto bad = good;
      if constexpr (is_stored_v<typename C::T>) {
        const auto& l = fixed_limits_of<typename C::S, std::int32_t>.joints[i];
        if (kind == 0 && l.span == std::numeric_limits<std::uint32_t>::max()) continue;
        if (kind == 0) bad.q[i].raw = l.max + 1;
        if (kind == 1) bad.qd[i].raw = l.speed.raw + 1;
        if (kind == 2) bad.qdd[i].raw = -l.acceleration.raw - 1;
      } else {
        const auto nan = std::numeric_limits<typename C::T>::quiet_NaN();
        if (kind == 0) bad.q[i] = nan;
        if (kind == 1) bad.qd[i] = -std::numeric_limits<typename C::T>::infinity();
        if (kind == 2) bad.qdd[i] = static_cast<typename C::T>(C::link(i).acceleration_limit * 1.01);
      }
      const auto answer = track<typename C::S>(this->state_, bad, seen, this->gains());
      EXPECT_FALSE(answer.status.met());
      EXPECT_EQ(answer.status.joint, i);
      C::expect_near(C::real(answer.tau), this->weight(C::position(0.45)), "weight");
    }
  }
  auto marked = good;
  marked.status = {Code::position_limit, 1};
  const auto answer = track<typename C::S>(this->state_, marked, seen, this->gains());
  expect_status(answer.status, Code::position_limit, 1);
  C::expect_near(C::real(answer.tau), this->weight(C::position(0.45)), "marked as bad");
  marked.status = {};
  EXPECT_TRUE(track<typename C::S>(this->state_, marked, seen, this->gains()).status.met()) << "cleared";
}

TYPED_TEST(Track, CompensatesGravityWhereTheArmWasSeenLastWhereTheMeasurementIsBad) {
  using C = TypeParam;
  const auto q = C::position(0.55), qd = C::speed(0.3);
  const auto wanted = C::request(q, qd);
  EXPECT_TRUE(
      track<typename C::S>(this->state_, wanted, C::measured(C::position(0.5), qd), this->gains()).status.met());
  for (int i = 0; i < C::n; ++i) {
    auto seen = C::measured(C::position(0.4), qd);
    if constexpr (is_stored_v<typename C::T>)
      if (fixed_limits_of<typename C::S, std::int32_t>.joints[i].span == std::numeric_limits<std::uint32_t>::max())
        continue;
    spoil<C>(seen.q, i);
    auto answer = track<typename C::S>(this->state_, wanted, seen, this->gains());
    EXPECT_FALSE(answer.status.met());
    EXPECT_EQ(answer.status.joint, i);
    C::expect_near(C::real(answer.tau), this->weight(C::position(0.5)), "position");
    seen = C::measured(C::position(0.4), qd);
    if constexpr (is_stored_v<typename C::T>)
      seen.qd[i].raw = -fixed_limits_of<typename C::S, std::int32_t>.joints[i].speed.raw - 1;
    else
      seen.qd[i] = static_cast<typename C::T>(1.01 * C::link(i).speed_limit);
    answer = track<typename C::S>(this->state_, wanted, seen, this->gains());
    expect_status(answer.status, Code::speed_limit, i);
    C::expect_near(C::real(answer.tau), this->weight(C::position(0.5)), "speed");
  }
  auto seen = C::measured(C::position(0.4), qd);
  seen.status = {Code::not_ready, -1};  // an encoder that has not found its zero
  const auto answer = track<typename C::S>(this->state_, wanted, seen, this->gains());
  expect_status(answer.status, Code::not_ready, -1);
  C::expect_near(C::real(answer.tau), this->weight(C::position(0.5)), "marked as bad");
}

TYPED_TEST(Track, StartsWithNoEffort) {
  using C = TypeParam;
  auto seen = C::measured(C::position(0.4));
  spoil<C>(seen.q, 0);
  const auto answer = track<typename C::S>(this->state_, C::request(C::position(0.5)), seen, this->gains());
  EXPECT_FALSE(answer.status.met());
  C::expect_near(C::real(answer.tau), {}, "nothing");
}

// Whatever comes, in whatever order: motions, bad requests, bad measurements, from the first call on.
TYPED_TEST(Track, ChangesNoFasterThanDeclaredWhateverComes) {
  using C = TypeParam;
  const auto step = C::efforts(0.02);
  this->state_.output.step = C::effort(step);
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  auto last = typename C::Real{};
  int limited = 0;
  for (int k = 0; k < 500; ++k) {
    const auto q = C::position(0.5 + 0.4 * share(engine));
    auto wanted = C::request(q, C::speed(share(engine)), this->acceleration(share(engine)));
    auto seen = C::measured(C::position(0.5 + 0.4 * share(engine)), C::speed(share(engine)));
    if (k % 7 == 3) spoil<C>(wanted.q, 0);
    if (k % 5 == 2) spoil<C>(seen.q, 0);
    const auto answer = track<typename C::S>(this->state_, wanted, seen, this->gains());
    EXPECT_EQ(answer.status.met(), k % 7 != 3 && k % 5 != 2) << k;
    const auto now = C::real(answer.tau);
    for (int i = 0; i < C::n; ++i) {
      EXPECT_LE(std::fabs(now[i] - last[i]), step[i] + C::tolerance(i)) << k << ", joint " << i;
      limited += std::fabs(now[i] - last[i]) > 0.99 * step[i] ? 1 : 0;
    }
    last = now;
  }
  EXPECT_GT(limited, 100);
}

TYPED_TEST(Track, RefusesNegativeGains) {
  using C = TypeParam;
  const auto q = C::position(0.55), at = C::position(0.45);
  for (int i = 0; i < C::n; ++i)
    for (const bool damping : {false, true}) {
      auto gains = this->gains();
      auto& gain = damping ? gains.damping[i] : gains.stiffness[i];
      gain = -gain;
      const auto answer = track<typename C::S>(this->state_, C::request(q), C::measured(at), gains);
      expect_status(answer.status, Code::input_limit, i);
      C::expect_near(C::real(answer.tau), this->weight(at), "weight");
    }
}

// Gains of 0 are gains: of stiffness, of damping, of both.
TYPED_TEST(Track, TakesGainsOfNothing) {
  using C = TypeParam;
  const auto q = C::position(0.55);
  for (const int left : {0, 1, 2}) {
    auto gains = this->gains();
    for (int i = 0; i < C::n; ++i) {
      if (left != 1) gains.stiffness[i] -= gains.stiffness[i];
      if (left != 2) gains.damping[i] -= gains.damping[i];
    }
    const auto answer = track<typename C::S>(this->state_, C::request(q), C::measured(q), gains);
    EXPECT_TRUE(answer.status.met()) << left;
    C::expect_near(C::real(answer.tau), this->weight(q), "weight");
  }
}

TYPED_TEST(Track, SharesItsMemoryWithHandGuiding) {
  using C = TypeParam;
  this->state_.output.step = C::effort(C::efforts(0.02));
  const auto q = C::position(0.55), at = C::position(0.45);
  typename C::Real last{};
  for (int k = 0; k < 50; ++k) {
    const auto answer = k % 2 == 0 ? track<typename C::S>(this->state_, C::request(q), C::measured(at), this->gains())
                                   : compensate_gravity<typename C::S>(this->state_, C::place(at));
    const auto now = C::real(answer.tau);
    for (int i = 0; i < C::n; ++i)
      EXPECT_LE(std::fabs(now[i] - last[i]), 0.02 * C::link(i).effort_limit + C::tolerance(i));
    last = now;
  }
}

namespace {

using R = robots::Scara;

}  // namespace

TEST(TrackOf, ASumThatOverflowsOrGainsThatAreNoNumbersGiveGravity) {
  const Joints<R, float> q{0.1F, 0.2F, 0.1F}, at{0.2F, 0.1F, 0.05F};
  SafeLoopState<R, float> state;
  for (const float gain : {3e38F, INFINITY, NAN}) {
    const TrackingGains<R, float> gains{{1.0F, gain, 1.0F}, {gain, gain, gain}};
    MeasuredMotion<R, float> seen{at, {0.5F, 4.0F, 0.5F}, {}};
    const auto answer = track<R>(state, {q, {-4.0F, -5.0F, 0.0F}, {}, {}}, seen, gains);
    EXPECT_FALSE(answer.status.met()) << gain;
    const auto weight = gravity_torque<R>(at);
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(answer.tau[i], weight[i]) << gain;
  }
}

namespace {

// A joint of 300 degrees and one that turns for ever.
struct Wide {
  static constexpr auto chain = axial::chain(gravity(0.0, 0.0, -10.0),
                                             revolute()
                                                 .mass(1)
                                                 .com(0.1, 0, 0)
                                                 .inertia_com(0.1, 0.1, 0.1)
                                                 .position_limits(-2.6, 2.6)
                                                 .speed_limit(2)
                                                 .acceleration_limit(10)
                                                 .effort_limit(50),
                                             revolute()
                                                 .a(0.1)
                                                 .mass(1)
                                                 .com(0.1, 0, 0)
                                                 .inertia_com(0.1, 0.1, 0.1)
                                                 .position_limits(-10, 10)
                                                 .speed_limit(2)
                                                 .acceleration_limit(10)
                                                 .effort_limit(50));
};
using WideCase = Case<Wide, Fixed32>;

}  // namespace

// The short way from 2.5 rad to -2.5 rad leads through the stop.
TEST(TrackOf, InFixedPointAnErrorIsTakenAlongTheArcThatTheLimitsAllow) {
  SafeLoopState<Wide, Fixed32> state;
  const auto gains = WideCase::gains({4.0, 4.0}, {0.0, 0.0});
  const auto answer = track<Wide>(state, WideCase::request({-2.5, -3.0}), WideCase::measured({2.5, 3.0}), gains);
  const auto tau = WideCase::real(answer.tau);
  EXPECT_NEAR(tau[0], -4.0 * 3.14159265358979, 1e-4) << "backwards, as far as a word counts: half a turn";
  EXPECT_NEAR(tau[1], 4.0 * (2.0 * 3.14159265358979 - 6.0), 1e-4) << "the short way round";
}

TEST(TrackOf, GainsInWordsSayWhereTheyCannotBeKept) {
  using Gains = TrackingGains<R, double>;
  EXPECT_TRUE((to_fixed_gains<R, std::int32_t>(Gains{{100, 100, 1000}, {10, 10, 100}}).status.ok()));
  expect_status(to_fixed_gains<R, std::int32_t>(Gains{{100, -1, 1000}, {10, 10, 100}}).status, Code::input_limit, 1);
  expect_status(to_fixed_gains<R, std::int32_t>(Gains{{100, 1, 1000}, {10, 10, NAN}}).status, Code::input_limit, 2);
  const auto large = to_fixed_gains<R, std::int32_t>(Gains{{1e30, 1, 1000}, {10, 10, 0}});
  expect_status(large.status, Code::input_limit, 0);
  EXPECT_EQ(large.gains.stiffness[0], std::numeric_limits<std::int32_t>::max());
}
