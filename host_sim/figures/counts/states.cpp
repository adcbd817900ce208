#include <host_sim/figures/counts/states.hpp>
#include <oracle/as_float.hpp>
#include <oracle/convert.hpp>
#include <oracle/random_chain.hpp>

#include <cmath>

namespace counts {

namespace {

/// A limit that is not declared is that of firmware/apps/states.hpp.
double finite_or(double limit, double otherwise) { return std::isfinite(limit) ? limit : otherwise; }

State seeded_state(const oracle::DrivenChain<oracle::quad>& chain, const std::vector<axial::LinkParameters>& limits,
                   oracle::RandomChains& random) {
  State s;
  oracle::Vector<oracle::quad> desired;
  for (const auto& link : limits) {
    const double speed = finite_or(link.speed_limit, 2.0), acceleration = finite_or(link.acceleration_limit, 5.0);
    s.q.push_back(random.uniform(finite_or(link.position_min, -3.140625), finite_or(link.position_max, 3.140625)));
    s.qd.push_back(random.uniform(-speed, speed));
    desired.push_back(random.uniform(-acceleration, acceleration));
  }
  const auto q = oracle::convert<oracle::quad>(s.q), qd = oracle::convert<oracle::quad>(s.qd);
  for (const auto& exact : chain.inverse_dynamics(q, qd, desired))
    s.tau.push_back(oracle::as_float(exact));
  s.qdd = chain.forward_dynamics(q, qd, oracle::convert<oracle::quad>(s.tau));
  return s;
}

}  // namespace

std::vector<State> seeded_states(const oracle::DrivenChain<oracle::quad>& chain,
                                 const std::vector<axial::LinkParameters>& limits) {
  constexpr int count = 200;
  constexpr unsigned seed = 20;
  oracle::RandomChains random(seed);
  std::vector<State> states;
  for (int i = 0; i < count; ++i)
    states.push_back(seeded_state(chain, limits, random));
  return states;
}

}  // namespace counts
