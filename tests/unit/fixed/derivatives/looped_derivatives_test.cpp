// Derivatives of inverse dynamics in words by one step for all links: arms whose links could hardly differ more.
#include <gtest/gtest.h>
#include <axial/fixed.hpp>
#include <cmath>
#include <host_sim/figures/exhaustive/fixed_states.hpp>

using namespace axial;

namespace {

using T = Fixed32;

// Turns fast about a short offset, so that a slide's axis turns faster, rad/s, than any origin moves, m/s.
struct Turret {
  static constexpr auto chain = axial::chain(
      gravity(0.0, 0.0, -9.81),
      revolute().mass(0.04).inertia_com(1e-5, 1e-5, 2e-5, 0, 0, 0).speed_limit(200.0).acceleration_limit(900.0),
      revolute()
          .alpha_deg(90)
          .mass(0.02)
          .com(0.01, 0, 0.002)
          .inertia_com(1e-5, 2e-5, 1e-5, 0, 0, 0)
          .speed_limit(160.0)
          .acceleration_limit(800.0),
      prismatic()
          .a(0.05)
          .alpha_deg(90)
          .mass(0.1)
          .com(0, 0.001, 0.003)
          .inertia_com(1e-5, 1e-5, 1e-5, 0, 0, 0)
          .position_limits(-0.005, 0.005)
          .speed_limit(0.3)
          .acceleration_limit(5.0));
};
// A ship's crane with a watch at its tip: entries of M from 1e5 to 1e-11 kg m^2.
struct Uneven {
  static constexpr auto chain = axial::chain(gravity(0.0, 0.0, -9.81),
                                             revolute()
                                                 .mass(4000.0)
                                                 .accept(as_published)
                                                 .com(2.0, 0, 0)
                                                 .inertia_com(900.0, 900.0, 900.0, 0, 0, 0)
                                                 .speed_limit(1.0)
                                                 .acceleration_limit(2.0)
                                                 .viscous(50.0),
                                             revolute()
                                                 .alpha_deg(90)
                                                 .mass(0.4)
                                                 .com(0.02, 0, 0)
                                                 .inertia_com(1e-5, 1e-5, 1e-5, 0, 0, 0)
                                                 .speed_limit(2.0)
                                                 .acceleration_limit(4.0)
                                                 .viscous(1e-4),
                                             revolute()
                                                 .a(0.01)
                                                 .alpha_deg(-90)
                                                 .mass(1e-5)
                                                 .com(1e-3, 0, 0)
                                                 .inertia_com(1e-12, 1e-12, 1e-12, 0, 0, 0)
                                                 .speed_limit(2.0)
                                                 .acceleration_limit(4.0)
                                                 .viscous(1e-9));
};
// Fast slides on slides, which move farther than they reach and turn nothing: each mass has room in a word that their
// sum has not, and a slide's row, a momentum, is larger than any moment.
constexpr Link slide(double mass) {
  return prismatic()
      .mass(mass)
      .inertia_com(0.01, 0.01, 0.01)
      .position_limits(-0.01, 0.01)
      .speed_limit(20.0)
      .acceleration_limit(5.0);
}
struct Gantry {
  static constexpr auto chain = axial::chain(gravity(0.0, 0.0, -9.81), slide(0.9), slide(0.8).alpha_deg(90),
                                             slide(0.7).theta_deg(90).alpha_deg(90));
};
// One joint, whose unit force passes no screw.
struct Lone {
  static constexpr auto chain = axial::chain(gravity(0.0, -9.81, 0.0), revolute()
                                                                           .mass(1.0)
                                                                           .com(0.1, 0, 0)
                                                                           .inertia_com(0.02, 0.03, 0.04, 0, 0, 0)
                                                                           .rotor_inertia(1e-4, 30.0)
                                                                           .speed_limit(3.0)
                                                                           .acceleration_limit(9.0));
};

// A table whose only inertia is 1, a type.
struct Flywheel {
  static constexpr auto chain =
      axial::chain(gravity(0.0, -9.81, 0.0),
                   revolute().mass(1.0).inertia_com(1.0, 1.0, 1.0).speed_limit(3.0).acceleration_limit(9.0));
};

// Largest shares of certified errors, matrix by matrix and of the efforts, over states inside the limits.
struct Shares {
  double mass = 0.0, position = 0.0, velocity = 0.0, effort = 0.0;
};
template <class Words, class Exact, class Bound>
double share(const Words& words, const Exact& exact, const Bound& within) {
  double most = 0.0;
  for (int i = 0; i < Exact::size; ++i)
    for (int j = 0; j < Exact::size; ++j) {
      const double off = std::fabs(std::ldexp(words(i, j).raw, -words.exponent(i, j)) - exact(i, j));
      EXPECT_LE(off, within(i, j) + 1e-12 * std::fabs(exact(i, j))) << i << ' ' << j;
      if (within(i, j) > 0.0) most = std::fmax(most, off / within(i, j));
    }
  return most;
}
template <class R>
Shares expect_inside() {
  using Exact = Scene<R, Gravity, RotorInertia, Friction>;
  using S = Scene<R, Gravity, RotorInertia, Friction, Looped, RangeCheck>;
  constexpr auto bound = error_bound<S>(algorithm::inverse_dynamics_derivatives);
  Shares shares;
  exhaustive::Random random(37);
  range_overflows = 0;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const auto state = exhaustive::next_state<exhaustive::FixedState<S, T>>(random, k % 4);
    const auto got = inverse_dynamics_derivatives<S>(state.q, state.qd, state.qdd);
    const auto exact = inverse_dynamics_derivatives<Exact>(
        exhaustive::in_double<R, T>(state.q), exhaustive::in_double<R>(state.qd), exhaustive::in_double<R>(state.qdd));
    shares.mass = std::fmax(shares.mass, share(got.M, exact.M, bound.M));
    shares.position = std::fmax(shares.position, share(got.dtau_dq, exact.dtau_dq, bound.dtau_dq));
    shares.velocity = std::fmax(shares.velocity, share(got.dtau_dqd, exact.dtau_dqd, bound.dtau_dqd));
    for (int i = 0; i < joint_count<S>; ++i) {
      const double off = std::fabs(std::ldexp(got.tau[i].raw, -got.tau.exponent(i)) - exact.tau[i]);
      EXPECT_LE(off, bound.tau[i]) << i;
      shares.effort = std::fmax(shares.effort, off / bound.tau[i]);
    }
  }
  EXPECT_EQ(range_overflows, 0U);
  std::printf("shares of bounds: M %.2f, by q %.2f, by qd %.2f, tau %.2f\n", shares.mass, shares.position,
              shares.velocity, shares.effort);
  return shares;
}

}  // namespace

