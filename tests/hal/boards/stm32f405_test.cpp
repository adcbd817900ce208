#include <hal/boards/stm32f405/board.hpp>

#include "played_clock.hpp"

namespace axial::hal {
namespace {

ClockReport start(Rcc& rcc, Flash& flash) { return stm32f405::clock::start(rcc, flash, 168'000'000); }

ClockReport start(Rcc rcc) {
  Flash flash;
  return start(rcc, flash);
}

TEST(Stm32f405Clock, RunsFromTheCrystalOrFallsBack) {
  expect_clock(start(board(true, true)), ClockSource::crystal, 168'000'000, 84'000'000);
  expect_clock(start(board(false, true)), ClockSource::internal, 16'000'000, 16'000'000);
  expect_clock(start(board(true, false)), ClockSource::internal, 16'000'000, 16'000'000);
  expect_clock(start(emulator()), ClockSource::emulator, 168'000'000, 84'000'000);
}

TEST(Stm32f405Clock, WaitStatesComeWithTheFastClock) {
  Rcc rcc = board(true, true);
  Flash flash;
  start(rcc, flash);
  EXPECT_EQ(flash.access_control.written & 0xFu, 5u);
  // RM0090 7.3.2: M 25, N 336, P 2 (coded 0), from the crystal (bit 22), Q 7.
  EXPECT_EQ(rcc.pll.written, 25u + (336u << 6) + (1u << 22) + (7u << 24));
}

TEST(Stm32f405Clock, AFailedStartLeavesTheInternalOscillatorSelected) {
  Rcc rcc = board(true, false);
  Flash flash;
  start(rcc, flash);
  EXPECT_EQ(rcc.configuration.written & switch_mask, 0u);
  EXPECT_EQ(rcc.control.written & (crystal_on | pll_on), 0u);
}

}  // namespace
}  // namespace axial::hal
