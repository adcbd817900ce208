// Searches for states that are worse than random ones.
#pragma once

#include <host_sim/figures/exhaustive/fixed_states.hpp>

#include <algorithm>

namespace exhaustive {

/// One number of a state changed: to a corner, anywhere, or by a step of any size.
template <class State>
State neighbour(Random& random, State state, int quantities) {
  const int k = static_cast<int>(random.between(0, quantities - 1));
  const Span span = State::span(k);
  const std::int64_t reach = std::int64_t{1} << random.between(0, 30);
  switch (random.between(0, 3)) {
    case 0:
      state.set(k, corner<State>(random, k));
      break;
    case 1:
      state.set(k, random.between(span.low, span.high));
      break;
    default:
      state.set(k, std::min(span.high, std::max(span.low, state.get(k) + random.between(-reach, reach))));
  }
  return state;
}

/// The largest score that a coordinate search finds: from the best of `steps` / 4 states of the sequence, uphill. The
/// first `quantities` numbers of a state are searched (3 N: the motion; 4 N: the efforts too).
template <class State, class Score>
double climb(std::uint64_t seed, int steps, int quantities, const Score& score) {
  Random random(seed);
  State best = next_state<State>(random, 0);
  double most = score(best);
  const auto consider = [&](const State& state) {
    const double found = score(state);
    if (found >= most) most = found, best = state;
  };
  for (int k = 1; k < steps / 4; ++k)
    consider(next_state<State>(random, static_cast<std::uint64_t>(k)));
  for (int k = steps / 4; k < steps; ++k)
    consider(neighbour(random, best, quantities));
  return most;
}

}  // namespace exhaustive
