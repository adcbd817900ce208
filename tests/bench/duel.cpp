#include <algorithm>
#include <bench/duel.hpp>
#include <chrono>
#include <cmath>
#include <oracle/compare.hpp>

namespace bench {
namespace {

// A side of a round lasts a thousand times what reading the clock takes, and much less than what makes a processor
// switch its wide vector units off (some 0.6 ms without them): they wake up at a quarter of their speed.
constexpr double side = 50e-6;

// The first cycle is not timed: it brings code and states back into the caches, which the other side has filled.
double seconds_of(Contender& contender, int first, int count, int cycles) {
  contender.run(first, count);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < cycles; ++i)
    contender.run(first, count);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

int times(double each, int least, int most) {
  return std::clamp(static_cast<int>(std::lround(side / each)), least, most);
}

// DART does not compute again what a state that it already has would give.
constexpr int fewest_states = 2;

}  // namespace

double disagreement(Duel& duel) {
  double worst = 0.0;
  for (int state = 0; state < duel.states; ++state)
    worst = std::max(worst, oracle::relative_error(duel.ours->result(state), duel.theirs->result(state)));
  return worst;
}

void prepare(Duel& duel) {
  duel.slice = times(seconds_of(*duel.theirs, 0, fewest_states, 3) / 3 / fewest_states, fewest_states, duel.states);
  seconds_of(*duel.ours, 0, duel.slice, 3);
  duel.cycles = times(seconds_of(*duel.ours, 0, duel.slice, 3) / 3, 1, 10000);
}

double round(Duel& duel) {
  const int turn = static_cast<int>(duel.ratios.size()), first = turn * duel.slice % (duel.states - duel.slice + 1);
  double ours = 0.0, theirs = 0.0;
  if (turn % 2 == 0) ours = seconds_of(*duel.ours, first, duel.slice, duel.cycles);
  theirs = seconds_of(*duel.theirs, first, duel.slice, 1);
  if (turn % 2 != 0) ours = seconds_of(*duel.ours, first, duel.slice, duel.cycles);
  const double ours_each = ours / (duel.cycles * duel.slice), theirs_each = theirs / duel.slice;
  duel.ratios.push_back(theirs_each / ours_each);
  duel.ours_ns.push_back(ours_each * 1e9), duel.peer_ns.push_back(theirs_each * 1e9);
  return ours + theirs;
}

}  // namespace bench
