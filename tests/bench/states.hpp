// Seeded states of a chain.
#pragma once

#include <bench/contender.hpp>
#include <oracle/random_chain.hpp>
#include <oracle/recursive.hpp>

namespace bench {

constexpr unsigned seed = 2026;

/// Positions, speeds and accelerations up to 2.5, 2 and 4 (rad or m, s), and the efforts that they take.
inline States random_states(const oracle::Chain<double>& chain, int count) {
  oracle::RandomChains random(seed);
  States states;
  states.joints = chain.size(), states.count = count;
  for (int k = 0; k < count; ++k) {
    const auto q = random.vector(chain.size(), 2.5), qd = random.vector(chain.size(), 2.0);
    const auto qdd = random.vector(chain.size(), 4.0);
    const auto tau = oracle::recursive_inverse_dynamics(chain, q, qd, qdd);
    states.q.insert(states.q.end(), q.begin(), q.end());
    states.qd.insert(states.qd.end(), qd.begin(), qd.end());
    states.qdd.insert(states.qdd.end(), qdd.begin(), qdd.end());
    states.tau.insert(states.tau.end(), tau.begin(), tau.end());
  }
  return states;
}

}  // namespace bench
