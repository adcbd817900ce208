// Derivatives of forward dynamics in fixed point, and their bounds: what is proved holds, and is not loose.
#include <unit/fixed/dynamics/light_tip.hpp>

#include "words_and_bounds.hpp"

namespace {

template <class S, class Exact>
void expect_bounded(int at_least, double least_share = 0.01) {
  using Robot = robot_of<S>;
  exhaustive::Random random(29);
  range_overflows = 0;
  double nearest = 0.0;
  int answered = 0;
  for (std::uint64_t k = 0; k < 400; ++k) {
    const auto state = state_of<S, Exact>(random, k);
    const auto got = certified_forward_dynamics_derivatives<S>(state.q, state.qd, state.tau);
    if (!got.qdd.status.ok()) continue;
    ++answered;
    const auto exact = forward_dynamics_derivatives<Exact>(exhaustive::in_double<Robot, T>(state.q),
                                                           exhaustive::in_double<Robot>(state.qd),
                                                           exhaustive::in_double<Robot>(state.tau));
    nearest = std::fmax(nearest, share(got.M_inverse, got.bound.M_inverse, exact.M_inverse));
    share(got.dqdd_dq, got.bound.dqdd_dq, exact.dqdd_dq);
    share(got.dqdd_dqd, got.bound.dqdd_dqd, exact.dqdd_dqd);
    for (int i = 0; i < joint_count<S>; ++i) {
      const double unit = std::ldexp(1.0, -got.qdd.exponent(i));
      EXPECT_LE(std::fabs(got.qdd[i].raw * unit - exact.qdd[i]), got.bound.qdd[i].raw * unit) << i;
    }
  }
  EXPECT_EQ(range_overflows, 0U);
  EXPECT_GT(answered, at_least);
  EXPECT_GT(nearest, least_share) << "bounds as loose as this say little";
}

// Two arms on one column.
struct Fork {
  static constexpr auto chain =
      axial::chain(gravity(0.0, 0.0, -9.81), joint(4.0, 0.4), joint(2.0, 0.3).a(0.2).alpha_deg(90).parent(0),
                   joint(1.0, 0.3).a(-0.2).alpha_deg(90).parent(0));
};

}  // namespace

TEST(ForwardDerivativesInWords, AreInsideTheirBounds) {
  expect_bounded<Scene<R, Gravity, RotorInertia, RangeCheck>, R>(200);
  expect_bounded<Scene<R, Gravity, RotorInertia, Friction, RangeCheck, HighWord>,
                 Scene<R, Gravity, RotorInertia, Friction>>(100);
  expect_bounded<Scene<Fork, Gravity, RotorInertia, RangeCheck, RoundDown>, Fork>(100);
}

// By one step for all links M is eliminated in words. A wrist of an arm of kilograms has 6e-4 kg m^2 there.
TEST(ForwardDerivativesInWords, AreInsideTheirBoundsInLoops) {
  expect_bounded<Scene<R, Gravity, RotorInertia, Looped, RangeCheck>, R>(200, 0.005);
  expect_bounded<Scene<R, Gravity, RotorInertia, Friction, Looped, RangeCheck, HighWord>,
                 Scene<R, Gravity, RotorInertia, Friction>>(100, 0.005);
  expect_bounded<Scene<Fork, Gravity, RotorInertia, Looped, RangeCheck, RoundDown>, Fork>(100, 0.005);
  expect_bounded<Scene<robots::Indy7, Gravity, RotorInertia, Looped, RangeCheck>, robots::Indy7>(10, 0.005);
}
