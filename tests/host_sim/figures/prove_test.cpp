// What is proved is the kernel: a recorded program, evaluated at other inputs, gives the kernel's bits.
#include <host_sim/figures/prove/arm.hpp>
#include <host_sim/figures/prove/primitives.hpp>
#include <host_sim/figures/prove/step.hpp>

#include <robots/puma560.hpp>
#include <robots/scara.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace {

using axial::Fixed32;
using robots::Scara;

constexpr unsigned seed = 20190;
constexpr int states = 2000;

/// Values for a program's inputs, and the state that they are.
struct Drawn {
  std::vector<prove::Integer> inputs;
  axial::Positions<Scara, Fixed32> q{};
  axial::Velocities<Scara, Fixed32> qd{};
  axial::Accelerations<Scara, Fixed32> qdd{};
};

std::int32_t within(std::mt19937& random, const prove::Program& program, const std::string& name) {
  for (const prove::Claim& c : program.claims)
    if (program.at(c.node).name == name)
      return std::uniform_int_distribution<std::int32_t>(static_cast<std::int32_t>(c.low),
                                                         static_cast<std::int32_t>(c.high))(random);
  ADD_FAILURE() << "no input is called " << name;
  return 0;
}

Drawn draw(std::mt19937& random, const prove::Program& program) {
  Drawn d;
  std::map<std::string, std::int32_t> named;
  for (int i = 0; i < 3; ++i) {
    const std::string number = std::to_string(i + 1);
    d.q.values[i].raw = i == 2 ? within(random, program, "q3") : static_cast<std::int32_t>(random());
    d.qd.values[i].raw = within(random, program, "v" + number);
    d.qdd.values[i].raw = within(random, program, "a" + number);
    named["q" + number] = d.q.values[i].raw, named["v" + number] = d.qd.values[i].raw;
    named["a" + number] = d.qdd.values[i].raw;
  }
  int turn = program.turns == 1 ? 1 : 0;  // the closed form turns the second joint alone
  for (const int i : program.inputs()) {
    const std::string& name = program.at(i).name;
    if (name.compare(0, 3, "sin") == 0 || name.compare(0, 3, "cos") == 0) {
      const auto pair = axial::integer::sincos(static_cast<std::uint32_t>(d.q.values[turn].raw));
      d.inputs.push_back(name[0] == 's' ? pair.sin : pair.cos);
      if (name[0] == 'c') ++turn;
    } else {
      d.inputs.push_back(named.at(name));
    }
  }
  return d;
}

template <class Algorithm, class Run>
void expect_the_kernels_bits(Algorithm algorithm, Run run) {
  const prove::Statement s = prove::efforts_statement<Scara>(axial::error_bound<Scara>(algorithm), run);
  std::mt19937 random(seed);
  for (int k = 0; k < states; ++k) {
    const Drawn d = draw(random, s.program);
    const auto values = s.program.evaluate(d.inputs);
    EXPECT_TRUE(s.program.claims_hold(values)) << "state " << k;
    const auto tau = run(d.q, d.qd, d.qdd);
    for (int i = 0; i < 3; ++i)
      ASSERT_TRUE(values[static_cast<std::size_t>(s.results[static_cast<std::size_t>(i)].node)] == tau.values[i].raw)
          << "state " << k << ", joint " << i << ", seed " << seed;
  }
}

TEST(Prove, TheRecordedClosedFormIsTheKernel) {
  expect_the_kernels_bits(axial::algorithm::closed_form, [](const auto& q, const auto& qd, const auto& qdd) {
    return axial::closed_form::scara_torque<Scara>(q, qd, qdd);
  });
}

TEST(Prove, TheRecordedInverseDynamicsIsTheKernel) {
  expect_the_kernels_bits(axial::algorithm::inverse_dynamics, [](const auto& q, const auto& qd, const auto& qdd) {
    return axial::inverse_dynamics<Scara>(q, qd, qdd);
  });
}

