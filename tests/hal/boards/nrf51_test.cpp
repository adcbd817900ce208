#include <hal/boards/nrf51/board.hpp>

#include "played_clock.hpp"

namespace axial::hal {
namespace {

/// nRF51's clock controller: tasks are written, the event and the status are read.
struct ClockController {
  Played start_crystal, crystal_started, status;
};

ClockReport start(std::uint32_t started, std::uint32_t status) {
  ClockController controller;
  controller.crystal_started.answer = [started](std::uint32_t) { return started; };
  controller.status.answer = [status](std::uint32_t) { return status; };
  const ClockReport report = nrf51::clock::start(controller, 16'000'000);
  EXPECT_EQ(controller.start_crystal.written, 1u);
  return report;
}

constexpr std::uint32_t crystal = 1u << 0, running = 1u << 16;

TEST(Nrf51Clock, RunsFromTheCrystalOrFallsBack) {
  expect_clock(start(1, crystal | running), ClockSource::crystal, 16'000'000, 16'000'000);
  expect_clock(start(0, running), ClockSource::internal, 16'000'000, 16'000'000);
  expect_clock(start(1, running), ClockSource::internal, 16'000'000, 16'000'000);
}

/// QEMU reads 1 from every register of the clock.
TEST(Nrf51Clock, AnEmulatorIsToldFromASoundBoard) {
  expect_clock(start(1, 1), ClockSource::emulator, 16'000'000, 16'000'000);
}

/// A port whose levels count from the moment that the pin drives.
struct PlayedPins {
  std::uint32_t output_set = 0, output_clear = 0;
  struct Direction {
    std::uint32_t written = 0, cleared_when_driven = 0;
    const std::uint32_t* cleared;
    void operator=(std::uint32_t value) {
      written = value;
      cleared_when_driven = *cleared;
    }
  } direction_set{0, 0, &output_clear};
};

constexpr std::uint32_t p0_03 = 1u << 3;

TEST(Nrf51DrivePin, IsLowBeforeItDrives) {
  PlayedPins pins;
  nrf51::drive_pin::start(pins);
  EXPECT_EQ(pins.direction_set.written, p0_03);
  EXPECT_EQ(pins.direction_set.cleared_when_driven, p0_03);
  EXPECT_EQ(pins.output_set, 0u);
}

TEST(Nrf51DrivePin, HighEnables) {
  PlayedPins pins;
  nrf51::drive_pin::set(pins, true);
  EXPECT_EQ(pins.output_set, p0_03);
  EXPECT_EQ(pins.output_clear, 0u);
  nrf51::drive_pin::set(pins, false);
  EXPECT_EQ(pins.output_clear, p0_03);
}

TEST(Nrf51DrivePin, IsHighWhereThePortDrivesIt) {
  struct {
    std::uint32_t direction, output;
  } pins{p0_03, p0_03}, open{0, p0_03}, low{p0_03, 0};
  EXPECT_TRUE(nrf51::drive_pin::level(pins));
  EXPECT_FALSE(nrf51::drive_pin::level(open));
  EXPECT_FALSE(nrf51::drive_pin::level(low));
}

/// nRF51 reference manual, GPIO registers: base 0x5000 0000, OUTCLR at 0x50C.
TEST(Nrf51DrivePin, AFaultDisablesByOneStore) {
  EXPECT_EQ(Nrf51::DrivePin::off_register, 0x5000050Cu);
  EXPECT_EQ(Nrf51::DrivePin::off_word, p0_03);
}

}  // namespace
}  // namespace axial::hal
