#include <gtest/gtest.h>
#include <axial/axial.hpp>
#include <cmath>
#include <robots/robots.hpp>

using namespace axial;

namespace {

using R = robots::Puma560;
using Code = Status::Code;
using J = Joints<R, double>;

const J bent{0.1, -0.5, 0.3, 0.2, -0.4, 0.5}, moving{0.5, -1.0, 0.75, 1.0, -0.5, 0.25},
    faster{1.0, 1.125, -1.5, 0.5, -1.0, 1.5};

struct Weak {
  static constexpr auto chain = axial::chain(revolute().mass(1).com(1, 0, 0).effort_limit(0.5).acceleration_limit(10));
};
struct Carrier {
  static constexpr auto chain = axial::chain(gravity(0, 0, -9.81), revolute().alpha_deg(90).mass(1).com(1, 0, 0),
                                             axial::payload_limit(2.0, 0.5, 0.01));
};

// A slide whose inertia about the joint before it is no number of float where it is far out.
struct Overflowing {
  static constexpr auto chain =
      axial::chain(gravity(0, 0, -9.81), revolute(),
                   prismatic().alpha_deg(90).mass(1e32).position_limits(-1e4, 1e4).accept(as_published));
};

void expect_near(const J& a, const J& b, double tolerance) {
  for (int i = 0; i < J::size; ++i)
    EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

}  // namespace

TEST(TwoRate, IsInverseDynamicsWhereItWasRefreshed) {
  TwoRateState<R, double> state;
  EXPECT_TRUE(refresh<R>(state, bent).ok());
  const auto result = two_rate_feedforward<R>(state, moving, faster);
  EXPECT_TRUE(result.status.ok());
  expect_near(result.tau, inverse_dynamics<R>(bent, moving, faster), 1e-12);
}

TEST(TwoRate, HoldsTheTermsBetween) {
  TwoRateState<R, double> state;
  ASSERT_TRUE(refresh<R>(state, bent).ok());
  ASSERT_TRUE(two_rate_feedforward<R>(state, moving, faster).status.ok());
  const auto later = two_rate_feedforward<R>(state, faster, moving);
  expect_near(later.tau, inverse_dynamics<R>(bent, faster, moving), 1e-12);
}

TEST(TwoRate, IsNotReadyBeforeTheFirstRefresh) {
  TwoRateState<R, double> state;
  const auto result = two_rate_feedforward<R>(state, moving, faster);
  EXPECT_EQ(result.status.code, Code::not_ready);
  expect_near(result.tau, J{}, 0.0);
}

TEST(TwoRate, KeepsItsTermsOnABadRefresh) {
  TwoRateState<R, double> state;
  ASSERT_TRUE(refresh<R>(state, bent).ok());
  J bad = bent;
  bad[3] = NAN;
  EXPECT_EQ(refresh<R>(state, bad).code, Code::not_finite);
  EXPECT_EQ(refresh<R>(state, bad).joint, 3);
  bad[3] = 100.0;
  EXPECT_EQ(refresh<R>(state, bad).code, Code::position_limit);
  expect_near(two_rate_feedforward<R>(state, moving, faster).tau, inverse_dynamics<R>(bent, moving, faster), 1e-12);
}

TEST(TwoRate, KeepsItsTermsWhenARefreshHasInputsThatAreNoNumbers) {
  using Pushed = Scene<Carrier, Gravity, TipWrench>;
  TwoRateState<Pushed, double> state;
  Inputs<Pushed, double> in{};
  in.tip_wrench.force.y = 1.0;
  ASSERT_TRUE(refresh<Pushed>(state, {0.5}, in).ok());
  const auto before = state.terms.G[0];
  for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY)}) {
    in.tip_wrench.moment.z = bad;
    EXPECT_EQ(refresh<Pushed>(state, {0.25}, in).code, Code::not_finite) << bad;
    EXPECT_EQ(state.terms.G[0], before);
    EXPECT_EQ(state.q[0], 0.5);
  }
}

TEST(TwoRate, KeepsItsTermsWhenThoseOfARefreshAreNotFinite) {
  TwoRateState<Overflowing, float> state;
  ASSERT_TRUE(refresh<Overflowing>(state, {0.5F, 1.0F}).ok());
  const auto before = state.terms.A[0][0];
  EXPECT_EQ(refresh<Overflowing>(state, {0.5F, 9e3F}).code, Code::not_finite);
  EXPECT_EQ(state.terms.A[0][0], before);
  EXPECT_EQ(state.q[1], 1.0F);
}

TEST(TwoRate, AnswersABadRequestWithTheLastSafeEffort) {
  TwoRateState<R, double> state;
  ASSERT_TRUE(refresh<R>(state, bent).ok());
  const auto good = two_rate_feedforward<R>(state, moving, faster).tau;
  J bad = moving;
  bad[1] = HUGE_VAL;
  const auto held = two_rate_feedforward<R>(state, bad, faster);
  EXPECT_EQ(held.status.code, Code::not_finite);
  EXPECT_EQ(held.status.joint, 1);
  expect_near(held.tau, good, 0.0);
}

TEST(TwoRate, ClampsAndReportsEfforts) {
  TwoRateState<Weak, float> state;
  ASSERT_TRUE(refresh<Weak>(state, Joints<Weak, float>{}).ok());
  const auto result = two_rate_feedforward<Weak>(state, Joints<Weak, float>{}, Joints<Weak, float>{9.0F});
  EXPECT_EQ(result.status.code, Code::effort_limit);
  EXPECT_EQ(result.tau[0], 0.5F);
}

TEST(TwoRate, TakesAPayloadWithinTheDeclaredMaximum) {
  using S = Scene<Carrier, Gravity, Friction, Payload>;
  TwoRateState<S, double> state;
  Inputs<S, double> in;
  in.payload = {1.0, {0.25, 0.0, 0.0}, {}};
  EXPECT_TRUE(refresh<S>(state, Joints<Carrier, double>{}, in).ok());
  in.payload.mass = 3.0;
  EXPECT_EQ(refresh<S>(state, Joints<Carrier, double>{}, in).code, Code::payload_limit);
  const auto tau = two_rate_feedforward<S>(state, Joints<Carrier, double>{}, Joints<Carrier, double>{}).tau;
  in.payload.mass = 1.0;
  EXPECT_NEAR(tau[0], inverse_dynamics<S>(Joints<Carrier, double>{}, {}, {}, in)[0], 1e-12);
}
