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

/// A port whose levels count from the moment that the pin drives.
struct PlayedPins {
  std::uint32_t set_reset = 0;
  struct Configuration {
    std::uint32_t value, level_when_driven;
    const std::uint32_t* level;
    void operator=(std::uint32_t written) {
      value = written;
      level_when_driven = *level;
    }
    operator std::uint32_t() const { return value; }
  } configuration[2]{{0x44444444, 0, &set_reset}, {0x44444444, 0, &set_reset}};
};
struct PlayedClocks {
  std::uint32_t apb2_enable = 0;
};

constexpr std::uint32_t pa8 = 1u << 8;

TEST(Stm32f100DrivePin, IsLowBeforeItDrives) {
  PlayedClocks clocks;
  PlayedPins pins;
  stm32f100::drive_pin::start(clocks, pins);
  EXPECT_EQ(clocks.apb2_enable, 1u << 2) << "GPIOA has its clock";
  EXPECT_EQ(pins.configuration[1].level_when_driven, pa8 << 16) << "reset before the output drives";
  EXPECT_EQ(pins.configuration[1].value, 0x44444442u) << "PA8 is an output, the other pins stay as they were";
  EXPECT_EQ(pins.configuration[0].value, 0x44444444u);
}

TEST(Stm32f100DrivePin, HighEnables) {
  PlayedPins pins;
  stm32f100::drive_pin::set(pins, true);
  EXPECT_EQ(pins.set_reset, pa8);
  stm32f100::drive_pin::set(pins, false);
  EXPECT_EQ(pins.set_reset, pa8 << 16);
}

TEST(Stm32f100DrivePin, IsHighWhereThePortDrivesIt) {
  struct {
    std::uint32_t configuration[2], output;
  } pins{{0, 2}, pa8}, open{{0, 4}, pa8}, low{{0, 2}, 0};
  EXPECT_TRUE(stm32f100::drive_pin::level(pins));
  EXPECT_FALSE(stm32f100::drive_pin::level(open));
  EXPECT_FALSE(stm32f100::drive_pin::level(low));
}

/// RM0041, memory map and GPIO registers: GPIOA at 0x4001 0800, BSRR at 0x10.
TEST(Stm32f100DrivePin, AFaultDisablesByOneStore) {
  EXPECT_EQ(Stm32f100::DrivePin::off_register, 0x40010810u);
  EXPECT_EQ(Stm32f100::DrivePin::off_word, pa8 << 16);
}

}  // namespace
}  // namespace axial::hal
