#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <random>
#include <robots/robots.hpp>

using namespace axial;

namespace {

using Code = Status::Code;
using Word = std::int32_t;
constexpr Word largest = std::numeric_limits<Word>::max(), smallest = std::numeric_limits<Word>::min();

void expect_status(const Status& status, Code code, int joint) {
  EXPECT_EQ(static_cast<int>(status.code), static_cast<int>(code));
  EXPECT_EQ(status.joint, joint);
}

template <class Values>
void expect_equal(const Values& a, const Values& b) {
  for (int i = 0; i < Values::size; ++i)
    EXPECT_EQ(a[i].raw, b[i].raw) << i;
}

struct Weak {
  static constexpr auto chain = axial::chain(
      revolute().mass(1).com(1, 0, 0).inertia_com(0, 0.1, 0.1).effort_limit(0.5).speed_limit(1).acceleration_limit(10));
};

// The Puma's sixth joint turns by more than a turn; its others are arcs.
using R = robots::Puma560;
using Q = Positions<R, Fixed32>;
using Qd = Velocities<R, Fixed32>;
using Qdd = Accelerations<R, Fixed32>;
const Joints<R, double> bent{0.1, -0.5, 0.3, 0.2, -0.4, 0.5}, rest{};

template <class S, class T>
Request<S, T> fixed(const Joints<robot_of<S>, double>& q, const Joints<robot_of<S>, double>& qd = {},
                    const Joints<robot_of<S>, double>& qdd = {}) {
  auto request = to_fixed_request<S, typename T::Word>(q, qd, qdd);
  EXPECT_TRUE(request.status.ok());
  return request;
}

template <class S, class T>
auto run(FeedforwardState<S, T>& state, const Request<S, T>& r) {
  return feedforward<S>(state, r.q, r.qd, r.qdd);
}

}  // namespace

TEST(FixedFeedforward, IsInverseDynamicsForAGoodRequest) {
  FeedforwardState<R, Fixed32> state;
  const auto r = fixed<R, Fixed32>(bent, rest, rest);
  const auto result = run(state, r);
  EXPECT_TRUE(result.status.ok());
  expect_equal(result.tau, inverse_dynamics<R>(r.q, r.qd, r.qdd));
  expect_equal(state.last_safe, result.tau);
  const auto exact = inverse_dynamics<R>(bent, rest, rest);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(to_real<double>(result.tau)[i], exact[i], 1e-6);
}

TEST(FixedFeedforward, HoldsTheLastSafeOutputOnBadRequests) {
  FeedforwardState<R, Fixed32> state;
  const auto good = fixed<R, Fixed32>(bent);
  const auto safe = run(state, good).tau;
  const auto& l = fixed_limits_of<R, Word>.joints;
  for (int i = 0; i < 6; ++i) {
    for (const Word beyond : {l[i].speed.raw + 1, -l[i].speed.raw - 1, largest, smallest}) {
      auto bad = good;
      bad.qd[i].raw = beyond;
      const auto held = run(state, bad);
      expect_status(held.status, Code::speed_limit, i);
      expect_equal(held.tau, safe);
    }
    for (const Word beyond : {l[i].acceleration.raw + 1, -l[i].acceleration.raw - 1, largest, smallest}) {
      auto bad = good;
      bad.qdd[i].raw = beyond;
      expect_status(run(state, bad).status, Code::acceleration_limit, i);
    }
    if (i == 5) continue;
    for (const Word beyond : {l[i].max + 1, l[i].min - 1}) {
      auto bad = good;
      bad.q[i].raw = beyond;
      const auto held = run(state, bad);
      expect_status(held.status, Code::position_limit, i);
      expect_equal(held.tau, safe);
    }
  }
}

TEST(FixedFeedforward, TheLimitsThemselvesAreInside) {
  const auto& l = fixed_limits_of<R, Word>.joints;
  for (int sign : {1, -1}) {
    Request<R, Fixed32> r;
    for (int i = 0; i < 6; ++i) {
      r.q[i].raw = sign > 0 ? l[i].max : l[i].min;
      r.qd[i].raw = sign * l[i].speed.raw, r.qdd[i].raw = sign * l[i].acceleration.raw;
    }
    EXPECT_TRUE(check_request<R>(r.q, r.qd, r.qdd).ok());
  }
}

