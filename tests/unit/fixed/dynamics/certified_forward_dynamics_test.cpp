// Certified forward dynamics of one arm that formats for the least inertia would leave no bits: a tip of a gram on
// links of kilograms, under efforts that could drive it at a million times the acceleration that it declares.
#include <gtest/gtest.h>
#include <axial/fixed.hpp>
#include <axial/fixed/dynamics/certified_forward_dynamics.hpp>
#include <cmath>
#include <host_sim/figures/exhaustive/fixed_states.hpp>

#include "light_tip.hpp"

using namespace axial;

namespace {

// A pendulum whose efforts could drive it at two thousand times what it declares, and one at fifty times.
struct Quick {
  static constexpr auto chain = axial::chain(gravity(0.0, -9.81, 0.0), joint(0.1, 0.13));
};
struct Slow {
  static constexpr auto chain = axial::chain(gravity(0.0, -9.81, 0.0), joint(1.0, 0.3));
};
using T = Fixed32;
using State = exhaustive::FixedState<LightTip, T>;

/// A state whose efforts give the accelerations that it asks for.
State in_limits(exhaustive::Random& random) {
  State state;
  for (int k = 0; k < 3 * State::size; ++k) {
    const auto span = State::span(k);
    state.set(k, random.between(span.low / 2, span.high / 2));
  }
  const auto tau =
      inverse_dynamics<LightTip>(exhaustive::in_double<LightTip, T>(state.q), exhaustive::in_double<LightTip>(state.qd),
                                 exhaustive::in_double<LightTip>(state.qdd));
  for (int i = 0; i < State::size; ++i)
    state.tau[i].raw = static_cast<std::int32_t>(std::lrint(std::ldexp(tau[i], state.tau.exponent(i))));
  return state;
}
template <class R>
Joints<R, double> exact(const exhaustive::FixedState<R, T>& state) {
  return forward_dynamics<Scene<R, Gravity, RotorInertia, ArticulatedBody>>(
      exhaustive::in_double<R, T>(state.q), exhaustive::in_double<R>(state.qd), exhaustive::in_double<R>(state.tau));
}

/// A state at rest at an angle of zero whose last joint accelerates at so many times what it declares, the others not.
template <class R>
exhaustive::FixedState<R, T> at_times(double times) {
  using Given = exhaustive::FixedState<R, T>;
  Given state{};
  Joints<R, double> qdd{};
  qdd[Given::size - 1] = times * 32.0;
  const auto tau = inverse_dynamics<R>(exhaustive::in_double<R, T>(state.q), exhaustive::in_double<R>(state.qd), qdd);
  for (int i = 0; i < Given::size; ++i)
    state.tau[i].raw = static_cast<std::int32_t>(std::lrint(std::ldexp(tau[i], state.tau.exponent(i))));
  return state;
}
/// What forward dynamics says of it, its answer being right to a thousandth of what is declared.
template <class R>
Status status_at(double times) {
  const auto state = at_times<R>(times);
  const auto answer = forward_dynamics<R>(state.q, state.qd, state.tau);
  const int last = decltype(state)::size - 1;
  EXPECT_NEAR(answer[last].raw * std::ldexp(1.0, -answer.exponent(last)), exact(state)[last], 1e-3 * 32.0);
  return answer.status;
}

}  // namespace

TEST(ForwardDynamics, NamesWhatIsFartherBeyondTheDeclaredAccelerationThanItIsRight) {
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_TRUE(status_at<LightTip>(1.45 * sign).ok());
    const Status beyond = status_at<LightTip>(1.55 * sign);
    EXPECT_EQ(beyond.code, Status::Code::acceleration_limit);
    EXPECT_EQ(beyond.joint, 2);
    EXPECT_TRUE(status_at<Quick>(250.0 * sign).ok());
    EXPECT_EQ(status_at<Quick>(262.0 * sign).code, Status::Code::acceleration_limit);
    EXPECT_TRUE(status_at<Slow>(30.0 * sign).ok());
  }
}

