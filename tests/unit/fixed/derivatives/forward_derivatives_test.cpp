// Derivatives of forward dynamics in fixed point: statuses, what is not asked for, loads.
#include <unit/fixed/dynamics/light_tip.hpp>

#include "words_and_bounds.hpp"

namespace {

exhaustive::FixedState<R, T> at_rest() {
  exhaustive::FixedState<R, T> state{};
  state.q[1].raw = 1 << 28;
  return state;
}

}  // namespace

namespace {

template <class S>
void expect_those_without_bounds() {
  exhaustive::Random random(31);
  const auto state = state_of<S, R>(random, 0);
  const auto proved = certified_forward_dynamics_derivatives<S>(state.q, state.qd, state.tau);
  const auto all = forward_dynamics_derivatives<S>(state.q, state.qd, state.tau);
  const auto alone = forward_dynamics_derivatives<S, with_acceleration_by_velocity>(state.q, state.qd, state.tau);
  const auto by_position = forward_dynamics_derivatives<S, with_acceleration_by_position>(state.q, state.qd, state.tau);
  const auto inverse = forward_dynamics_derivatives<S, with_inverse_mass_matrix>(state.q, state.qd, state.tau);
  static_assert(sizeof alone.dqdd_dqd == 9 * sizeof(T) && sizeof alone < sizeof all);
  for (int k = 0; k < 9; ++k) {
    EXPECT_EQ(all.dqdd_dqd.values[k].raw, alone.dqdd_dqd.values[k].raw);
    EXPECT_EQ(all.dqdd_dq.values[k].raw, by_position.dqdd_dq.values[k].raw);
    EXPECT_EQ(all.M_inverse.values[k].raw, inverse.M_inverse.values[k].raw);
    EXPECT_EQ(all.dqdd_dq.values[k].raw, proved.dqdd_dq.values[k].raw);
  }
}

}  // namespace

TEST(ForwardDerivativesInWords, AreThoseWithoutBounds) {
  expect_those_without_bounds<R>();
  expect_those_without_bounds<Scene<R, Gravity, RotorInertia, Looped>>();
}

TEST(ForwardDerivativesInWords, AreZeroBeyondTheLimits) {
  auto state = at_rest();
  state.qd[1].raw = INT32_MAX;
  const auto fast = certified_forward_dynamics_derivatives<R>(state.q, state.qd, state.tau);
  EXPECT_EQ(fast.qdd.status.code, Status::Code::speed_limit);
  EXPECT_EQ(fast.qdd.status.joint, 1);
  for (int k = 0; k < 9; ++k) {
    EXPECT_EQ(fast.M_inverse.values[k].raw | fast.dqdd_dq.values[k].raw | fast.dqdd_dqd.values[k].raw, 0);
    EXPECT_EQ(fast.bound.M_inverse.values[k].raw, INT32_MAX);
    EXPECT_EQ(fast.bound.dqdd_dq.values[k].raw, INT32_MAX);
    EXPECT_EQ(fast.bound.dqdd_dqd.values[k].raw, INT32_MAX);
  }
  EXPECT_EQ(fast.bound.qdd[0].raw, INT32_MAX);
}

// Slopes by position have formats for the declared accelerations; the others do not depend on them.
TEST(ForwardDerivativesInWords, NameAJointThatAcceleratesAtMoreThanItDeclares) {
  auto state = at_rest();
  const auto q = exhaustive::in_double<R, T>(state.q);
  const auto tau = inverse_dynamics<R>(q, Joints<R, double>{}, Joints<R, double>{0.0, 1.1 * 30.0, 0.0});
  for (int i = 0; i < 3; ++i)
    state.tau[i].raw = static_cast<std::int32_t>(std::lrint(std::ldexp(tau[i], state.tau.exponent(i))));
  const auto beyond = certified_forward_dynamics_derivatives<R>(state.q, state.qd, state.tau);
  EXPECT_EQ(beyond.qdd.status.code, Status::Code::acceleration_limit);
  EXPECT_EQ(beyond.qdd.status.joint, 1);
  const auto exact = forward_dynamics_derivatives<R>(q, Joints<R, double>{}, exhaustive::in_double<R>(state.tau));
  share(beyond.M_inverse, beyond.bound.M_inverse, exact.M_inverse);
  share(beyond.dqdd_dqd, beyond.bound.dqdd_dqd, exact.dqdd_dqd);
  for (int k = 0; k < 9; ++k) {
    EXPECT_EQ(beyond.dqdd_dq.values[k].raw, 0);
    EXPECT_EQ(beyond.bound.dqdd_dq.values[k].raw, INT32_MAX);
  }
}

