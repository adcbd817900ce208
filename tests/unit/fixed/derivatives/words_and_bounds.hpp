// What tests of derivatives of forward dynamics in words share: states, and how much of a bound an error takes.
#pragma once
#include <gtest/gtest.h>
#include <axial/fixed.hpp>
#include <cmath>
#include <host_sim/figures/exhaustive/fixed_states.hpp>
#include <robots/robots.hpp>

using namespace axial;

namespace {

using T = Fixed32;
using R = robots::Scara;

template <class M>
double real(const M& words, int i, int j) {
  return std::ldexp(words(i, j).raw, -words.exponent(i, j));
}

/// A state whose efforts give the accelerations that it asks for.
template <class S, class Exact>
exhaustive::FixedState<S, T> state_of(exhaustive::Random& random, std::uint64_t k) {
  using Robot = robot_of<S>;
  auto state = exhaustive::next_state<exhaustive::FixedState<S, T>>(random, k % 4);
  for (int i = 0; i < joint_count<S>; ++i)
    if (state.turns(i)) state.q[i].raw /= 4;
  const auto tau =
      inverse_dynamics<Exact>(exhaustive::in_double<Robot, T>(state.q), exhaustive::in_double<Robot>(state.qd),
                              exhaustive::in_double<Robot>(state.qdd));
  for (int i = 0; i < joint_count<S>; ++i)
    state.tau[i].raw = static_cast<std::int32_t>(std::lrint(std::ldexp(0.9 * tau[i], state.tau.exponent(i))));
  return state;
}

/// The largest share of a bound that the errors of a matrix are.
template <class Words, class Numbers>
double share(const Words& words, const Words& bounds, const Numbers& exact) {
  double most = 0.0;
  for (int i = 0; i < Words::size; ++i)
    for (int j = 0; j < Words::size; ++j) {
      const double off = std::fabs(real(words, i, j) - exact(i, j)), bound = real(bounds, i, j);
      EXPECT_LE(off, bound + 1e-12) << i << ' ' << j;
      if (bound > 0.0) most = std::fmax(most, off / bound);
    }
  return most;
}

}  // namespace
