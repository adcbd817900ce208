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

/// A port whose levels count from the moment that the pin drives.
struct PlayedPins {
  std::uint32_t set_reset = 0;
  struct Mode {
    std::uint32_t value = 0xA8000000, level_when_driven = 0;
    const std::uint32_t* level;
    void operator=(std::uint32_t written) {
      value = written;
      level_when_driven = *level;
    }
    operator std::uint32_t() const { return value; }
  } mode{0xA8000000, 0, &set_reset};
};
struct PlayedClocks {
  std::uint32_t ahb_enable[3]{};
};

constexpr std::uint32_t pa8 = 1u << 8;

TEST(Stm32f405DrivePin, IsLowBeforeItDrives) {
  PlayedClocks clocks;
  PlayedPins pins;
  stm32f405::drive_pin::start(clocks, pins);
  EXPECT_EQ(clocks.ahb_enable[0], 1u) << "GPIOA has its clock";
  EXPECT_EQ(pins.mode.level_when_driven, pa8 << 16) << "reset before the output drives";
  EXPECT_EQ(pins.mode.value, 0xA8010000u) << "PA8 is an output, the other pins stay as they were";
}

TEST(Stm32f405DrivePin, HighEnables) {
  PlayedPins pins;
  stm32f405::drive_pin::set(pins, true);
  EXPECT_EQ(pins.set_reset, pa8);
  stm32f405::drive_pin::set(pins, false);
  EXPECT_EQ(pins.set_reset, pa8 << 16);
}

TEST(Stm32f405DrivePin, IsHighWhereThePortDrivesIt) {
  struct {
    std::uint32_t mode, output;
  } pins{1u << 16, pa8}, open{0, pa8}, alternate{2u << 16, pa8}, low{1u << 16, 0};
  EXPECT_TRUE(stm32f405::drive_pin::level(pins));
  EXPECT_FALSE(stm32f405::drive_pin::level(open));
  EXPECT_FALSE(stm32f405::drive_pin::level(alternate));
  EXPECT_FALSE(stm32f405::drive_pin::level(low));
}

/// RM0090, memory map and GPIO registers: GPIOA at 0x4002 0000, BSRR at 0x18.
TEST(Stm32f405DrivePin, AFaultDisablesByOneStore) {
  EXPECT_EQ(Stm32f405::DrivePin::off_register, 0x40020018u);
  EXPECT_EQ(Stm32f405::DrivePin::off_word, pa8 << 16);
}

}  // namespace
}  // namespace axial::hal
