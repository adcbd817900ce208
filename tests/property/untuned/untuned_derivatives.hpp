// Derivatives of inverse dynamics in 32 bits: nothing overflows, no certified error is exceeded, efforts are those of
// inverse_dynamics() to the bit, or in the looped form, whose formats are of all that is kept, inside their bounds.
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

/// Derivatives of one robot, with what its scene has besides.
template <class R, class... Features>
class UntunedDerivatives : UntunedReference<R, Features...> {
  using Base = UntunedReference<R, Features...>;
  using Base::values, Base::model;

 public:
  using Checked = typename Base::Checked;
  using State = typename Base::State;
  using Base::joints;
  static constexpr auto bound = axial::error_bound<Checked>(axial::algorithm::inverse_dynamics_derivatives);

  static constexpr bool looped = Checked::template has<axial::Looped>;

  SeenMatrix mass, position, velocity;
  std::uint64_t overflows = 0, other_efforts = 0;
  double effort = 0.0, apart = 0.0;  ///< largest shares: of the efforts' bounds, of both forms' bounds together

  /// Compares at one state; the largest share there.
  double see(State state) {
    Base::hold_positions(state);
    const std::uint64_t before = axial::range_overflows;
    const auto got = axial::inverse_dynamics_derivatives<Checked>(state.q, state.qd, state.qdd);
    const auto efforts = axial::inverse_dynamics<Checked>(state.q, state.qd, state.qdd);
    overflows += axial::range_overflows - before;
    const auto exact_efforts = inverse_dynamics(model(), values(state.q, true), values(state.qd), values(state.qdd));
    for (int i = 0; i < joints; ++i) {
      other_efforts += !looped && got.tau[i].raw != efforts[i].raw ? 1 : 0;
      const double off = std::fabs(Base::real(got.tau, i) - exact_efforts[i]);
      effort = std::fmax(effort, off / (bound.tau[i] + 1e-13));
    }
    if constexpr (looped) see_unrolled(state, got);
    const auto exact =
        inverse_dynamics_derivatives(model(), values(state.q, true), values(state.qd), values(state.qdd));
    return std::fmax(mass.see(got.M, exact.M, bound.M, joints),
                     std::fmax(position.see(got.dtau_dq, exact.dtau_dq, bound.dtau_dq, joints),
                               velocity.see(got.dtau_dqd, exact.dtau_dqd, bound.dtau_dqd, joints)));
  }

 private:
  template <class Results>
  void see_unrolled(const State& state, const Results& got) {
    using Unrolled = axial::Scene<R, axial::Gravity, axial::RotorInertia>;
    static constexpr auto other = axial::error_bound<Unrolled>(axial::algorithm::inverse_dynamics_derivatives);
    const auto unrolled = axial::inverse_dynamics_derivatives<Unrolled>(state.q, state.qd, state.qdd);
    const auto compare = [&](const auto& a, const auto& b, const auto& of_a, const auto& of_b) {
      for (int i = 0; i < joints; ++i)
        for (int j = 0; j < joints; ++j) {
          EXPECT_EQ(a.exponent(i, j), b.exponent(i, j));
          const double off =
              std::fabs(1.0 * a(i, j).raw - b(i, j).raw) * axial::detail::power_of_two(-a.exponent(i, j));
          apart = std::fmax(apart, off / (of_a(i, j) + of_b(i, j) + 1e-300));
        }
    };
    compare(got.M, unrolled.M, bound.M, other.M);
    compare(got.dtau_dq, unrolled.dtau_dq, bound.dtau_dq, other.dtau_dq);
    compare(got.dtau_dqd, unrolled.dtau_dqd, bound.dtau_dqd, other.dtau_dqd);
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
template <class R, class... Features>
void expect_derivatives_inside_their_bounds() {
  using Derivatives = UntunedDerivatives<R, Features...>;
  Derivatives robot;
  using State = typename Derivatives::State;
  constexpr const auto& bound = Derivatives::bound;
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
  EXPECT_LE(robot.effort, 1.0);
  EXPECT_LE(robot.apart, 1.0);
}

}  // namespace property
