// Derivatives of inverse dynamics in 32 bits: nothing overflows, no certified error is exceeded, efforts are those of
// inverse_dynamics() to the bit.
#pragma once

#include "untuned_reference.hpp"

namespace property {

/// What was seen of one matrix: the largest share of a certified error, entry and error.
struct SeenMatrix {
  double share = 0.0, largest = 0.0, error = 0.0;

  /// Compares one; an entry that is zero by type is zero in the reference to its rounding.
  template <class Words, class Exact, class Bound>
  double see(const Words& words, const Exact& exact, const Bound& within, int joints) {
    double most = 0.0;
    for (int i = 0; i < joints; ++i)
      for (int j = 0; j < joints; ++j) {
        const double found = words(i, j).raw * axial::detail::power_of_two(-words.exponent(i, j));
        const double off = std::fabs(found - exact(i, j));
        largest = std::fmax(largest, std::fabs(exact(i, j))), error = std::fmax(error, off);
        most = std::fmax(most, within(i, j) > 0.0 ? off / within(i, j) : off > 1e-12 * largest ? HUGE_VAL : 0.0);
      }
    share = std::fmax(share, most);
    return most;
  }
};

/// Derivatives of one robot.
template <class R>
class UntunedDerivatives : UntunedReference<R> {
  using Base = UntunedReference<R>;
  using Base::values, Base::model;

 public:
  using Checked = typename Base::Checked;
  using State = typename Base::State;
  using Base::joints;
  static constexpr auto bound = axial::error_bound<Checked>(axial::algorithm::inverse_dynamics_derivatives);

  SeenMatrix mass, position, velocity;
  std::uint64_t overflows = 0, other_efforts = 0;

  /// Compares at one state; the largest share there.
  double see(State state) {
    Base::hold_positions(state);
    const std::uint64_t before = axial::range_overflows;
    const auto got = axial::inverse_dynamics_derivatives<Checked>(state.q, state.qd, state.qdd);
    const auto efforts = axial::inverse_dynamics<Checked>(state.q, state.qd, state.qdd);
    overflows += axial::range_overflows - before;
    for (int i = 0; i < joints; ++i)
      other_efforts += got.tau[i].raw != efforts[i].raw ? 1 : 0;
    const auto exact =
        inverse_dynamics_derivatives(model(), values(state.q, true), values(state.qd), values(state.qdd));
    return std::fmax(mass.see(got.M, exact.M, bound.M, joints),
                     std::fmax(position.see(got.dtau_dq, exact.dtau_dq, bound.dtau_dq, joints),
                               velocity.see(got.dtau_dqd, exact.dtau_dqd, bound.dtau_dqd, joints)));
  }
};

/// A matrix is inside its bounds, and they say something: the largest certified error is no thousand times the largest
/// found.
template <class Bound>
void expect_inside(const char* name, const SeenMatrix& seen, const Bound& bound) {
  double certified = 0.0;
  for (const double error : bound.values)
    certified = std::fmax(certified, error);
  std::printf("; %s up to %.3g, certified within %.1e, error %.1e, at most %.2f of its bound", name, seen.largest,
              certified, seen.error, seen.share);
  EXPECT_LE(seen.share, 1.0) << name;
  if (seen.largest > 1e-12) {  // or it is zero but for the reference's rounding
    EXPECT_GE(seen.share, 0.02) << name;
    EXPECT_LE(certified, 1000.0 * seen.error) << name;
  }
}

/// Of one robot.
template <class R>
void expect_derivatives_inside_their_bounds() {
  UntunedDerivatives<R> robot;
  using State = typename UntunedDerivatives<R>::State;
  constexpr const auto& bound = UntunedDerivatives<R>::bound;
  const std::uint64_t states = untuned_states(), seed = 13;
  exhaustive::Random random(seed);
  for (std::uint64_t k = 0; k < states; ++k)
    robot.see(exhaustive::next_state<State>(random, k % 4));
  exhaustive::climb<State>(seed, static_cast<int>(states / 10), 3 * State::size,
                           [&](const State& state) { return robot.see(state); });
  std::printf("%s, %d joints: %llu states", R::name, State::size, static_cast<unsigned long long>(states));
  expect_inside("M", robot.mass, bound.M);
  expect_inside("d tau / d q", robot.position, bound.dtau_dq);
  expect_inside("d tau / d qd", robot.velocity, bound.dtau_dqd);
  std::printf("\n");
  EXPECT_EQ(robot.overflows, 0U);
  EXPECT_EQ(robot.other_efforts, 0U);
}

template <class R>
class DerivedRobots : public testing::Test {};
TYPED_TEST_SUITE_P(DerivedRobots);
TYPED_TEST_P(DerivedRobots, StayInsideTheirCertifiedErrors) { expect_derivatives_inside_their_bounds<TypeParam>(); }
REGISTER_TYPED_TEST_SUITE_P(DerivedRobots, StayInsideTheirCertifiedErrors);

}  // namespace property
