#pragma once
/// Stands for the watchdog of a part whose emulator has none: SysTick's interrupt, which restarts as the part's own
/// would. In images for emulators only, and only where the clock says that one runs. It does not see a hang with
/// interrupts masked or in another handler; the part's own does.

#include <cstdint>

#include <hal/cortex_m/registers.hpp>

/// Drives off, reason noted, restart; in faults.cpp.
extern "C" void axial_watchdog_expired();

namespace axial::hal::cortex_m {

/// `Board` gives tick_Hz.
template <class Board>
class EmulatedWatchdog {
 public:
  /// Restarts the board between `ms`, at most 20 s, and one period of SysTick more after it was fed last.
  static void start(std::uint32_t core_Hz, std::uint32_t ms) {
    core_Hz_ = core_Hz;
    limit_ = core_Hz / 1000 * ms;
    feed();
    resume();
  }

  static void feed() { left_ = limit_; }

  /// Restarts SysTick when the control tick, which shares it, has stopped it.
  static void resume() {
    using namespace sys_tick_control;
    auto& timer = sys_tick();
    if (limit_ == 0 || (timer.control & interrupts) != 0) return;
    timer.reload = core_Hz_ / Board::tick_Hz - 1;
    timer.current = 0;
    timer.control = enable | interrupts | core_clock;
  }

  static void interrupt() {
    if (limit_ == 0) return;
    const std::uint32_t period = sys_tick().reload + 1;
    if (left_ < period) axial_watchdog_expired();
    left_ = left_ - period;
  }

 private:
  inline static std::uint32_t core_Hz_ = 0, limit_ = 0;
  inline static volatile std::uint32_t left_ = 0;
};

/// No emulated watchdog: for a board whose watchdog its emulator has.
struct NoEmulatedWatchdog {
  static void start(std::uint32_t, std::uint32_t) {}
  static void feed() {}
  static void resume() {}
  static void interrupt() {}
};

}  // namespace axial::hal::cortex_m