TEST(FixedFeedforward, AWholeTurnIsNoLimit) {
  auto r = fixed<R, Fixed32>(bent);
  for (const Word q : {smallest, -1000000000, 0, 1000000000, largest}) {
    r.q[5].raw = q;
    EXPECT_TRUE(check_request<R>(r.q, r.qd, r.qdd).ok()) << q;
  }
}

TEST(FixedFeedforward, ClampsAndReportsEfforts) {
  FeedforwardState<Weak, Fixed32> state;
  const auto up = run(state, fixed<Weak, Fixed32>({0.0}, {0.0}, {8.0}));
  expect_status(up.status, Code::effort_limit, 0);
  EXPECT_EQ(to_real<double>(up.tau)[0], 0.5);
  EXPECT_EQ(to_real<double>(run(state, fixed<Weak, Fixed32>({0.0}, {0.0}, {-8.0})).tau)[0], -0.5);
  FeedforwardState<Weak, Fixed16> narrow;
  EXPECT_EQ(to_real<double>(run(narrow, fixed<Weak, Fixed16>({0.0}, {0.0}, {8.0})).tau)[0], 0.5);
}

TEST(FixedFeedforward, AgreesWithDoubleOnWhatIsBad) {
  std::mt19937 random(20240926);
  std::uniform_real_distribution<double> any(-1.15, 1.15);
  FeedforwardState<robots::Scara, Fixed32> fixed_state;
  FeedforwardState<robots::Scara, double> state;
  int bad = 0;
  for (int k = 0; k < 20000; ++k) {
    Request<robots::Scara, Fixed32> r;
    Joints<robots::Scara, double> q{}, qd{}, qdd{};
    for (int i = 0; i < 3; ++i) {
      const auto& p = robots::Scara::chain.links[i];
      q[i] = p.position_max * any(random), qd[i] = p.speed_limit * any(random);
      qdd[i] = p.acceleration_limit * any(random);
      const auto raw = [](double x, int e) { return static_cast<Word>(std::lround(std::ldexp(x, e))); };
      r.q[i].raw = p.type == JointType::revolute ? static_cast<Word>(std::lround(q[i] * 683565275.5764316))
                                                 : raw(q[i], Positions<robots::Scara, Fixed32>::exponent(i));
      r.qd[i].raw = raw(qd[i] * 0.86, Velocities<robots::Scara, Fixed32>::exponent(i)), qd[i] *= 0.86;
      r.qdd[i].raw = raw(qdd[i] * 0.86, Accelerations<robots::Scara, Fixed32>::exponent(i)), qdd[i] *= 0.86;
    }
    const auto expected = feedforward<robots::Scara>(state, q, qd, qdd);
    const auto result = run(fixed_state, r);
    expect_status(result.status, expected.status.code, expected.status.joint);
    bad += !result.status.ok();
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(to_real<double>(result.tau)[i], expected.tau[i], 1e-5);
  }
  EXPECT_GT(bad, 1000);
  EXPECT_LT(bad, 19000);
}

namespace {

struct Carrier {
  static constexpr auto chain = [] {
    auto c = robots::Scara::chain;
    c.payload_limit = payload_limit(2.0, 0.25, 0.05);
    c.tip_wrench_limit = tip_wrench_limit(20.0, 5.0);
    c.links[2].effort_limit = 80.0;
    return c;
  }();
};
using Loaded = Scene<Carrier, RuntimeGravity, RotorInertia, Payload, TipWrench, SineCosines>;
using In = Inputs<Loaded, Fixed32>;
using Formats = InputFormats<Carrier, Fixed32>;

Fixed32 at(double value, int exponent) { return {static_cast<Word>(std::lround(std::ldexp(value, exponent)))}; }

In good_inputs() {
  In in;
  in.payload.mass = at(1.9999999, Formats::payload_mass);
  in.payload.com = {at(0.0, 0), at(0.15, Formats::payload_com), at(-0.2, Formats::payload_com)};
  in.tip_wrench.force = {at(12.0, Formats::tip_force), at(-16.0, Formats::tip_force), {}};
  in.tip_wrench.moment = {{}, {}, at(-5.0, Formats::tip_moment)};
  for (auto& turn : in.turns.values)
    turn = {at(0.6, Formats::sine_cosine), at(0.8, Formats::sine_cosine)};
  return in;
}
Status status_of(const In& in) {
  FeedforwardState<Loaded, Fixed32> state;
  return feedforward<Loaded>(state, Positions<Carrier, Fixed32>{}, Velocities<Carrier, Fixed32>{},
                             Accelerations<Carrier, Fixed32>{}, in)
      .status;
}

}  // namespace

