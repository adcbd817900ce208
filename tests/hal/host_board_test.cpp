#include <hal/host/board.hpp>

#include <gtest/gtest.h>

namespace axial::hal {
namespace {

class TheHostBoard : public testing::Test {
 protected:
  TheHostBoard() { HostBoard::fresh(); }
};

TEST_F(TheHostBoard, StartsWithTheDrivesOff) {
  HostBoard::start();
  EXPECT_FALSE(HostBoard::drives_enabled());
  EXPECT_TRUE(HostBoard::state.drive_changes.empty());
  EXPECT_EQ(HostBoard::reset_cause(), ResetCause::power_on);
}

TEST_F(TheHostBoard, TellsEachChangeOfTheDrivesWithItsTick) {
  HostBoard::state.ticks = 5;
  HostBoard::enable_drives(true);
  HostBoard::enable_drives(true);
  HostBoard::state.ticks = 9;
  HostBoard::enable_drives(false);
  ASSERT_EQ(HostBoard::state.drive_changes.size(), 2u);
  EXPECT_EQ(HostBoard::state.drive_changes[0].tick, 5u);
  EXPECT_TRUE(HostBoard::state.drive_changes[0].on);
  EXPECT_EQ(HostBoard::state.drive_changes[1].tick, 9u);
  EXPECT_FALSE(HostBoard::state.drive_changes[1].on);
}

TEST_F(TheHostBoard, AFailureIsToldByTheNextStart) {
  HostBoard::enable_drives(true);
  HostBoard::fail(ResetCause::stack_overflow);
  EXPECT_FALSE(HostBoard::drives_enabled());
  EXPECT_EQ(HostBoard::state.restarts, 1u);
  HostBoard::boot();
  HostBoard::start();
  EXPECT_EQ(HostBoard::reset_cause(), ResetCause::stack_overflow);
  HostBoard::boot();
  HostBoard::start();
  EXPECT_EQ(HostBoard::reset_cause(), ResetCause::power_on);
  HostBoard::reset();
  HostBoard::boot();
  HostBoard::start();
  EXPECT_EQ(HostBoard::reset_cause(), ResetCause::software);
}

TEST_F(TheHostBoard, WatchdogExpiresWhenNobodyFeedsIt) {
  EXPECT_FALSE(HostBoard::watchdog_expired()) << "not started";
  HostBoard::state.ticks = 10;
  HostBoard::start_watchdog(20);
  HostBoard::state.ticks = 29;
  EXPECT_FALSE(HostBoard::watchdog_expired());
  HostBoard::feed_watchdog();
  HostBoard::state.ticks = 48;
  EXPECT_FALSE(HostBoard::watchdog_expired());
  HostBoard::state.ticks = 49;
  EXPECT_TRUE(HostBoard::watchdog_expired());
  EXPECT_EQ(HostBoard::state.feeds, 1u);
}

}  // namespace
}  // namespace axial::hal