namespace {

template <class S>
void expect_known_errors(double at_least) {
  using Units = detail::DerivativeUnits<S, T>;
  constexpr const auto& units = detail::derivative_units<S, T>;
  exhaustive::Random random(41);
  double mass = 0.0, effort = 0.0, position = 0.0, velocity = 0.0;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const auto state = state_of<S, R>(random, k);
    const auto got = inverse_dynamics_derivatives<S>(state.q, state.qd, state.qdd);
    const auto exact = inverse_dynamics_derivatives<R>(
        exhaustive::in_double<R, T>(state.q), exhaustive::in_double<R>(state.qd), exhaustive::in_double<R>(state.qdd));
    const auto see = [](double& most, double word, double wanted, int exponent, std::int32_t error) {
      const double off = std::fabs(word - std::ldexp(wanted, exponent));
      EXPECT_LE(off, error);
      if (error > 0) most = std::fmax(most, off / error);
    };
    for (int i = 0; i < 3; ++i) {
      const int own = Units::Equations::exponent(i);
      see(effort, std::ldexp(got.tau[i].raw, own - got.tau.exponent(i)), exact.tau[i], own, units.effort_error[i]);
      for (int j = 0; j < 3; ++j) {
        see(mass, got.M(i, j).raw >> units.mass.down[i][j], exact.M(i, j),
            units.mass.scale[i] + own - Units::C::Requests::exponent(j), units.mass.error[i][j]);
        const auto& by_q = Units::sides(by::Position{});
        see(position, got.dtau_dq(i, j).raw >> by_q.down[i][j], exact.dtau_dq(i, j), own + by_q.scale[j],
            units.errors(by::Position{}, j)[i]);
        const auto& by_qd = Units::sides(by::Velocity{});
        see(velocity, got.dtau_dqd(i, j).raw >> by_qd.down[i][j], exact.dtau_dqd(i, j), own + by_qd.scale[j],
            units.errors(by::Velocity{}, j)[i]);
      }
    }
  }
  for (const double nearest : {mass, effort, position, velocity})
    EXPECT_GT(nearest, at_least);
}

}  // namespace

// What words have of M, of the efforts and of the right-hand sides is off by what their bounds are made of.
TEST(ForwardDerivativesInWords, KnowWhatInverseDynamicsIsOff) {
  expect_known_errors<R>(0.1);
  expect_known_errors<Scene<R, Gravity, RotorInertia, Looped>>(0.02);
}

namespace {

/// Jacobians taken at accelerations that lack what one effort makes of them, and what they are held against.
struct OffAccelerations {
  using Solve = detail::DerivativeSolve<R, T>;
  exhaustive::FixedState<R, T> state;
  ForwardDynamicsDerivatives<R, double> exact;
  InverseDynamicsDerivatives<R, T> needs;
  Solve solve;

  OffAccelerations(exhaustive::Random& random, int effort) : state(state_of<R, R>(random, 0)) {
    const auto qdd = exact_at_efforts().qdd;
    for (int i = 0; i < 3; ++i)
      state.qdd[i].raw = static_cast<std::int32_t>(std::lrint(std::ldexp(qdd[i], state.qdd.exponent(i))));
    state.tau[effort].raw += 1 << 21;
    exact = exact_at_efforts();
    needs = inverse_dynamics_derivatives<R>(state.q, state.qd, state.qdd);
    solve.set_inverse(state.q, {});
    solve.hold_against(needs.M);
    solve.correct(state.tau, needs.tau);
    EXPECT_TRUE(solve.known && solve.system.proved);
  }
  ForwardDynamicsDerivatives<R, double> exact_at_efforts() const {
    return forward_dynamics_derivatives<R>(exhaustive::in_double<R, T>(state.q), exhaustive::in_double<R>(state.qd),
                                           exhaustive::in_double<R>(state.tau));
  }
  /// Efforts lack what they leave, and nothing is known of its sign.
  void forget_correction() {
    for (int i = 0; i < 3; ++i) {
      const std::int32_t left = std::abs(state.tau[i].raw - needs.tau[i].raw);
      solve.lack[i] += left << detail::derivative_units<R, T>.effort_up[i];
      solve.correction[i] = 0;
    }
  }
  detail::AccelerationDrift<R, T> drift() const {
    return {solve, [&](const auto& qdd) { return inverse_dynamics_derivatives<R>(state.q, state.qd, qdd); }};
  }
  /// The largest share of a bound.
  double nearest() {
    AccelerationMatrices<R, T>::ByPosition values{}, bounds{};
    solve.write_slopes(by::Position{}, needs.dtau_dq, drift(), values, bounds, true);
    return share(values, bounds, exact.dqdd_dq);
  }
};

}  // namespace