TEST(Prove, TheRecordedSineIsTheKernelOnAllArcs) {
  std::mt19937 random(seed);
  std::uint64_t angles = 0;
  for (const prove::Arc& arc : prove::arcs()) {
    const prove::Statement sine = prove::wave_statement(prove::Wave::sine, arc);
    const prove::Statement cosine = prove::wave_statement(prove::Wave::cosine, arc);
    angles += std::uint64_t{arc.last} - arc.first + 1;
    std::uniform_int_distribution<std::uint32_t> any(arc.first, arc.last);
    for (int k = 0; k < states; ++k) {
      const std::uint32_t bam = k == 0 ? arc.first : k == 1 ? arc.last : any(random);
      const auto pair = axial::integer::sincos(bam);
      const auto sines = sine.program.evaluate({bam}), cosines = cosine.program.evaluate({bam});
      EXPECT_TRUE(sine.program.claims_hold(sines)) << bam;
      EXPECT_TRUE(cosine.program.claims_hold(cosines)) << bam;
      ASSERT_TRUE(sines[static_cast<std::size_t>(sine.results[0].node)] == pair.sin) << bam;
      ASSERT_TRUE(cosines[static_cast<std::size_t>(cosine.results[0].node)] == pair.cos) << bam;
    }
  }
  EXPECT_EQ(angles, std::uint64_t{1} << 32) << "the arcs are one turn";
}

/// What a node computes of a word, the input shifted up or not: products and sums of it, written out.
std::string expression(const prove::Program& program, int node, int word) {
  if (node == word) return "n";
  const prove::Node& n = program.at(node);
  if (n.kind == prove::Kind::constant) return prove::text_of(n.value);
  std::string text = std::to_string(static_cast<int>(n.kind)) + "," + std::to_string(n.power) + "(";
  for (const int operand : {n.left, n.right})
    if (operand >= 0) text += expression(program, operand, word) + ";";
  return text + ")";
}

/// The input of a reciprocal as a word of 31 bits.
int normalised(const prove::Program& program, int power) {
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    const prove::Node& n = program.nodes[i];
    if (n.kind == (power == 0 ? prove::Kind::input : prove::Kind::times_power) && n.power == power)
      return static_cast<int>(i);
  }
  return -1;
}

void expect_reciprocals(std::mt19937& random, const prove::Statement& s, const prove::Arc& range) {
  std::uniform_int_distribution<std::uint32_t> any(range.first, range.last);
  for (int k = 0; k < states; ++k) {
    const std::uint32_t d = k == 0 ? range.first : k == 1 ? range.last : any(random);
    const auto values = s.program.evaluate({d});
    EXPECT_TRUE(s.program.claims_hold(values)) << d;
    ASSERT_TRUE(values[static_cast<std::size_t>(s.results[0].node)] ==
                axial::integer::reciprocal(static_cast<std::int32_t>(d)).mantissa)
        << d;
  }
}

TEST(Prove, TheRecordedReciprocalIsTheKernelForEveryLength) {
  std::mt19937 random(seed);
  for (int power = 0; power <= 30; ++power) {
    std::uint32_t next = 1U << (30 - power);
    for (const prove::Arc& range : prove::mantissas()) {
      if ((range.last >> power) < next) continue;  // no integer of this length is shifted there
      const prove::Statement s = prove::reciprocal_statement({next, range.last >> power});
      const prove::Statement proved = prove::reciprocal_statement(range);
      expect_reciprocals(random, s, {next, range.last >> power});
      EXPECT_EQ(expression(s.program, s.results[0].node, normalised(s.program, power)),
                expression(proved.program, proved.results[0].node, normalised(proved.program, 0)))
          << "shifted by " << power;
      next = (range.last >> power) + 1;
    }
    EXPECT_EQ(next, 2U << (30 - power)) << "the ranges are all integers of this length";
  }
}

/// The words of a vector under the names that the step's inputs have.
template <class V>
void name_words(std::map<std::string, std::int32_t>& named, const std::string& name, const V& v) {
  named[name + "x"] = v.x.raw, named[name + "y"] = v.y.raw, named[name + "z"] = v.z.raw;
}

