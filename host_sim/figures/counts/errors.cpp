#include <host_sim/figures/counts/errors.hpp>
#include <host_sim/figures/counts/float_or_double.hpp>
#include <host_sim/figures/counts/forms.hpp>
#include <host_sim/figures/counts/solve.hpp>
#include <host_sim/figures/counts/states.hpp>
#include <host_sim/tools/analysis/largest.hpp>
#include <oracle/compare.hpp>

#include <counted.hpp>
#include <cstdio>

namespace counts {

namespace {

double forward_error(Solve solve, const std::vector<State>& states, Precision precision) {
  FloatOrDouble::precision = precision;
  double worst = 0.0;
  for (const State& s : states)
    host_sim::note_size(worst, oracle::relative_error(solve(s.q, s.qd, s.tau), s.qdd));
  return worst;
}

template <class R>
void add_errors(std::vector<Errors>& result) {
  std::fprintf(stderr, "counts: forward errors of %s\n", R::name);
  const auto states = seeded_states<R>();
  const auto solves = solves_of<R>();
  std::size_t i = 0;
  for_each_form<R>([&](auto form) {
    result.push_back({R::name, form.algorithm, form.parameters, forward_error(solves[i], states, Precision::in_float),
                      forward_error(solves[i], states, Precision::in_double)});
    ++i;
  });
}

}  // namespace

std::vector<Errors> errors(const std::string& robot) {
  std::vector<Errors> result;
  Counted::for_each([&](auto named) {
    if (robot.empty() || robot == named.name) add_errors<typename decltype(named)::Robot>(result);
  });
  return result;
}

}  // namespace counts
