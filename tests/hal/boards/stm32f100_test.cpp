#include <hal/boards/stm32f100/board.hpp>

#include "played_clock.hpp"

namespace axial::hal {
namespace {

ClockReport start(Rcc rcc) { return stm32f100::clock::start(rcc, 24'000'000); }

TEST(Stm32f100Clock, RunsFromTheCrystalOrFallsBack) {
  expect_clock(start(board(true, true)), ClockSource::crystal, 24'000'000, 24'000'000);
  expect_clock(start(board(false, true)), ClockSource::internal, 24'000'000, 24'000'000);
  expect_clock(start(board(true, false)), ClockSource::internal, 8'000'000, 8'000'000);
  expect_clock(start(emulator()), ClockSource::emulator, 24'000'000, 24'000'000);
}

TEST(Stm32f100Clock, AFailedStartLeavesTheInternalOscillatorSelected) {
  Rcc rcc = board(true, false);
  stm32f100::clock::start(rcc, 24'000'000);
  EXPECT_EQ(rcc.configuration.written & switch_mask, 0u);
  EXPECT_EQ(rcc.control.written & (crystal_on | pll_on), 0u);
}

}  // namespace
}  // namespace axial::hal
