// ./axial exhaustive: what it says of some blocks is what quadruple precision says of each of their arguments.
#include <host_sim/figures/exhaustive/processes.hpp>
#include <host_sim/figures/exhaustive/sweep.hpp>

#include <axial/fixed/words/integer.hpp>
#include <oracle/scalar.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace {

using exhaustive::block;
using exhaustive::Finding;
using oracle::quad;

constexpr std::uint32_t stride = 104729;  // a prime: blocks of no particular angle

struct Errors {
  double highest = 0.0, lowest = 0.0, sum = 0.0;
  void add(quad error) {
    const auto e = static_cast<double>(error);
    highest = std::max(highest, e), lowest = std::min(lowest, e), sum += e;
  }
  void expect(const Finding& found, double tolerance) const {
    EXPECT_NEAR(found.highest, highest, tolerance) << found.subject;
    EXPECT_NEAR(found.lowest, lowest, tolerance) << found.subject;
    EXPECT_NEAR(found.sum, sum, tolerance * static_cast<double>(found.arguments)) << found.subject;
    EXPECT_EQ(found.broken, 0U) << found.subject;
  }
};

void add_block(Errors& sine, Errors& cosine, std::uint32_t number) {
  for (std::uint32_t bam = number * block; bam / block == number; ++bam) {
    const auto pair = axial::integer::sincos(bam);
    const quad angle = oracle::right_angle<quad>() * static_cast<quad>(bam) * 0x1p-30;
    sine.add(static_cast<quad>(pair.sin) * 0x1p-30 - oracle::sin(angle));
    cosine.add(static_cast<quad>(pair.cos) * 0x1p-30 - oracle::cos(angle));
  }
}

TEST(Sweep, SincosErrorsAreThoseOfQuadruple) {
  const auto found = exhaustive::sweep_angles(2, stride, [](std::size_t, std::size_t) {});
  Errors sine, cosine;
  std::uint64_t blocks = 0;
  for (std::uint32_t number = 0; number < 1U << 19; number += stride, blocks += 2)
    add_block(sine, cosine, number), add_block(sine, cosine, (1U << 20) - 1 - number);
  EXPECT_EQ(found[0].arguments, blocks * block);
  EXPECT_EQ(found[1].arguments, blocks * block);
  sine.expect(found[0], 0x1p-68), cosine.expect(found[1], 0x1p-68);
}

TEST(Sweep, ReciprocalErrorsAreThoseOfQuadruple) {
  const auto found = exhaustive::sweep_reciprocals(2, stride, [](std::size_t, std::size_t) {})[0];
  Errors errors;
  for (std::uint32_t number = 0; number < 1U << 19; number += stride)
    for (std::uint32_t d = std::max(number * block, 1U); d / block == number; ++d) {
      const auto r = axial::integer::reciprocal(static_cast<std::int32_t>(d));
      errors.add(static_cast<quad>(r.mantissa) - static_cast<quad>(std::uint64_t{1} << r.exponent) / d);
    }
  errors.expect(found, 0x1p-52);  // of errors up to 1, rounded to 53 bits
  EXPECT_EQ(found.highest_at / block % stride, 0U);
}

/// Extremes that several angles share are the first one's.
TEST(Sweep, ThreadsMakeNoDifference) {
  const auto report = [](std::size_t, std::size_t) {};
  const auto alone = exhaustive::sweep_angles(1, stride / 16, report),
             shared = exhaustive::sweep_angles(3, stride / 16, report);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(alone[i].highest_at, shared[i].highest_at);
    EXPECT_EQ(alone[i].lowest_at, shared[i].lowest_at);
    EXPECT_EQ(alone[i].upper, shared[i].upper);
    EXPECT_EQ(alone[i].lower, shared[i].lower);
  }
}

exhaustive::Options six_hundred_states() {
  exhaustive::Options options;
  options.states = 600, options.processes = 3, options.seed = 7;
  return options;
}

// Every process is asked for its share, part by part, and what all of them found is added up.
TEST(Processes, CountOverAllStates) {
  const auto states = [](std::uint64_t n, std::uint64_t) { return n; };
  EXPECT_EQ(exhaustive::in_processes(six_hundred_states(), "states", states), 600U);
  const auto sum_of_seeds = [](std::uint64_t, std::uint64_t seed) { return seed; };
  std::uint64_t sum = 0;
  for (std::uint64_t k = 0; k < 3; ++k)
    for (std::uint64_t p = 0; p < 100; ++p)
      sum += 7U * 1000003U + 1009U * k + p;  // no two parts draw the same states
  EXPECT_EQ(exhaustive::in_processes(six_hundred_states(), "seeds", sum_of_seeds), sum);
}

// The asker goes on afterwards: were it to end as those that counted do, this program would end early, and pass.
TEST(Processes, EndAndWhoAsksGoesOn) {
  const auto none = [](std::uint64_t, std::uint64_t) -> std::uint64_t { return 0; };
  const auto ask_and_go_on = [none] {
    exhaustive::in_processes(six_hundred_states(), "none", none);
    std::exit(5);
  };
  EXPECT_EXIT(ask_and_go_on(), testing::ExitedWithCode(5), "");
}

// A process that ends before it has told is an error, not a count of none.
TEST(Processes, ThatEndEarlyAreAnError) {
  const auto ends = [](std::uint64_t, std::uint64_t seed) -> std::uint64_t {
    if (seed == 7U * 1000003U + 1009U + 50U) _exit(0);
    return 0;
  };
  EXPECT_THROW(exhaustive::in_processes(six_hundred_states(), "an early end", ends), std::runtime_error);
}

}  // namespace
