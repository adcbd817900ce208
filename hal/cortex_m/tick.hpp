#pragma once
/// The control tick: SysTick's interrupt at a fixed rate.

#include <cstdint>

#include <hal/cortex_m/registers.hpp>

namespace axial::hal::cortex_m {

class Tick {
 public:
  /// Starts the tick at `rate_Hz`, rounded to whole core clocks.
  static void start(std::uint32_t core_Hz, std::uint32_t rate_Hz) {
    using namespace sys_tick_control;
    auto& timer = sys_tick();
    timer.control = 0;
    timer.reload = (core_Hz + rate_Hz / 2) / rate_Hz - 1;
    timer.current = 0;
    running_ = true;
    timer.control = enable | interrupts | core_clock;
  }

  static void stop() {
    running_ = false;
    sys_tick().control = 0;
    system_control().interrupt_control = interrupt_control::clear_pending_sys_tick;
  }

  /// The timer may run on for somebody else (emulated_watchdog.hpp): then it counts nothing.
  static void interrupt() {
    if (running_) count_ = count_ + 1;
  }

  /// Ticks since the start of the image; wraps.
  static std::uint32_t count() { return count_; }
  /// Core clocks left of the present one.
  static std::uint32_t phase() { return sys_tick().current; }

 private:
  inline static volatile std::uint32_t count_ = 0;
  inline static volatile bool running_ = false;
};

}  // namespace axial::hal::cortex_m
