// Derivatives of inverse dynamics in 32 bits: nothing overflows, no certified error is exceeded, efforts are those of
// inverse_dynamics() to the bit.
#pragma once

#include "untuned_reference.hpp"

namespace property {

/// The largest error over its certified one in each matrix.
template <class R>
class UntunedDerivatives : UntunedReference<R> {
  using Base = UntunedReference<R>;
  using Base::values, Base::model;

 public:
  using Checked = typename Base::Checked;
  using State = typename Base::State;
  using Base::joints;
  static constexpr auto bound = axial::error_bound<Checked>(axial::algorithm::inverse_dynamics_derivatives);

  double mass = 0.0, position = 0.0, velocity = 0.0;   ///< largest shares of the certified errors
  double largest_position = 0.0, largest_error = 0.0;  ///< of d tau / d q
  std::uint64_t overflows = 0, other_efforts = 0;

  /// Compares at one state; the largest share there.
  double see(State state) {
    Base::hold_positions(state);
    const std::uint64_t before = axial::range_overflows;
    const auto got = axial::inverse_dynamics_derivatives<Checked>(state.q, state.qd, state.qdd);
    const auto efforts = axial::inverse_dynamics<Checked>(state.q, state.qd, state.qdd);
    overflows += axial::range_overflows - before;
    const auto exact =
        inverse_dynamics_derivatives(model(), values(state.q, true), values(state.qd), values(state.qdd));
    double most = 0.0;
    for (int i = 0; i < joints; ++i) {
      other_efforts += got.tau[i].raw != efforts[i].raw ? 1 : 0;
      for (int j = 0; j < joints; ++j) {
        note(most, mass, far(got.M, exact.M, i, j), bound.M(i, j));
        const double error = far(got.dtau_dq, exact.dtau_dq, i, j);
        largest_error = std::fmax(largest_error, error);
        largest_position = std::fmax(largest_position, std::fabs(exact.dtau_dq(i, j)));
        note(most, position, error, bound.dtau_dq(i, j));
        note(most, velocity, far(got.dtau_dqd, exact.dtau_dqd, i, j), bound.dtau_dqd(i, j));
      }
    }
    return most;
  }

 private:
  template <class Words, class Exact>
  static double far(const Words& words, const Exact& exact, int i, int j) {
    return std::fabs(words(i, j).raw * axial::detail::power_of_two(-words.exponent(i, j)) - exact(i, j));
  }
  // An entry that is zero by type is zero in the reference to its rounding.
  void note(double& most, double& nearest, double error, double within) const {
    const double share = within > 0.0 ? error / within : error > 1e-12 * largest_position ? HUGE_VAL : 0.0;
    nearest = std::fmax(nearest, share), most = std::fmax(most, share);
  }
};

/// Of one robot.
template <class R>
void expect_derivatives_inside_their_bounds() {
  UntunedDerivatives<R> robot;
  using State = typename UntunedDerivatives<R>::State;
  const std::uint64_t states = untuned_states(), seed = 13;
  exhaustive::Random random(seed);
  for (std::uint64_t k = 0; k < states; ++k)
    robot.see(exhaustive::next_state<State>(random, k % 4));
  exhaustive::climb<State>(seed, static_cast<int>(states / 10), 3 * State::size,
                           [&](const State& state) { return robot.see(state); });
  double certified = 0.0;
  for (const double error : UntunedDerivatives<R>::bound.dtau_dq.values)
    certified = std::fmax(certified, error);
  std::printf(
      "%s, %d joints: %llu states; of their certified errors M %.2f, d tau / d q %.2f, d tau / d qd %.2f; "
      "d tau / d q up to %.3g, certified within %.1e, error %.1e\n",
      R::name, State::size, static_cast<unsigned long long>(states), robot.mass, robot.position, robot.velocity,
      robot.largest_position, certified, robot.largest_error);
  for (const double share : {robot.mass, robot.position, robot.velocity}) {
    EXPECT_LE(share, 1.0);
    EXPECT_TRUE(share >= 0.02 || share == 0.0) << "a bound as loose as this says little";
  }
  EXPECT_EQ(robot.overflows, 0U);
  EXPECT_EQ(robot.other_efforts, 0U);
}

template <class R>
class DerivedRobots : public testing::Test {};
TYPED_TEST_SUITE_P(DerivedRobots);
TYPED_TEST_P(DerivedRobots, StayInsideTheirCertifiedErrors) { expect_derivatives_inside_their_bounds<TypeParam>(); }
REGISTER_TYPED_TEST_SUITE_P(DerivedRobots, StayInsideTheirCertifiedErrors);

}  // namespace property
