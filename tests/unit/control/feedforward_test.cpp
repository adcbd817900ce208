#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cmath>
#include <robots/robots.hpp>

using namespace axial;

namespace {

using R = robots::Puma560;
using Code = Status::Code;
using J = Joints<R, float>;

const J rest{}, bent{0.1F, -0.5F, 0.3F, 0.2F, -0.4F, 0.5F};

void expect_equal(const J& a, const J& b) {
  for (int i = 0; i < J::size; ++i)
    EXPECT_EQ(a[i], b[i]) << i;
}
void expect_status(const Status& status, Code code, int joint) {
  EXPECT_EQ(status.code, code);
  EXPECT_EQ(status.joint, joint);
}

struct Weak {
  static constexpr auto chain = axial::chain(revolute().mass(1).com(1, 0, 0).effort_limit(0.5).acceleration_limit(10));
};

// The arm with a maximum of payload: 2 kg, its centre up to 0.25 m away, 0.01 kg m^2.
struct Carrier {
  static constexpr auto chain = [] {
    auto c = R::chain;
    c.payload_limit = payload_limit(2.0, 0.25, 0.01);
    return c;
  }();
};
using Carrying = Scene<Carrier, Gravity, RotorInertia, Friction, Payload, TipWrench>;

template <class T>
FeedforwardResult<Carrying, T> carry(FeedforwardState<Carrying, T>& state, const Inputs<Carrying, T>& in) {
  return feedforward<Carrying>(state, Joints<Carrier, T>{T(0.125), T(-0.5), T(0.25), T(0.25), T(-0.5), T(0.5)},
                               Joints<Carrier, T>{T(0.5), {}, {}, {}, {}, {}},
                               Joints<Carrier, T>{T(1), {}, {}, {}, {}, {}}, in);
}

}  // namespace

TEST(Feedforward, IsInverseDynamicsForAGoodRequest) {
  FeedforwardState<R, float> state;
  const auto result = feedforward<R>(state, bent, rest, rest);
  EXPECT_TRUE(result.status.ok());
  expect_equal(result.tau, inverse_dynamics<R>(bent, rest, rest));
}

TEST(Feedforward, StartsWithNoEffort) {
  FeedforwardState<R, float> state;
  auto bad = bent;
  bad[0] = NAN;
  expect_equal(feedforward<R>(state, bad, rest, rest).tau, J{});
}

TEST(Feedforward, HoldsTheLastSafeOutputOnBadRequests) {
  FeedforwardState<R, float> state;
  const auto safe = feedforward<R>(state, bent, rest, rest).tau;
  const float largest = std::numeric_limits<float>::max();
  const struct {
    float value;
    Code position, speed, acceleration;
  } bad[] = {{NAN, Code::not_finite, Code::not_finite, Code::not_finite},
             {INFINITY, Code::not_finite, Code::not_finite, Code::not_finite},
             {-INFINITY, Code::not_finite, Code::not_finite, Code::not_finite},
             {largest, Code::position_limit, Code::speed_limit, Code::acceleration_limit},
             {-largest, Code::position_limit, Code::speed_limit, Code::acceleration_limit}};
  for (const auto& b : bad)
    for (int i = 0; i < J::size; ++i) {
      auto q = bent, qd = rest, qdd = rest;
      q[i] = qd[i] = qdd[i] = b.value;
      const FeedforwardResult<R, float> results[] = {feedforward<R>(state, q, rest, rest),
                                                     feedforward<R>(state, bent, qd, rest),
                                                     feedforward<R>(state, bent, rest, qdd)};
      const Code codes[] = {b.position, b.speed, b.acceleration};
      for (int k = 0; k < 3; ++k) {
        expect_status(results[k].status, codes[k], i);
        expect_equal(results[k].tau, safe);
      }
    }
}

TEST(Feedforward, TheLimitsThemselvesAreInside) {
  FeedforwardState<R, double> state;
  Joints<R, double> low{}, high{};
  for (int i = 0; i < J::size; ++i)
    low[i] = R::chain.links[i].position_min, high[i] = R::chain.links[i].position_max;
  const Joints<R, double> still{};
  EXPECT_NE(feedforward<R>(state, low, still, still).status.code, Code::position_limit);
  EXPECT_NE(feedforward<R>(state, high, still, still).status.code, Code::position_limit);
}

