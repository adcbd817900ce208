// A test of many hostile words in fixed point, for the robot that it is about.
#pragma once

#include <cstdio>

#include <property/fixed/fixed_robots.hpp>
#include "hostile_fixed.hpp"

namespace property {

/// Tests of words, of hostile_fixed_test.cpp and hostile_classical_test.cpp together.
constexpr std::uint64_t hostile_word_tests = 14;

template <class R>
class HostileWords : public testing::Test {
 protected:
  template <class S, class Check>
  void run(std::uint64_t few, const Check& check) {
    exhaustive::Random random(hostile_seed);
    Wrong wrong;
    const std::uint64_t states = hostile_states(few, hostile_word_tests);
    for (std::uint64_t k = 0; k < states; ++k)
      check(hostile_state<HostileState<S>>(random, k), k, wrong);
    EXPECT_EQ(wrong.count, 0U) << wrong.first;
    std::printf("%llu states\n", static_cast<unsigned long long>(states));
  }
};

}  // namespace property
