#include <hal/rp2040/boot2.hpp>
#include <hal/rp2040/timer_tick.hpp>
#include <hal/rp2040/watchdog.hpp>

#include <gtest/gtest.h>

#include "boards/stores.hpp"

namespace axial::hal::rp2040 {
namespace {

/// CRC-32/MPEG-2 of "123456789", Koopman's and Williams' catalogues.
TEST(Rp2040Boot2, TheCrcHasItsCheckValue) {
  EXPECT_EQ(boot_crc(std::array<std::uint8_t, 9>{'1', '2', '3', '4', '5', '6', '7', '8', '9'}), 0x0376E6E7u);
}

TEST(Rp2040Boot2, EndsWithTheCrcOfWhatComesBefore) {
  const auto bytes = boot2();
  std::uint32_t told = 0;
  for (std::size_t i = 4; i-- > 0;)
    told = told << 8 | bytes[252 + i];
  EXPECT_EQ(told, boot_crc(boot2_body()));
  EXPECT_EQ(bytes[0], 0x04) << "little-endian";
  EXPECT_EQ(bytes[1], 0xA3);
}

/// RP2040 Datasheet, 4.10.13: the controller is set up while it is disabled; 03h, 8 bits of command, 24 of address, 32
/// of data, on one wire; no bit of a wider or a continuous read.
TEST(Rp2040Boot2, SetsTheFlashUpForASlowReadThenTheVectors) {
  const std::array<Store, 8> expected{{{0x18000008, 0},
                                       {0x18000014, 4},
                                       {0x18000000, 0x001F0300},
                                       {0x180000F4, 0x03000218},
                                       {0x18000004, 0},
                                       {0x18000008, 1},
                                       {0xE000ED08, 0x10000100},
                                       {0, 0x10000100}}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(boot2_stores[i].address, expected[i].address);
    EXPECT_EQ(boot2_stores[i].word, expected[i].word);
  }
}

struct PlayedTimer {
  Noted alarm[1]{{"alarm"}}, armed{"disarm"}, interrupt{"clear"}, interrupt_enable{"enable"};
  std::uint32_t raw_low = 0, interrupt_status = 0;
};
struct TimerPort {
  inline static PlayedTimer played{};
  static PlayedTimer& registers() { return played; }
  static void enable_line() {}
};
using Ticks = TimerTick<TimerPort>;

std::vector<hal::Store> tick_at(std::uint32_t now) {
  TimerPort::played.raw_low = now;
  TimerPort::played.interrupt_status = 1;
  return stores_of(Ticks::interrupt);
}

TEST(Rp2040TimerTick, ComesEveryPeriodWhoeverIsLate) {
  TimerPort::played.raw_low = 0xFFFFFF00;
  EXPECT_EQ(stores_of([] { Ticks::start(0, 1000); }), (std::vector<hal::Store>{{"enable", 1}, {"alarm", 744}}));
  EXPECT_EQ(tick_at(750), (std::vector<hal::Store>{{"clear", 1}, {"alarm", 1744}})) << "no drift: from the last alarm";
  EXPECT_EQ(tick_at(2744), (std::vector<hal::Store>{{"clear", 1}, {"alarm", 2744}, {"alarm", 3744}}))
      << "an alarm that is past would come in 71 minutes";
  EXPECT_EQ(Ticks::count(), 2u);
}

TEST(Rp2040TimerTick, AStoppedTickCountsNothing) {
  EXPECT_EQ(stores_of(Ticks::stop), (std::vector<hal::Store>{{"disarm", 1}, {"enable", 0}, {"clear", 1}}));
  const std::uint32_t before = Ticks::count();
  TimerPort::played.interrupt_status = 0;
  EXPECT_EQ(stores_of(Ticks::interrupt), std::vector<hal::Store>{});
  EXPECT_EQ(Ticks::count(), before);
}

struct PlayedWatchdog {
  Noted control{"control"}, load{"load"};
};
struct PlayedPower {
  Noted watchdog_select{"select"};
};
struct WatchdogPort {
  inline static PlayedWatchdog played{};
  inline static PlayedPower played_power{};
  static PlayedWatchdog& registers() { return played; }
  static PlayedPower& power() { return played_power; }
};
using Dog = Watchdog<WatchdogPort>;

/// Erratum RP2040-E1: two counts a microsecond. Datasheet 2.13.5: all of the power-on state machine but the
/// oscillators.
TEST(Rp2040Watchdog, StartsWithItsTimeAndResetsEverything) {
  EXPECT_EQ(stores_of([] { Dog::start(100); }),
            (std::vector<hal::Store>{{"select", 0x1FFFC}, {"load", 200'000}, {"control", 1u << 30}}));
  EXPECT_EQ(stores_of(Dog::feed), (std::vector<hal::Store>{{"load", 200'000}}));
}

TEST(Rp2040Watchdog, RestartsOnRequest) {
  EXPECT_EQ(stores_of(Dog::trigger), (std::vector<hal::Store>{{"select", 0x1FFFC}, {"control", 1u << 31}}));
}

TEST(Rp2040Watchdog, TimeIsBounded) {
  EXPECT_EQ(watchdog_load(8'388), 16'776'000u);
  EXPECT_EQ(watchdog_load(8'389), 0xFFFFFFu);
  EXPECT_EQ(watchdog_load(0xFFFFFFFF), 0xFFFFFFu);
}

TEST(Rp2040ResetReason, NamesTheCause) {
  EXPECT_EQ(reset_cause(0), ResetCause::power_on);
  EXPECT_EQ(reset_cause(1), ResetCause::watchdog);
  EXPECT_EQ(reset_cause(2), ResetCause::software);
  EXPECT_EQ(reset_cause(3), ResetCause::watchdog);
}

}  // namespace
}  // namespace axial::hal::rp2040