TEST(Prove, TheRecordedStepIsTheKernelBetweenItsNeighbours) {
  using Puma = robots::Puma560;
  const prove::Statement s = prove::step_statement<Puma, 2>();
  std::mt19937 random(seed);
  const auto within_limit = [&](double most, int exponent) {
    return prove::raw_value(most * std::uniform_real_distribution<double>(-1.0, 1.0)(random), exponent);
  };
  for (int k = 0; k < states; ++k) {
    axial::Positions<Puma, Fixed32> q{};
    axial::Velocities<Puma, Fixed32> qd{};
    axial::Accelerations<Puma, Fixed32> qdd{};
    std::map<std::string, std::int32_t> named;
    for (int i = 0; i < q.size; ++i) {
      const auto& link = Puma::chain.links[i];
      const std::string number = std::to_string(i + 1);
      q.values[i].raw = static_cast<std::int32_t>(random());
      named["v" + number] = qd.values[i].raw = within_limit(link.speed_limit, qd.exponent(i));
      named["a" + number] = qdd.values[i].raw = within_limit(link.acceleration_limit, qdd.exponent(i));
      const auto pair = axial::integer::sincos(static_cast<std::uint32_t>(q.values[i].raw));
      named["sin" + number] = pair.sin, named["cos" + number] = pair.cos;
    }
    const auto [links, screws, at, speeds, accelerations] = prove::run_of<Puma, Fixed32>(q, qd, qdd);
    const auto around = prove::neighbours<2>(links, axial::Inputs<Puma, Fixed32>{}, screws, speeds, accelerations);
    name_words(named, "w", around.parent.w), name_words(named, "dw", around.parent.dw);
    name_words(named, "acc", around.parent.a), name_words(named, "n", around.on_parent.moment);
    name_words(named, "f", around.on_parent.force), name_words(named, "ux", around.parent.u.x);
    name_words(named, "uy", around.parent.u.y), name_words(named, "uz", around.parent.u.z);
    std::vector<prove::Integer> inputs;
    for (const int i : s.program.inputs())
      inputs.push_back(named.at(s.program.at(i).name));
    const auto values = s.program.evaluate(inputs);
    EXPECT_TRUE(s.program.claims_hold(values)) << "state " << k;
    const auto tau = axial::inverse_dynamics<Puma>(q, qd, qdd);
    const auto effort =
        std::find_if(s.results.begin(), s.results.end(), [](const auto& r) { return r.name == "effort"; });
    ASSERT_TRUE(values[static_cast<std::size_t>(effort->node)] == tau.values[2].raw) << "state " << k;
  }
}

TEST(Prove, AChoiceIsAGoalWhateverBecomesOfItsWord) {
  const prove::Statement s = prove::wave_statement(prove::Wave::sine, prove::arcs()[0]);
  const std::string words = prove::script_of(s, prove::Goal::words);
  int choices = 0;
  for (const prove::Claim& c : s.program.claims) {
    if (!c.chooses) continue;
    ++choices;
    EXPECT_NE(words.find("p" + std::to_string(c.node) + " in ["), std::string::npos) << c.node;
  }
  EXPECT_GE(choices, 4) << "a sign, whether to exchange, and two more signs";
}

TEST(Prove, WhatDependsOnDataIsRefused) {
  prove::Program program;
  prove::Program::activate(&program);
  const prove::Int32 x{5, program.input("x", 5, -100, 100)}, y{3, program.input("y", 3, -100, 100)};
  EXPECT_THROW(static_cast<void>(x & y), std::logic_error);
  EXPECT_THROW(static_cast<void>(x | y), std::logic_error);
  EXPECT_THROW(static_cast<void>(x & 5), std::logic_error);
  const prove::Int32 sign = x >> 31;  // a choice: recorded with the claim that it always goes this way
  EXPECT_TRUE(sign.is_constant());
  EXPECT_FALSE(program.claims_hold(program.evaluate({-1, 3})));
}

}  // namespace
