#pragma once
/// The control tick of the nRF51 series, whose Cortex-M0 has no SysTick: TIMER0's compare event at a fixed rate.
/// Source: nRF51 Series Reference Manual 3.0, chapter 18.

#include <cstddef>
#include <cstdint>

namespace axial::hal::nrf51 {

using Register = volatile std::uint32_t;

struct TimerRegisters {
  Register start, stop, count, clear, shut_down;
  Register reserved0[11];
  Register capture[4];
  Register reserved5[60];
  Register compared[4];
  Register reserved1[44];
  Register shortcuts;
  Register reserved2[64];
  Register interrupt_enable_set, interrupt_enable_clear;
  Register reserved3[126];
  Register mode, width, reserved4, prescaler;
  Register reserved6[11];
  Register compare[4];
};
static_assert(offsetof(TimerRegisters, capture) == 0x040);
static_assert(offsetof(TimerRegisters, compared) == 0x140 && offsetof(TimerRegisters, shortcuts) == 0x200);
static_assert(offsetof(TimerRegisters, interrupt_enable_set) == 0x304 && offsetof(TimerRegisters, mode) == 0x504);
static_assert(offsetof(TimerRegisters, prescaler) == 0x510 && offsetof(TimerRegisters, compare) == 0x540);

namespace timer_settings {
constexpr std::uint32_t clear_on_compare_0 = 1u << 0, compare_0_interrupt = 1u << 16, bits_32 = 3;
}

/// `Port` gives `static TimerRegisters& registers()` and `static void enable_line()`.
template <class Port>
class TimerTick {
  static constexpr std::uint32_t clock_Hz = 16'000'000;

 public:
  /// Starts the tick at `rate_Hz`, rounded to whole clocks of the timer's 16 MHz.
  static void start(std::uint32_t, std::uint32_t rate_Hz) {
    using namespace timer_settings;
    auto& timer = Port::registers();
    timer.stop = 1;
    timer.clear = 1;
    timer.mode = 0;
    timer.width = bits_32;
    timer.prescaler = 0;
    timer.compare[0] = (clock_Hz + rate_Hz / 2) / rate_Hz;
    timer.compared[0] = 0;
    timer.shortcuts = clear_on_compare_0;
    timer.interrupt_enable_set = compare_0_interrupt;
    Port::enable_line();
    timer.start = 1;
  }

  static void stop() {
    auto& timer = Port::registers();
    timer.stop = 1;
    timer.interrupt_enable_clear = timer_settings::compare_0_interrupt;
    timer.compared[0] = 0;
  }

  /// An interrupt that was pending while the tick stopped finds no event and counts nothing.
  static void interrupt() {
    auto& timer = Port::registers();
    if (timer.compared[0] == 0) return;
    timer.compared[0] = 0;
    count_ = count_ + 1;
  }

  /// Ticks since the start of the image; wraps.
  static std::uint32_t count() { return count_; }
  /// Clocks of the timer since the last one.
  static std::uint32_t phase() {
    auto& timer = Port::registers();
    timer.capture[1] = 1;
    return timer.compare[1];
  }

 private:
  inline static volatile std::uint32_t count_ = 0;
};

}  // namespace axial::hal::nrf51
