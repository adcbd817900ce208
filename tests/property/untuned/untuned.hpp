// Forward dynamics in 32 bits over robots that nobody tuned for: what is asked of states inside the declared limits.
#pragma once

#include <axial/fixed/dynamics/certified_forward_dynamics.hpp>

#include "untuned_reference.hpp"

namespace property {

/// What is asked: errors over the robot's largest declared acceleration, a share of states with any status but ok, and
/// one of states without a certificate.
inline constexpr double allowed_error = 1e-3, allowed_flags = 0.005, allowed_uncertified = 0.02, allowed_bound = 1e-2;

template <class R>
class Untuned : UntunedReference<R> {
  using Base = UntunedReference<R>;
  using T = typename Base::T;
  using Values = typename Base::Values;
  using Base::values, Base::hold_positions, Base::model;

 public:
  using Checked = typename Base::Checked;
  using State = typename Base::State;
  using Base::joints;

  Untuned() {
    for (const auto& link : R::chain.links)
      largest_ = std::fmax(largest_, link.acceleration_limit);
  }

  /// What became of a state: errors and bounds over the largest declared acceleration.
  struct Outcome {
    bool inside = true, flagged = false, uncertified = false;
    std::uint64_t overflows = 0;
    double error = 0.0, certified_error = 0.0, bound = 0.0;
  };
  /// A state's motion, slowed where the robot has not the efforts for it, by the efforts that it takes, as far as they
  /// are declared. It is inside if all of it is.
  Outcome at(State state) const {
    hold_positions(state);
    slow(state);
    const Values q = values(state.q, true), qd = values(state.qd), qdd = values(state.qdd);
    set_efforts(state, inverse_dynamics(model(), q, qd, qdd));
    const Values exact = forward_dynamics(model(), q, qd, values(state.tau));
    Outcome outcome;
    const std::uint64_t before = axial::range_overflows;
    const auto got = axial::forward_dynamics<Checked>(state.q, state.qd, state.tau);
    outcome.overflows = axial::range_overflows - before, outcome.flagged = !got.status.ok();
    const auto proved = axial::certified_forward_dynamics<Checked>(state.q, state.qd, state.tau);
    outcome.uncertified = !answered(proved.status);
    for (int i = 0; i < joints; ++i) {
      outcome.inside = outcome.inside && std::fabs(exact[i]) <= R::chain.links[i].acceleration_limit + 1e-6 * largest_;
      const double unit = axial::detail::power_of_two(-got.exponent(i)) / largest_, wanted = exact[i] / largest_;
      const double bound = proved.bound[i].raw * unit, error = std::fabs(proved[i].raw * unit - wanted);
      outcome.error = std::fmax(outcome.error, std::fabs(got[i].raw * unit - wanted));
      outcome.certified_error = std::fmax(outcome.certified_error, error);
      outcome.bound = std::fmax(outcome.bound, bound);
      if (!outcome.uncertified) {
        EXPECT_LE(error, bound + 1e-11) << "joint " << i;
      }
    }
    return outcome;
  }
  /// Efforts at random, of which only the declared size is known: right to a thousandth of the largest declared
  /// acceleration, though they may drive the robot at thousands of times of it, or it says so.
  bool honest(State state) const {
    hold_positions(state);
    const std::uint64_t before = axial::range_overflows;
    const Values exact = forward_dynamics(model(), values(state.q, true), values(state.qd), values(state.tau));
    const auto got = axial::forward_dynamics<Checked>(state.q, state.qd, state.tau);
    double error = 0.0;
    for (int i = 0; i < joints; ++i) {
      const double found = got[i].raw * axial::detail::power_of_two(-got.exponent(i));
      error = std::fmax(error, std::fabs(found - exact[i]));
    }
    return !answered(got.status) || (axial::range_overflows == before && error <= allowed_error * largest_);
  }

 private:
  double largest_ = 0.0;

