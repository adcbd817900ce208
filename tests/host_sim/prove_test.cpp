// What is proved is the kernel: a recorded program, evaluated at other inputs, gives the kernel's bits.
#include <host_sim/prove/arm.hpp>
#include <host_sim/prove/primitives.hpp>

#include <robots/scara.hpp>

#include <gtest/gtest.h>

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
