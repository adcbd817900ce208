#pragma once
/// What every board does alike, whatever its core. A board derives from its core's own base
/// (hal/<core>/board_base.hpp), which derives from this.

#include <cstddef>
#include <cstdint>

#include <hal/clock.hpp>
#include <hal/counter.hpp>
#include <hal/memory.hpp>

namespace axial::hal {

/// `Derived` gives: baud, Serial, serial_line, start_clock(), connect_pins(); where they differ, tick_Hz and Tick too.
/// `Core` gives: Counter, Tick, Known, start(), enable_interrupt(line), sleep_unless(predicate), print(text),
/// exit(code). See hal/README.md for the whole interface.
template <class Derived, class Core>
struct BoardBase {
  using Counter = typename Core::Counter;
  using Tick = typename Core::Tick;
  using Known = typename Core::Known;
  /// Rate of the control tick: a set-point and its answer must fit one tick on the serial line.
  static constexpr std::uint32_t tick_Hz = 1000;

  /// Console, clock, serial port, counter; in this order, because the port's divider follows the clock.
  static void start() {
    Core::start();
    clock_ = Derived::start_clock();
    Derived::connect_pins();
    baud_ = Derived::Serial::start(clock_.uart_Hz, Derived::baud);
    Core::enable_interrupt(Derived::serial_line);
    Counter::start();
  }

  static const ClockReport& clock() { return clock_; }
  static std::uint32_t baud_running() { return baud_; }

  static bool read(std::uint8_t& byte) { return Derived::Serial::read(byte); }
  static bool write(const std::uint8_t* bytes, std::size_t count) { return Derived::Serial::write(bytes, count); }
  static bool serial_idle() { return Derived::Serial::idle(); }
  static std::uint32_t overruns() { return Derived::Serial::overruns(); }

  static void start_tick(std::uint32_t rate_Hz) { Derived::Tick::start(clock_.core_Hz, rate_Hz); }
  static void stop_tick() { Derived::Tick::stop(); }
  static std::uint32_t ticks() { return Derived::Tick::count(); }

  /// Sleeps until an interrupt, unless `awake()`.
  template <class Predicate>
  static void sleep_unless(Predicate awake) {
    Core::sleep_unless(awake);
  }

  static CounterScale counter_scale() { return Counter::scale(); }
  static std::uint32_t empty_bracket() { return Counter::empty(); }

  /// Instructions (QEMU) or cycles (silicon) of `code()`, the empty bracket subtracted.
  template <class Code>
  static std::uint32_t count(Code& code) {
    return Counter::count([](void* object) { (*static_cast<Code*>(object))(); }, &code);
  }

  static std::uint32_t stack_used_bytes() { return hal::stack_used_bytes(); }

  static void print(const char* text) { Core::print(text); }
  static void exit(int code) { Core::exit(code); }

 private:
  inline static ClockReport clock_{};
  inline static std::uint32_t baud_ = 0;
};

}  // namespace axial::hal
