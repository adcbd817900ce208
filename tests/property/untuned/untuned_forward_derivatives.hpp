// Derivatives of forward dynamics in 32 bits: nothing overflows, no proved bound is exceeded, and a bound of an answer
// with ok says something.
#pragma once

#include "untuned_reference.hpp"

namespace property {

/// What was seen of one matrix: the largest entry, error and bound of answers with ok, and the largest share of a
/// bound.
struct SeenSlopes {
  double largest = 0.0, error = 0.0, bound = 0.0, share = 0.0;

  /// Compares one at a state; an entry without a bound says nothing.
  template <class Words, class Exact>
  double see(const Words& words, const Words& bounds, const Exact& exact, bool ok) {
    double most = 0.0;
    for (int i = 0; i < Words::size; ++i)
      for (int j = 0; j < Words::size; ++j) {
        if (bounds(i, j).raw == INT32_MAX) {
          EXPECT_FALSE(ok) << "an answer with ok has bounds";
          continue;
        }
        const double unit = axial::detail::power_of_two(-words.exponent(i, j));
        const double off = std::fabs(words(i, j).raw * unit - exact(i, j)), within = bounds(i, j).raw * unit;
        const double reference = 1e-13 * std::fabs(exact(i, j)) + 1e-16;  // what is zero by type is zero in words
        most = std::fmax(most, off > reference ? off / (within + reference) : 0.0);
        if (!ok) continue;
        largest = std::fmax(largest, std::fabs(exact(i, j))), error = std::fmax(error, off);
        bound = std::fmax(bound, within);
      }
    share = std::fmax(share, most);
    return most;
  }
};

/// Derivatives of one robot, with what its scene has besides.
template <class R, class... Features>
class UntunedForwardDerivatives : UntunedReference<R, Features...> {
  using Base = UntunedReference<R, Features...>;
  using Base::values, Base::model;

 public:
  using Checked = typename Base::Checked;
  using State = typename Base::State;
  using Base::joints;

  SeenSlopes inverse, position, velocity;
  std::uint64_t overflows = 0, states = 0, answers = 0;
  std::uint64_t inside = 0, refused = 0;  ///< motions within all limits; those of them without an answer

  /// Compares at one state, driven as its accelerations need, or as it says; the largest share of a bound there.
  double see(State state, bool needed) {
    Base::hold_positions(state);
    const auto q = values(state.q, true), qd = values(state.qd);
    if (needed) {
      const auto tau = inverse_dynamics(model(), q, qd, values(state.qdd));
      for (int i = 0; i < joints; ++i) {
        const double raw = std::ldexp(tau[i], state.tau.exponent(i));
        state.tau[i].raw =
            static_cast<std::int32_t>(std::lrint(std::fmax(-0x1.fffffp30, std::fmin(raw, 0x1.fffffp30))));
      }
    }
    const bool within = needed && is_within(state, qd);
    const std::uint64_t before = axial::range_overflows;
    const auto got = axial::certified_forward_dynamics_derivatives<Checked>(state.q, state.qd, state.tau);
    overflows += axial::range_overflows - before;
    const bool ok = got.qdd.status.ok();
    ++states, answers += ok ? 1 : 0;
    inside += within ? 1 : 0, refused += within && !ok ? 1 : 0;
    const auto exact = forward_dynamics_derivatives(model(), q, qd, values(state.tau));
    return std::fmax(inverse.see(got.M_inverse, got.bound.M_inverse, exact.M_inverse, ok),
                     std::fmax(position.see(got.dqdd_dq, got.bound.dqdd_dq, exact.dqdd_dq, ok),
                               velocity.see(got.dqdd_dqd, got.bound.dqdd_dqd, exact.dqdd_dqd, ok)));
  }

 private:
  template <class Values>
  static bool is_within(const State& state, const Values& qd) {
    bool all = true;
    for (int i = 0; i < joints; ++i) {
      const auto& link = R::chain.links[i];
      const double q = values(state.q, true)[i], tau = std::ldexp(state.tau[i].raw, -state.tau.exponent(i));
      all = all && q >= link.position_min && q <= link.position_max && std::fabs(qd[i]) <= link.speed_limit &&
            std::fabs(tau) <= link.effort_limit;
    }
    return all;
  }
};

/// A matrix is inside its bounds; of answers with ok it is right to `right` of its largest entry.
inline void expect_slopes_inside(const char* name, const SeenSlopes& seen, double right) {
  std::printf("; %s up to %.3g, error %.1e, proved within %.1e, at most %.2f of a bound", name, seen.largest,
              seen.error, seen.bound, seen.share);
  EXPECT_LE(seen.share, 1.0) << name;
  EXPECT_LE(seen.error, right * seen.largest + 1e-12) << name;
}

/// Of one robot, whose answers with ok are right to `right` of the largest entry; of motions inside all limits at most
/// the share `refused` has no answer. Bounds of d qdd / d q are at most
/// `loose` times the largest error.
template <class R, class... Features>
std::uint64_t expect_forward_derivatives_inside_their_bounds(double right = 1e-4, double refused = 0.02,
                                                             double loose = 30.0) {
  using State = typename UntunedForwardDerivatives<R, Features...>::State;
  UntunedForwardDerivatives<R, Features...> robot;
  const std::uint64_t states = untuned_states(), seed = 17;
  exhaustive::Random random(seed);
  for (std::uint64_t k = 0; k < states; ++k)
    robot.see(exhaustive::next_state<State>(random, k % 4), k % 8 != 7);
  exhaustive::climb<State>(seed, static_cast<int>(states / 10), 3 * State::size,
                           [&](const State& state) { return robot.see(state, true); });
  std::printf("%s, %d joints: %llu states, %llu with ok", R::name, State::size,
              static_cast<unsigned long long>(robot.states), static_cast<unsigned long long>(robot.answers));
  expect_slopes_inside("M^-1", robot.inverse, right);
  expect_slopes_inside("d qdd / d q", robot.position, right);
  expect_slopes_inside("d qdd / d qd", robot.velocity, right);
  std::printf("\n");
  EXPECT_LE(robot.position.bound, loose * robot.position.error + 1e-12) << "d qdd / d q";
  EXPECT_EQ(robot.overflows, 0U);
  std::printf("%s: %llu motions inside all limits, %llu refused\n", R::name,
              static_cast<unsigned long long>(robot.inside), static_cast<unsigned long long>(robot.refused));
  EXPECT_LE(static_cast<double>(robot.refused), refused * static_cast<double>(robot.inside))
      << "motions inside all limits without an answer";
  return 100 * robot.answers / robot.states;
}

template <class R>
class ForwardDerivedRobots : public testing::Test {};
TYPED_TEST_SUITE_P(ForwardDerivedRobots);
TYPED_TEST_P(ForwardDerivedRobots, StayInsideTheirProvedBounds) {
  EXPECT_GT(expect_forward_derivatives_inside_their_bounds<TypeParam>(), 10U) << "hardly any answer is ok";
}
REGISTER_TYPED_TEST_SUITE_P(ForwardDerivedRobots, StayInsideTheirProvedBounds);

}  // namespace property
