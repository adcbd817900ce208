#pragma once
/// What every Cortex-M board does alike. A board derives from this and adds its clocks, pins and serial port.

#include <cstdint>

#include <hal/clock.hpp>
#include <hal/cortex_m/core.hpp>
#include <hal/cortex_m/counter.hpp>
#include <hal/cortex_m/semihosting.hpp>
#include <hal/cortex_m/start_up.hpp>
#include <hal/cortex_m/tick.hpp>

namespace axial::hal::cortex_m {

/// `Derived` gives: emulator_Hz, baud, start_clock() and Serial. See hal/README.md for the whole interface.
template <class Derived, std::uint32_t emulator_Hz_, std::uint32_t instruction_ns = usual_instruction_ns>
struct BoardBase {
  using Counter = cortex_m::Counter<emulator_Hz_, instruction_ns>;
  static constexpr std::uint32_t emulator_Hz = emulator_Hz_;

  /// Clock, serial port, counter; in this order, because the port's divider follows the clock.
  static void start() {
    semihosting::probe();
    clock_ = Derived::start_clock();
    Derived::connect_pins();
    baud_ = Derived::Serial::start(clock_.uart_Hz, Derived::baud);
    enable_interrupt(Derived::serial_line);
    Counter::start();
  }

  static const ClockReport& clock() { return clock_; }
  static std::uint32_t baud_running() { return baud_; }

  static bool read(std::uint8_t& byte) { return Derived::Serial::read(byte); }
  static bool write(const std::uint8_t* bytes, std::size_t count) { return Derived::Serial::write(bytes, count); }
  static bool serial_idle() { return Derived::Serial::idle(); }
  static std::uint32_t overruns() { return Derived::Serial::overruns(); }

  static void start_tick(std::uint32_t rate_Hz) { Tick::start(clock_.core_Hz, rate_Hz); }
  static void stop_tick() { Tick::stop(); }
  static std::uint32_t ticks() { return Tick::count(); }
  static void tick_interrupt() { Tick::interrupt(); }

  /// Sleeps until an interrupt, unless `awake()`.
  template <class Predicate>
  static void sleep_unless(Predicate awake) {
    cortex_m::sleep_unless(awake);
  }

  static CounterScale counter_scale() { return Counter::scale(); }
  static std::uint32_t empty_bracket() { return Counter::empty(); }

  /// Instructions (QEMU) or cycles (silicon) of `code()`, the empty bracket subtracted.
  template <class Code>
  static std::uint32_t count(Code& code) {
    return Counter::count([](void* object) { (*static_cast<Code*>(object))(); }, &code);
  }

  static std::uint32_t stack_used_bytes() { return cortex_m::stack_used_bytes(); }

  static void print(const char* text) { semihosting::write(text); }
  static void exit(int code) { semihosting::exit(code); }

 private:
  inline static ClockReport clock_{};
  inline static std::uint32_t baud_ = 0;
};

}  // namespace axial::hal::cortex_m
