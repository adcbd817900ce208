#include <host_sim/counts/states.hpp>
#include <oracle/as_float.hpp>
#include <oracle/convert.hpp>
#include <oracle/random_chain.hpp>
#include <oracle/recursive.hpp>

namespace counts {

namespace {

State seeded_state(const oracle::Chain<oracle::quad>& chain, const std::vector<axial::LinkParameters>& links,
                   oracle::RandomChains& random) {
  State s;
  oracle::Vector<oracle::quad> desired;
  for (const auto& link : links) {
    s.q.push_back(random.uniform(link.position_min, link.position_max));
    s.qd.push_back(random.uniform(-link.speed_limit, link.speed_limit));
    desired.push_back(random.uniform(-link.acceleration_limit, link.acceleration_limit));
  }
  const auto q = oracle::convert<oracle::quad>(s.q), qd = oracle::convert<oracle::quad>(s.qd);
  for (const auto& exact : oracle::recursive_inverse_dynamics(chain, q, qd, desired))
    s.tau.push_back(oracle::as_float(exact));
  s.qdd = oracle::recursive_forward_dynamics(chain, q, qd, oracle::convert<oracle::quad>(s.tau));
  return s;
}

}  // namespace

std::vector<State> seeded_states(const oracle::Chain<oracle::quad>& chain,
                                 const std::vector<axial::LinkParameters>& links) {
  constexpr int count = 200;
  constexpr unsigned seed = 20;
  oracle::RandomChains random(seed);
  std::vector<State> states;
  for (int i = 0; i < count; ++i)
    states.push_back(seeded_state(chain, links, random));
  return states;
}

}  // namespace counts
