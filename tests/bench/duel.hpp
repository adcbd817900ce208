// A duel: ours against a peer on the same chain and states. Verified first, then timed in alternating rounds.
#pragma once

#include <bench/contender.hpp>
#include <bench/statistics.hpp>
#include <string>

namespace bench {

struct Duel {
  std::string algorithm, robot, scalar, peer;
  int joints = 0, states = 0;
  double tolerance = 0.0;
  std::unique_ptr<Contender> ours, theirs;
  int slice = 1, cycles = 1;                 ///< states of a round, and how often ours evaluates them: see prepare
  std::vector<double> ratios{};              ///< one a round: the peer's time over ours
  std::vector<double> ours_ns{}, peer_ns{};  ///< of one evaluation, one a round

  std::string name() const { return algorithm + '/' + robot + '/' + scalar + '/' + peer; }
};

/// Largest difference over all states, relative to the largest element of the peer's result; NaN counts as infinite.
double disagreement(Duel& duel);

/// Finds how many states and cycles fill a round.
void prepare(Duel& duel);

/// Times one round, the next slice of the states on both sides (whose order changes every round), and appends it to the
/// duel's samples. Returns its seconds.
double round(Duel& duel);

}  // namespace bench
