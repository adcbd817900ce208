#include <algorithm>
#include <bench/duel.hpp>
#include <chrono>
#include <oracle/compare.hpp>

namespace bench {
namespace {

constexpr double shortest_side = 40e-6;  // s: a thousand times what reading the clock takes

double seconds_of(Contender& contender, int cycles) {
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < cycles; ++i)
    contender.cycle();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

double disagreement(Duel& duel) {
  double worst = 0.0;
  for (int state = 0; state < duel.states; ++state)
    worst = std::max(worst, oracle::relative_error(duel.ours->result(state), duel.theirs->result(state)));
  return worst;
}

void prepare(Duel& duel) {
  duel.theirs->cycle();
  seconds_of(*duel.ours, 2);
  duel.cycles = std::clamp(static_cast<int>(shortest_side / seconds_of(*duel.ours, 1)), 1, 1000);
}

double round(Duel& duel) {
  const bool ours_first = duel.ratios.size() % 2 == 0;
  double ours = 0.0, theirs = 0.0;
  if (ours_first) ours = seconds_of(*duel.ours, duel.cycles);
  theirs = seconds_of(*duel.theirs, 1);
  if (!ours_first) ours = seconds_of(*duel.ours, duel.cycles);
  const double ours_each = ours / (duel.cycles * duel.states), theirs_each = theirs / duel.states;
  duel.ratios.push_back(theirs_each / ours_each);
  duel.ours_ns.push_back(ours_each * 1e9), duel.peer_ns.push_back(theirs_each * 1e9);
  return ours + theirs;
}

}  // namespace bench
