#include <hal/cortex_m/counter.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace axial::hal::cortex_m {
namespace {

class Conversion : public testing::TestWithParam<std::uint32_t> {};

/// SysTick after k instructions of 64 ns, with the emulator's rounding of up to half a tick.
std::uint32_t ticks_after(std::uint32_t k, std::uint32_t tick_Hz, double rounding) {
  return static_cast<std::uint32_t>(std::floor(k * 64e-9 * tick_Hz + rounding));
}

TEST_P(Conversion, GivesBackEveryCount) {
  const CounterScale scale = instructions_of_ticks(GetParam());
  for (const double rounding : {0.001, 0.25, 0.499}) {
    for (std::uint32_t k = 0; ticks_after(k, GetParam(), rounding) < (1u << 24); k += 1 + k / 1000) {
      ASSERT_EQ(instructions_of(ticks_after(k, GetParam(), rounding), scale), k) << "rounding " << rounding;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(CoreClocks, Conversion, testing::Values(168'000'000u, 24'000'000u));

static_assert(instructions_of_ticks(168'000'000).numerator == 125 &&
              instructions_of_ticks(168'000'000).denominator == 1344);
static_assert(instructions_of_ticks(24'000'000).numerator == 125 &&
              instructions_of_ticks(24'000'000).denominator == 192);

}  // namespace
}  // namespace axial::hal::cortex_m