// Jacobians are taken at accelerations that are off: their bounds know by how much.
TEST(ForwardDerivativesInWords, KnowHowFarTheirAccelerationsAreOff) {
  exhaustive::Random random(43);
  double least = 1.0;
  for (int k = 0; k < 200; ++k) {
    OffAccelerations off(random, k % 2);
    least = std::fmin(least, off.nearest());
    for (int i = 0; i < 3; ++i) {
      const double unit = std::ldexp(1.0, -off.state.qdd.exponent(i));
      const double corrected =
          (static_cast<double>(off.state.qdd[i].raw) + static_cast<double>(off.solve.correction[i])) * unit;
      EXPECT_LE(std::fabs(corrected - off.exact.qdd[i]), static_cast<double>(off.solve.bound[i]) * unit);
    }
  }
  EXPECT_GT(least, 0.9) << "what a correction makes of them is known";
}
TEST(ForwardDerivativesInWords, KnowHowFarTheirAccelerationsMayBeOff) {
  exhaustive::Random random(47);
  double least = 1.0;
  for (int k = 0; k < 200; ++k) {
    OffAccelerations off(random, k % 2);
    off.forget_correction();
    least = std::fmin(least, off.nearest());
  }
  EXPECT_GT(least, 0.9) << "of efforts that lack something each has its part";
}

// Jacobians at magnified accelerations have errors and roundings, too, of which a share counts.
TEST(ForwardDerivativesInWords, KnowWhatTheirDriftIsOff) {
  exhaustive::Random random(53);
  OffAccelerations off(random, 1);
  off.forget_correction();
  double share = std::ldexp(1.0, -28);  // nothing is corrected, magnified by 2^29
  for (int m = 0; m < 3; ++m)
    share += std::ldexp(off.solve.lack[m], 2 - off.solve.system.shift[m]);
  ASSERT_GT(share, 1e-3);
  const auto drift = off.drift();
  ASSERT_TRUE(drift.bounded);
  const auto see = [share](std::int64_t found, double least) {
    EXPECT_GE(static_cast<double>(found), share * least);
    EXPECT_LE(static_cast<double>(found), share * least * 1.0001 + 4.0);
  };
  see(drift.noise(1 << 28, 31), (1 << 28) + 3.0);
  see(drift.moved(), 1 << 29);
  see(drift.spread(1 << 20), 2.0 * (1 << 23));
  EXPECT_EQ(drift.noise(1 << 20, 1) - drift.noise(1 << 20, 31), 3) << "a correction's roundings in the finest words";
}

// What is left of the inverse or of the accelerations decides, each by itself.
TEST(ForwardDerivativesInWords, AreAccurateWhereLittleIsLeft) {
  using Solve = detail::DerivativeSolve<R, T>;
  Solve solve;
  solve.drift = Solve::slight_drift, solve.system.spread[2] = Solve::slight_spread;
  EXPECT_TRUE(solve.is_accurate());
  ++solve.system.spread[2];
  EXPECT_FALSE(solve.is_accurate());
  solve.system.spread[2] = 0, ++solve.drift;
  EXPECT_FALSE(solve.is_accurate());
}

// An angle beyond its limits has a word all the same, as in forward dynamics.
TEST(ForwardDerivativesInWords, AreRightAtAnyAngle) {
  auto state = at_rest();
  state.q[1].raw = INT32_MIN + 77;
  const auto got = forward_dynamics_derivatives<R>(state.q, state.qd, state.tau);
  EXPECT_EQ(got.qdd.status.code, Status::Code::position_limit);
  const auto exact = forward_dynamics_derivatives<R>(exhaustive::in_double<R, T>(state.q), {}, {});
  EXPECT_NEAR(real(got.M_inverse, 1, 1), exact.M_inverse(1, 1), 1e-4);
}