TEST(LoopedDerivativesInWords, HaveRoomForASlideThatTurnsFast) {
  const Shares s = expect_inside<Turret>();
  EXPECT_GT(std::fmin(std::fmin(s.mass, s.position), s.velocity), 0.02) << "bounds as loose as this say little";
}
TEST(LoopedDerivativesInWords, HoldEntriesOfAnySize) {
  const Shares s = expect_inside<Uneven>();
  EXPECT_GT(std::fmin(std::fmin(s.mass, s.position), s.velocity), 0.02) << "bounds as loose as this say little";
}
TEST(LoopedDerivativesInWords, AddMassesOfSlides) {
  expect_inside<Gantry>();
  using S = Scene<Gantry, Gravity, Looped, RangeCheck>;
  range_overflows = 0;
  const auto mass = mass_matrix<S>(Positions<Gantry, T>{});
  EXPECT_EQ(range_overflows, 0U);
  EXPECT_NEAR(std::ldexp(mass(0, 0).raw, -mass.exponent(0, 0)), 2.4, error_bound<S>(algorithm::mass_matrix)[0]);
}
TEST(LoopedDerivativesInWords, KnowAJointAlone) {
  EXPECT_GT(expect_inside<Lone>().mass, 0.02);
  expect_inside<Flywheel>();
}

// A word moves up exactly, is held where it would leave its word, and says nothing beyond thirty doublings.
TEST(LoopedDerivativesInWords, DoubleWords) {
  using S = Arithmetic<std::int32_t, true, false>;
  EXPECT_EQ(axial::detail::doubled_word<S>(-5, 3), -40);
  EXPECT_EQ(axial::detail::doubled_word<S>(7, 0), 7);
  EXPECT_EQ(axial::detail::doubled_word<S>(1, 30), 1 << 30);
  EXPECT_EQ(axial::detail::doubled_word<S>(3, 30), INT32_MAX);
  EXPECT_EQ(axial::detail::doubled_word<S>(-(1 << 30), 9), -INT32_MAX);
  EXPECT_EQ(axial::detail::doubled_word<S>(1000, 31), 0);
  using Short = Arithmetic<std::int16_t, true, false>;
  EXPECT_EQ(axial::detail::doubled_word<Short>(3, 13), 3 << 13);
  EXPECT_EQ(axial::detail::doubled_word<Short>(-5, 13), -INT16_MAX);
}
TEST(LoopedDerivativesInWords, AddWhatFitsNoFormatOfItsTerms) {
  using S = Arithmetic<std::int32_t, true, false, true>;
  range_overflows = 0;
  const Fx<20, S> most{INT32_MAX - 1};
  EXPECT_EQ(round_to<19>(unrounded_sum(most, most)).raw, INT32_MAX - 1);
  EXPECT_EQ(range_overflows, 0U);
}

namespace {

// Exponents of a matrix, the least of them not the first.
struct Staggered {
  static constexpr int mass(int i, int j) { return 25 - i - j; }
  static constexpr int position(int i, int j) { return 25 - i - j; }
  static constexpr int velocity(int i, int j) { return 40 * (1 - i * j) + 9; }
};

}  // namespace

// By one step for all entries each is rounded at the least exponent; what is finer by more than thirty is 0.
TEST(LoopedDerivativesInWords, AreCertifiedAtTheLeastExponent) {
  constexpr WordRounding r{32, true, false, 0.0};
  const auto word = bounds::word_of({1.0, 0.25}, 60);
  for (const bool shared : {false, true}) {
    bounds::DerivativeBounds<2> all;
    bounds::BoundedEntries<2, Staggered> entries{r, shared, Staggered{}, all};
    entries.mass(1, 0, word), entries.position(0, 0, word), entries.velocity(0, 1, word);
    EXPECT_DOUBLE_EQ(all.mass(0, 1).error, 0.25 + std::ldexp(0.5, shared ? -23 : -24));
    EXPECT_DOUBLE_EQ(all.position(0, 0).error, 0.25 + std::ldexp(0.5, shared ? -23 : -25));
    EXPECT_DOUBLE_EQ(all.velocity(0, 1).error, shared ? 1.0 : 0.25 + std::ldexp(0.5, -49));
  }
}