TEST(Feedforward, ClampsAndReportsEfforts) {
  FeedforwardState<Weak, double> weak;
  const Joints<Weak, double> rest_weak{0.0}, fast{8.0};
  const auto up = feedforward<Weak>(weak, rest_weak, rest_weak, fast);
  expect_status(up.status, Code::effort_limit, 0);
  EXPECT_EQ(up.tau[0], 0.5);
  const auto down = feedforward<Weak>(weak, rest_weak, rest_weak, Joints<Weak, double>{-8.0});
  EXPECT_EQ(down.tau[0], -0.5);
}

TEST(Feedforward, CarriesPayloadFrictionAndTipWrench) {
  FeedforwardState<Carrying, double> state;
  const Joints<Carrier, double> q{0.1, -0.5, 0.3, 0.2, -0.4, 0.5}, qd{0.5, -0.4, 0.3, 0.2, -0.1, 0.6},
      qdd{1, 1, 1, 1, 1, 1};
  Inputs<Carrying, double> in;
  in.payload = {1.5, {0.0, 0.01, 0.1}, {0.002, 0.002, 0.001, 0, 0, 0}};
  in.tip_wrench = {{0.1, 0.2, 0.3}, {1.0, 2.0, 3.0}};
  const auto result = feedforward<Carrying>(state, q, qd, qdd, in);
  EXPECT_TRUE(result.status.ok());
  const auto bare = inverse_dynamics<Carrier>(q, qd, qdd);
  for (int i = 0; i < 6; ++i)
    EXPECT_NE(result.tau[i], bare[i]) << i;
  in.tip_wrench.force.x = NAN;
  expect_status(feedforward<Carrying>(state, q, qd, qdd, in).status, Code::not_finite, -1);
}

TEST(Feedforward, HoldsTheLastSafeOutputUnderAPayloadBeyondTheDeclaredOne) {
  FeedforwardState<Carrying, double> state;
  Inputs<Carrying, double> good;
  good.payload = {1.5, {0.0, 0.01, 0.1}, {0.002, 0.002, 0.001, 0, 0, 0}};
  const auto safe = carry(state, good).tau;
  using Body = PayloadBody<double>;
  double Body::*const mass = &Body::mass;
  const double beyond[] = {2.0001, -0.0001, NAN, INFINITY, -INFINITY};
  for (const double value : beyond) {
    auto bad = good;
    bad.payload.*mass = value;
    expect_status(carry(state, bad).status, Code::payload_limit, -1);
    for (double Vec3<double>::*axis : {&Vec3<double>::x, &Vec3<double>::y, &Vec3<double>::z}) {
      bad = good, bad.payload.com.*axis = value < 0.0 ? -0.2501 : value;
      const auto held = carry(state, bad);
      expect_status(held.status, Code::payload_limit, -1);
      for (int i = 0; i < 6; ++i)
        EXPECT_EQ(held.tau[i], safe[i]);
    }
    using J = Sym3<double>;
    for (double J::*entry : {&J::xx, &J::yy, &J::zz, &J::xy, &J::xz, &J::yz}) {
      bad = good, bad.payload.inertia_com.*entry = value < 0.0 ? -0.0101 : value;
      expect_status(carry(state, bad).status, Code::payload_limit, -1);
    }
  }
}

TEST(Feedforward, TheDeclaredPayloadItselfIsWithin) {
  FeedforwardState<Carrying, float> state;
  Inputs<Carrying, float> in;
  const float diagonal = 0.25F / std::sqrt(3.0F);
  in.payload = {2.0F, {diagonal, -diagonal, diagonal}, {0.01F, 0.01F, 0.01F, 0.01F, -0.01F, 0.01F}};
  EXPECT_NE(carry(state, in).status.code, Code::payload_limit);
  in.payload.com = {0.0F, 0.0F, -0.25F};
  EXPECT_NE(carry(state, in).status.code, Code::payload_limit);
}

TEST(Finite, LooksAtTheBits) {
  static_assert(is_finite(0.0F) && is_finite(std::numeric_limits<float>::max()) && is_finite(-1e300));
  EXPECT_FALSE(is_finite(NAN));
  EXPECT_FALSE(is_finite(static_cast<double>(INFINITY)));
}
