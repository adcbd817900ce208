// A kernel of an arm: recorded over words and over real numbers, with the bounds that the library certifies.
#pragma once

#include <host_sim/figures/prove/fixed_kernel.hpp>
#include <host_sim/figures/prove/formula.hpp>
#include <host_sim/figures/prove/primitives.hpp>
#include <host_sim/figures/prove/script.hpp>

#include <cmath>

namespace prove {

/// A state within the limits that a robot declares: once as words, once as real variables of the same names.
template <class Robot>
struct ArmState {
  using Word = axial::Stored<Int32>;
  axial::Positions<Robot, Word> q{};
  axial::Velocities<Robot, Word> qd{};
  axial::Accelerations<Robot, Word> qdd{};
  axial::Joints<Robot, Real, void> real_q{}, real_qd{}, real_qdd{};
};

inline std::int32_t raw_value(double x, int exponent) {
  return static_cast<std::int32_t>(std::lround(std::ldexp(x, exponent)));
}

/// An input of a statement with its scale.
inline int add_input(Statement& s, const std::string& name, std::int32_t here, double low, double high, int exponent) {
  const int node = s.program.input(name, here, raw_value(low, exponent), raw_value(high, exponent));
  s.known[node] = exponent;
  return node;
}

template <class Robot, class Values, class Reals>
void set_rates(Statement& s, Values& values, Reals& reals, const char* letter, double axial::LinkParameters::*limit) {
  for (int i = 0; i < Values::size; ++i) {
    const double most = Robot::chain.links[i].*limit;
    const std::string name = letter + std::to_string(i + 1);
    const std::int32_t here = raw_value(most * (0.9 - 0.13 * i), Values::exponent(i));
    values.values[i] = {{here, add_input(s, name, here, -most, most, Values::exponent(i))}};
    reals[i] = Real::variable(name);
  }
}

template <class Robot>
ArmState<Robot> state_of(Statement& s) {
  ArmState<Robot> state;
  for (int i = 0; i < state.q.size; ++i) {
    const auto& link = Robot::chain.links[i];
    if (link.type == axial::JointType::revolute) {
      state.q.values[i].raw = 400000000 + 300000000 * i;
      continue;
    }
    const std::string name = "q" + std::to_string(i + 1);
    const int exponent = state.q.exponent(i);
    state.q.values[i].raw = raw_value(0.3 * link.position_min + 0.7 * link.position_max, exponent);
    add_input(s, name, state.q.values[i].raw, link.position_min, link.position_max, exponent);
    state.real_q[i] = Real::variable(name);
  }
  set_rates<Robot>(s, state.qd, state.real_qd, "v", &axial::LinkParameters::speed_limit);
  set_rates<Robot>(s, state.qdd, state.real_qdd, "a", &axial::LinkParameters::acceleration_limit);
  return state;
}

/// Sines and cosines: words off by at most what the proof of the sine says.
inline void add_turns(Statement& s) {
  for (const int i : s.program.inputs()) {
    const std::string word = s.program.at(i).name;
    if (word.compare(0, 3, "sin") != 0 && word.compare(0, 3, "cos") != 0) continue;
    const std::string exact = (word[0] == 's' ? "SIN" : "COS") + word.substr(3);
    s.known[i] = 30;
    s.variables.push_back(
        {exact, std::ldexp(static_cast<long double>(s.program.at(i).value), -30), word, -1, sine_bound});
  }
}

/// The statement about a kernel whose results are efforts: run(q, qd, qdd) answers those of either number system.
template <class Robot, class Bound, class Run>
Statement efforts_statement(const Bound& bound, Run run) {
  Statement s;
  Program::activate(&s.program);
  Formula::activate(&s.formula);
  const ArmState<Robot> state = state_of<Robot>(s);
  const auto words = run(state.q, state.qd, state.qdd);
  const auto exact = run(state.real_q, state.real_qd, state.real_qdd);
  add_turns(s);
  for (int i = 0; i < state.q.size; ++i) {
    const int node = words.values[i].raw.settled();
    s.known[node] = words.exponent(i);
    s.results.push_back({"tau" + std::to_string(i + 1), node, exact[i].term(), bound[i]});
  }
  return s;
}

}  // namespace prove
