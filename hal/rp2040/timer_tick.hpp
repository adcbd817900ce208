#pragma once
/// The control tick of the RP2040: alarm 0 of its timer of 64 bits, which counts microseconds. SysTick is left to the
/// counter of cycles. Source: RP2040 Datasheet, 4.6.

#include <cstddef>
#include <cstdint>

#include <hal/rp2040/clock.hpp>

namespace axial::hal::rp2040 {

struct TimerRegisters {
  Register high_write, low_write, high_read, low_read, alarm[4], armed, raw_high, raw_low, debug_pause, pause;
  Register interrupt, interrupt_enable, interrupt_force, interrupt_status;
};
static_assert(offsetof(TimerRegisters, armed) == 0x20 && offsetof(TimerRegisters, interrupt_status) == 0x40);

/// `Port` gives `static TimerRegisters& registers()` and `static void enable_line()`.
template <class Port>
class TimerTick {
  static constexpr std::uint32_t alarm_0 = 1u << 0, clock_Hz = 1'000'000;

 public:
  /// Starts the tick at `rate_Hz`, rounded to whole microseconds.
  static void start(std::uint32_t, std::uint32_t rate_Hz) {
    auto& timer = Port::registers();
    period_ = (clock_Hz + rate_Hz / 2) / rate_Hz;
    timer.interrupt_enable = alarm_0;
    arm(timer.raw_low + period_);
    Port::enable_line();
  }

  static void stop() {
    auto& timer = Port::registers();
    timer.armed = alarm_0;  // a written one disarms
    timer.interrupt_enable = 0;
    timer.interrupt = alarm_0;
  }

  /// An interrupt that was pending while the tick stopped finds no alarm and counts nothing. An alarm that is past
  /// already would come when the counter has wrapped, 71 minutes later: whoever is late goes on from now.
  static void interrupt() {
    auto& timer = Port::registers();
    if ((timer.interrupt_status & alarm_0) == 0) return;
    timer.interrupt = alarm_0;
    count_ = count_ + 1;
    arm(next_ + period_);
    if (static_cast<std::int32_t>(timer.raw_low - next_) >= 0) arm(timer.raw_low + period_);
  }

  /// Ticks since the start of the image; wraps.
  static std::uint32_t count() { return count_; }
  /// Microseconds since the timer started; wraps.
  static std::uint32_t phase() { return Port::registers().raw_low; }

 private:
  static void arm(std::uint32_t when) {
    next_ = when;
    Port::registers().alarm[0] = when;
  }

  inline static std::uint32_t period_ = 0, next_ = 0;
  inline static volatile std::uint32_t count_ = 0;
};

}  // namespace axial::hal::rp2040
