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

}  // namespace
}  // namespace axial::hal
