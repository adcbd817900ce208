// Forward error of forward dynamics over seeded states, against quadruple precision.
#pragma once

#include <axial/dynamics/forward_dynamics.hpp>
#include <host_sim/counts/errors.hpp>
#include <host_sim/counts/forms.hpp>
#include <oracle/compare.hpp>
#include <oracle/convert.hpp>
#include <oracle/from_axial.hpp>
#include <oracle/random_chain.hpp>
#include <oracle/recursive.hpp>

#include <cmath>

namespace counts {

/// A state inside the declared limits and its exact acceleration. Positions, speeds and efforts are floats, so that
/// float, double and quad solve one problem; the robot's constants are not, and their rounding is part of the error.
struct State {
  oracle::Vector<double> q, qd, tau;
  oracle::Vector<oracle::quad> qdd;
};

template <class R>
State seeded_state(const oracle::Chain<oracle::quad>& chain, oracle::RandomChains& random) {
  State s;
  oracle::Vector<oracle::quad> desired;
  for (const auto& link : R::chain.links) {
    s.q.push_back(random.uniform(link.position_min, link.position_max));
    s.qd.push_back(random.uniform(-link.speed_limit, link.speed_limit));
    desired.push_back(random.uniform(-link.acceleration_limit, link.acceleration_limit));
  }
  const auto q = oracle::convert<oracle::quad>(s.q), qd = oracle::convert<oracle::quad>(s.qd);
  for (const auto& exact : oracle::recursive_inverse_dynamics(chain, q, qd, desired))
    s.tau.push_back(static_cast<double>(static_cast<float>(exact)));
  s.qdd = oracle::recursive_forward_dynamics(chain, q, qd, oracle::convert<oracle::quad>(s.tau));
  return s;
}

template <class R>
std::vector<State> seeded_states() {
  constexpr int count = 200;
  constexpr unsigned seed = 20;
  const auto chain = oracle::of_robot<oracle::quad, R>();
  oracle::RandomChains random(seed);
  std::vector<State> states;
  for (int i = 0; i < count; ++i)
    states.push_back(seeded_state<R>(chain, random));
  return states;
}

template <class S, class T>
double forward_error(const std::vector<State>& states) {
  using R = axial::robot_of<S>;
  double worst = 0.0;
  for (const State& s : states) {
    axial::Joints<R, T> q{}, qd{}, tau{};
    for (int i = 0; i < R::chain.size; ++i) {
      const auto k = static_cast<std::size_t>(i);
      q[i] = static_cast<T>(s.q[k]), qd[i] = static_cast<T>(s.qd[k]), tau[i] = static_cast<T>(s.tau[k]);
    }
    const auto answer = axial::forward_dynamics<S>(q, qd, tau);
    const oracle::Vector<T> qdd(answer.values, answer.values + R::chain.size);
    worst = std::fmax(worst, oracle::relative_error(qdd, s.qdd));
  }
  return worst;
}

template <class R, class T>
std::vector<double> errors_of_robot() {
  const auto states = seeded_states<R>();
  std::vector<double> result;
  for_each_form<R>([&](auto form) { result.push_back(forward_error<typename decltype(form)::Scene, T>(states)); });
  return result;
}

}  // namespace counts