// The certificate of such an answer holds all the same.
TEST(CertifiedForwardDynamics, KnowsABoundBeyondTheDeclaredAcceleration) {
  const State state = at_times<LightTip>(1.6);
  const auto wanted = exact(state);
  const auto proved = certified_forward_dynamics<LightTip>(state.q, state.qd, state.tau);
  EXPECT_EQ(proved.status.code, Status::Code::acceleration_limit);
  EXPECT_EQ(proved.status.joint, 2);
  for (int i = 0; i < State::size; ++i) {
    const double unit = std::ldexp(1.0, -proved.exponent(i));
    EXPECT_LE(std::fabs(proved[i].raw * unit - wanted[i]), proved.bound[i].raw * unit) << "joint " << i;
    EXPECT_LE(proved.bound[i].raw * unit, 32.0 / 128.0) << "joint " << i;
  }
}

TEST(CertifiedForwardDynamics, BoundsItsErrorByATenThousandthOfTheDeclaredAcceleration) {
  exhaustive::Random random(3);
  double worst = 0.0, worst_plain = 0.0, bound = 0.0;
  for (int k = 0; k < 3000; ++k) {
    const State state = in_limits(random);
    const auto wanted = exact(state);
    const auto plain = forward_dynamics<LightTip>(state.q, state.qd, state.tau);
    const auto proved = certified_forward_dynamics<LightTip>(state.q, state.qd, state.tau);
    ASSERT_TRUE(plain.status.ok() && proved.status.ok()) << status_text(proved.status);
    for (int i = 0; i < State::size; ++i) {
      const double unit = std::ldexp(1.0, -plain.exponent(i)), error = std::fabs(proved[i].raw * unit - wanted[i]);
      EXPECT_LE(error, proved.bound[i].raw * unit) << "joint " << i;
      worst = std::fmax(worst, error), bound = std::fmax(bound, proved.bound[i].raw * unit);
      worst_plain = std::fmax(worst_plain, std::fabs(plain[i].raw * unit - wanted[i]));
    }
  }
  std::printf("plain %.1e, certified %.1e of which %.1e are seen\n", worst_plain, bound, worst);
  EXPECT_LE(worst_plain, 1e-4 * 32.0);
  EXPECT_LE(bound, 1e-4 * 32.0);
  EXPECT_LE(bound, 30.0 * worst);
}

// The residual's own error is that of inverse dynamics in words of the declared motion.
TEST(CertifiedForwardDynamics, KnowsWhatItsInverseDynamicsIsOff) {
  using C = detail::Certificate<LightTip, T>;
  constexpr const auto& certificate = detail::certificate_of<LightTip, T>;
  const auto links = links_of<scene_of<LightTip>, T, BaseParameters, recursion::MotionEfforts>();
  exhaustive::Random random(4);
  double nearest = 0.0;
  for (int k = 0; k < 3000; ++k) {
    const State state = in_limits(random);
    C::Needs needs{};
    execute<rnea::InverseDynamics>(links, Inputs<LightTip, T>{}, state.q, state.qd, state.qdd, needs);
    const auto wanted = inverse_dynamics<LightTip>(exhaustive::in_double<LightTip, T>(state.q),
                                                   exhaustive::in_double<LightTip>(state.qd),
                                                   exhaustive::in_double<LightTip>(state.qdd));
    for (int i = 0; i < State::size; ++i) {
      const double off = std::fabs(needs[i].raw - std::ldexp(wanted[i], C::Needs::exponent(i)));
      EXPECT_LE(off, certificate.need_error[i]) << "joint " << i;
      nearest = std::fmax(nearest, off / certificate.need_error[i]);
    }
  }
  EXPECT_GT(nearest, 0.05);
}

TEST(CertifiedForwardDynamics, SaysWhatItDoesNotKnow) {
  State state{};
  state.qd[1].raw = INT32_MAX;
  const auto fast = certified_forward_dynamics<LightTip>(state.q, state.qd, state.tau);
  EXPECT_EQ(fast.status.code, Status::Code::speed_limit);
  EXPECT_EQ(fast.bound[0].raw, INT32_MAX);
  state.qd[1].raw = 0;
  state.tau[2].raw = static_cast<std::int32_t>(std::ldexp(2e-3, state.tau.exponent(2)));
  const auto beyond = certified_forward_dynamics<LightTip>(state.q, state.qd, state.tau);
  EXPECT_EQ(beyond.status.code, Status::Code::acceleration_limit) << "the tip at a thousand times what it declares";
  state.tau[2].raw = INT32_MAX;
  EXPECT_EQ(certified_forward_dynamics<LightTip>(state.q, state.qd, state.tau).status.code, Status::Code::saturated);
}