TEST(FixedFeedforward, RunTimeInputsBeyondTheDeclaredOnesAreRefused) {
  expect_status(status_of(good_inputs()), Code::ok, -1);
  const auto spoilt = [](auto spoil) {
    In in = good_inputs();
    spoil(in);
    return status_of(in);
  };
  const Status payloads[] = {
      spoilt([](In& in) { in.payload.mass.raw = -1; }),
      spoilt([](In& in) { in.payload.com.x = at(0.001, Formats::payload_com); }),
      spoilt([](In& in) { in.payload.com.x.raw = smallest; }),
      spoilt([](In& in) { in.payload.inertia_com.xx.raw = -1; }),
      spoilt([](In& in) { in.payload.inertia_com.xy.raw = smallest; }),
  };
  for (const Status& status : payloads)
    expect_status(status, Code::payload_limit, -1);
  const Status inputs[] = {
      spoilt([](In& in) { in.tip_wrench.force.z = at(0.1, Formats::tip_force); }),
      spoilt([](In& in) { in.tip_wrench.moment.x = at(0.1, Formats::tip_moment); }),
      spoilt([](In& in) { in.gravity.x = at(0.1, Formats::gravity); }),
      spoilt([](In& in) { in.turns[0] = {}; }),
      spoilt([](In& in) { in.turns[1].sin = at(1.0, Formats::sine_cosine); }),
  };
  for (const Status& status : inputs)
    expect_status(status, Code::input_limit, -1);
}

TEST(ClampedRequest, IsTheNearestWithinLimits) {
  const auto& l = fixed_limits_of<R, Word>.joints;
  auto asked = fixed<R, Fixed32>(bent);
  asked.q[1].raw = l[1].max + 5, asked.q[2].raw = l[2].min - 5, asked.qd[3].raw = largest, asked.qdd[4].raw = smallest;
  const auto near = clamped_request<R>(asked.q, asked.qd, asked.qdd);
  expect_status(near.status, Code::position_limit, 1);
  EXPECT_EQ(near.q[1].raw, l[1].max);
  EXPECT_EQ(near.q[2].raw, l[2].min);
  EXPECT_EQ(near.qd[3].raw, l[3].speed.raw);
  EXPECT_EQ(near.qdd[4].raw, -l[4].acceleration.raw);
  EXPECT_EQ(near.q[0].raw, asked.q[0].raw);
  EXPECT_TRUE(check_request<R>(near.q, near.qd, near.qdd).ok());
}

TEST(ClampedRequest, LeavesAGoodRequestAlone) {
  const auto asked = fixed<R, Fixed32>(bent, rest, rest);
  const auto near = clamped_request<R>(asked.q, asked.qd, asked.qdd);
  EXPECT_TRUE(near.status.ok());
  expect_equal(near.q, asked.q);
}

TEST(ClampedRequest, IsAlwaysInside) {
  std::mt19937 random(20240927);
  for (int k = 0; k < 100000; ++k) {
    Request<robots::Scara, Fixed32> any;
    for (int i = 0; i < 3; ++i)
      any.q[i].raw = static_cast<Word>(random()), any.qd[i].raw = static_cast<Word>(random()),
      any.qdd[i].raw = static_cast<Word>(random());
    const auto near = clamped_request<robots::Scara>(any.q, any.qd, any.qdd);
    EXPECT_TRUE(check_request<robots::Scara>(near.q, near.qd, near.qdd).ok());
    const bool good = check_request<robots::Scara>(any.q, any.qd, any.qdd).ok();
    EXPECT_EQ(near.status.ok(), good);
    // The slide's nearest end is on the number line, however far it is.
    if (any.q[2].raw < 0) {
      EXPECT_EQ(near.q[2].raw, 0);
    }
  }
}

TEST(ClampedRequest, InFloatingPointLeavesNaNToTheCheck) {
  Joints<R, float> q{}, qd{}, qdd{};
  q[0] = 10.0F, qd[1] = -INFINITY, qdd[2] = NAN;
  const auto near = clamped_request<R>(q, qd, qdd);
  expect_status(near.status, Code::position_limit, 0);
  EXPECT_EQ(near.q[0], static_cast<float>(R::chain.links[0].position_max));
  EXPECT_EQ(near.qd[1], -1.2F);
  FeedforwardState<R, float> state;
  expect_status(feedforward<R>(state, near.q, near.qd, near.qdd).status, Code::not_finite, 2);
}