// An entry that does not fit its format is 0, and its joint is named.
TEST(ForwardDerivativesInWords, NameAJointWithAnEntryBeyondItsFormat) {
  detail::DerivativeSolve<R, T> solve;
  for (int i = 0; i < 3; ++i)
    solve.system.inverse[i][i] = 1 << 29, solve.system.shift[i] = 29;
  solve.system.shift[1] = 0;
  AccelerationMatrices<R, T>::ByEffort values{}, bounds{};
  solve.write_inverse(values, bounds, true);
  EXPECT_EQ(solve.spilt, 1);
  EXPECT_EQ(values(1, 1).raw, 0);
  EXPECT_EQ(bounds(1, 1).raw, INT32_MAX);
  EXPECT_NE(values(0, 0).raw, 0);
  EXPECT_NE(bounds(0, 0).raw, INT32_MAX);
  const Status named = detail::derivatives_status({}, -1, true, 1);
  EXPECT_EQ(named.code, Status::Code::saturated);
  EXPECT_EQ(named.joint, 1);
  EXPECT_EQ(detail::derivatives_status({}, -1, false, 1).code, Status::Code::inaccurate);
  EXPECT_EQ(detail::derivatives_status({Status::Code::saturated, 2}, 0, true, 1).joint, 2);
}

TEST(ForwardDerivativesInWords, SayWhereWordsOfMAreTooCoarse) {
  exhaustive::Random random(37);
  const auto state = state_of<LightTip, LightTip>(random, 0);
  const auto got = certified_forward_dynamics_derivatives<LightTip>(state.q, state.qd, state.tau);
  const auto exact = forward_dynamics_derivatives<LightTip>(exhaustive::in_double<LightTip, T>(state.q),
                                                            exhaustive::in_double<LightTip>(state.qd),
                                                            exhaustive::in_double<LightTip>(state.tau));
  EXPECT_EQ(got.qdd.status.code, Status::Code::inaccurate);
  share(got.M_inverse, got.bound.M_inverse, exact.M_inverse);
}

namespace {

constexpr auto loaded_chain() {
  auto chain = R::chain;
  chain.payload_limit = payload_limit(2.0, 0.1, 0.02);
  return chain;
}
struct LoadedArm : R {
  static constexpr auto chain = loaded_chain();
};

}  // namespace

TEST(ForwardDerivativesInWords, CarryAPayload) {
  using S = Scene<LoadedArm, Gravity, RotorInertia, Payload>;
  exhaustive::FixedState<S, T> state{};
  state.q[1].raw = 1 << 28;
  Inputs<S, T> in{};
  in.payload.mass.raw = static_cast<std::int32_t>(std::ldexp(1.5, InputFormats<LoadedArm, T>::payload_mass));
  Inputs<S, double> real_in{};
  real_in.payload.mass = 1.5;
  const auto q = exhaustive::in_double<LoadedArm, T>(state.q);
  const auto tau =
      inverse_dynamics<S>(q, Joints<LoadedArm, double>{}, Joints<LoadedArm, double>{0.5, 0.5, 0.1}, real_in);
  for (int i = 0; i < 3; ++i)
    state.tau[i].raw = static_cast<std::int32_t>(std::lrint(std::ldexp(tau[i], state.tau.exponent(i))));
  const auto got = certified_forward_dynamics_derivatives<S>(state.q, state.qd, state.tau, in);
  const auto exact = forward_dynamics_derivatives<S>(q, {}, exhaustive::in_double<LoadedArm>(state.tau), real_in);
  EXPECT_TRUE(got.qdd.status.ok()) << status_text(got.qdd.status);
  share(got.M_inverse, got.bound.M_inverse, exact.M_inverse);
  share(got.dqdd_dq, got.bound.dqdd_dq, exact.dqdd_dq);
  in.payload.mass.raw = INT32_MAX;
  const auto heavy = forward_dynamics_derivatives<S>(state.q, state.qd, state.tau, in);
  EXPECT_EQ(heavy.qdd.status.code, Status::Code::payload_limit);
  EXPECT_EQ(heavy.M_inverse(0, 0).raw, 0);
}