  /// A motion that takes more than the declared efforts, drawn or climbed to, is run slower: velocities by a share,
  /// accelerations by its square, so that what weight leaves of each effort carries the rest. It is as it was where
  /// weight alone takes more.
  void slow(State& state) const {
    const Values q = values(state.q, true), zero{};
    const Values resting = inverse_dynamics(model(), q, zero, zero);
    const Values moving = inverse_dynamics(model(), q, values(state.qd), values(state.qdd));
    double share = 1.0;
    for (int i = 0; i < joints; ++i) {
      const double most = R::chain.links[i].effort_limit, more = moving[i] - resting[i];
      if (std::fabs(moving[i]) > most)
        share = std::fmin(share, (more > 0.0 ? most - resting[i] : most + resting[i]) / std::fabs(more));
    }
    if (share >= 1.0 || share <= 0.0) return;
    for (int i = 0; i < joints; ++i) {
      state.qd[i].raw = static_cast<std::int32_t>(state.qd[i].raw * std::sqrt(share));
      state.qdd[i].raw = static_cast<std::int32_t>(state.qdd[i].raw * share);
    }
  }
  static bool answered(const axial::Status& status) {
    return status.ok() || status.code == axial::Status::Code::rescaled;
  }
  static void set_efforts(State& state, const Values& tau) {
    for (int i = 0; i < joints; ++i) {
      const double most =
          std::fmin(R::chain.links[i].effort_limit * axial::detail::power_of_two(state.tau.exponent(i)), 2147483647.0);
      const double raw = tau[i] * axial::detail::power_of_two(state.tau.exponent(i));
      state.tau[i].raw = static_cast<std::int32_t>(std::nearbyint(std::fmax(-most, std::fmin(raw, most))));
    }
  }
};

/// Whether the words of a robot's efforts resolve what its slowest joint's acceleration takes. Where they do not,
/// answers are right, but have no certificate and say so.
template <class R>
inline constexpr bool certifiable = true;

/// Forward dynamics of one robot.
template <class R>
void expect_right_forward_dynamics() {
  const Untuned<R> robot;
  using State = typename Untuned<R>::State;
  const std::uint64_t states = untuned_states(), seed = 7;
  exhaustive::Random random(seed);
  int inside = 0, flagged = 0, uncertified = 0;
  double worst = 0.0, worst_certified = 0.0, worst_bound = 0.0;
  const auto see = [&](const State& state) {
    const auto outcome = robot.at(state);
    if (!outcome.inside) return 0.0;
    EXPECT_EQ(outcome.overflows, 0U);
    ++inside, flagged += outcome.flagged ? 1 : 0, uncertified += outcome.uncertified ? 1 : 0;
    if (!outcome.uncertified) {
      worst_certified = std::fmax(worst_certified, outcome.certified_error);
      worst_bound = std::fmax(worst_bound, outcome.bound);
    }
    if (outcome.flagged) return 0.0;
    worst = std::fmax(worst, outcome.error);
    return outcome.error;
  };
  for (std::uint64_t k = 0; k < states; ++k)
    see(exhaustive::next_state<State>(random, k % 4));
  std::printf("%s, %d joints: %d states, error %.1e, %d with a status; certified %.1e, error %.1e, %d without", R::name,
              State::size, inside, worst, flagged, worst_bound, worst_certified, uncertified);
  EXPECT_LE(flagged, allowed_flags * inside);
  if constexpr (certifiable<R>) {
    EXPECT_LE(uncertified, allowed_uncertified * inside);
    EXPECT_LE(worst_bound, allowed_bound);
    EXPECT_LE(worst_bound, 100.0 * worst_certified);
  }
  const double climbed = exhaustive::climb<State>(seed, 1000, 3 * State::size, see);
  std::printf("; a search finds %.1e\n", climbed);
  EXPECT_LE(worst, allowed_error);
  EXPECT_GT(4 * static_cast<std::uint64_t>(inside), states) << "too few to say anything";
  for (std::uint64_t k = 0; k < states; ++k)
    EXPECT_TRUE(robot.honest(exhaustive::next_state<State>(random, k))) << "state " << k;
}

template <class R>
class UntunedRobot : public testing::Test {};
TYPED_TEST_SUITE_P(UntunedRobot);
TYPED_TEST_P(UntunedRobot, ForwardDynamicsIsRightInsideTheLimitsOrSaysThatItIsNot) {
  expect_right_forward_dynamics<TypeParam>();
}
REGISTER_TYPED_TEST_SUITE_P(UntunedRobot, ForwardDynamicsIsRightInsideTheLimitsOrSaysThatItIsNot);

}  // namespace property
