#pragma once
/// What every board does alike, whatever its core. A board derives from its core's own base
/// (hal/<core>/board_base.hpp), which derives from this.

#include <cstddef>
#include <cstdint>

#include <hal/clock.hpp>
#include <hal/counter.hpp>
#include <hal/failure.hpp>
#include <hal/kept.hpp>
#include <hal/memory.hpp>
#include <hal/semihosting.hpp>

namespace axial::hal {

/// `Derived` gives: baud, Serial, serial_line, start_clock(), connect_pins(), DrivePin, Watchdog, take_reset_flags();
/// where they differ, tick_Hz and Tick too. `Core` gives: Counter, Tick, Known, EmulatedWatchdog, start(),
/// enable_interrupt(line), sleep_unless(predicate), print(text), print_line(name, value), exit(code),
/// guard_stack(), restart(), describe(report). See hal/README.md for the whole interface.
template <class Derived, class Core>
struct BoardBase {
  using Counter = typename Core::Counter;
  using Tick = typename Core::Tick;
  using Known = typename Core::Known;
  /// Rate of the control tick: a set-point and its answer must fit one tick on the serial line.
  static constexpr std::uint32_t tick_Hz = 1000;
  /// What the self-test expects in the board's emulator: few model a clock, and most count instructions.
  static constexpr ClockSource emulated_clock = ClockSource::emulator;
  static constexpr CounterKind emulated_counter = CounterKind::instructions;

  /// Console, clock, serial port, counter; in this order, because the port's divider follows the clock.
  static void start() {
    Core::start();
    clock_ = Derived::start_clock();
    enable_drives(false);
    cause_ = take_cause(axial_fault_report, Derived::take_reset_flags());
    Derived::connect_pins();
    baud_ = Derived::Serial::start(clock_.uart_Hz, Derived::baud);
    Core::enable_interrupt(Derived::serial_line);
    Counter::start();
  }

  /// The program, as start-up enters it: on this core, where a board has no other wish.
  template <class Program>
  static void run(Program program) {
    program();
  }

  static const ClockReport& clock() { return clock_; }
  /// Whether the image runs in an emulator and may print there. By the clock, where no other register tells.
  static bool emulated() { return AXIAL_SEMIHOSTING != 0 && clock_.source == ClockSource::emulator; }
  static std::uint32_t baud_running() { return baud_; }

  static bool read(std::uint8_t& byte) { return Derived::Serial::read(byte); }
  static bool write(const std::uint8_t* bytes, std::size_t count) { return Derived::Serial::write(bytes, count); }
  static bool serial_idle() { return Derived::Serial::idle(); }
  static std::uint32_t overruns() { return Derived::Serial::overruns(); }

  static void start_tick(std::uint32_t rate_Hz) { Derived::Tick::start(clock_.core_Hz, rate_Hz); }
  static void stop_tick() {
    Derived::Tick::stop();
    if constexpr (AXIAL_SEMIHOSTING != 0) Derived::EmulatedWatchdog::resume();
  }
  static std::uint32_t ticks() { return Derived::Tick::count(); }

  /// Differs from call to call, and from start to start as far as the part allows: made of what RAM held at power-on,
  /// of how often it was asked for since, and of when, to a clock of the tick's timer. Not for secrets.
  static std::uint32_t entropy() {
    axial_entropy = (axial_entropy + Derived::Tick::phase()) * 1664525u + 1013904223u + ticks();
    return axial_entropy;
  }

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

  static bool measure_stack(std::uint32_t& bytes) { return stack_meter_.look(bytes); }

  /// The drives' pin. Off out of reset, and written off by start-up before anything else.
  static void enable_drives(bool on) {
    Derived::DrivePin::set(on);
    const bool were_enabled = drives_enabled();
    axial_drives = on ? 1 : 0;
    if (were_enabled != on && Derived::emulated()) announce_drives(on);
  }
  /// At power-on RAM may hold anything else.
  static bool drives_enabled() { return axial_drives == 1; }
  /// Whether the pin is driven high, by the port's own registers; false in an emulator without them (the STM32s').
  static bool drive_pin() { return Derived::DrivePin::level(); }

  /// From now on the board restarts when `feed_watchdog()` is not called for `ms`; nothing stops it again. Nominal: the
  /// board's README tells how far its oscillator may be off.
  static void start_watchdog(std::uint32_t ms) {
    Derived::Watchdog::start(ms);
    if (Derived::emulated()) Derived::EmulatedWatchdog::start(clock_.core_Hz, ms);
  }
  static void feed_watchdog() {
    Derived::Watchdog::feed();
    if constexpr (AXIAL_SEMIHOSTING != 0) Derived::EmulatedWatchdog::feed();
  }

  /// Why the board started last, found out by `start()`.
  static ResetCause reset_cause() { return cause_; }
  /// What the last fault since power-on left; means nothing unless `sound(report)`.
  static const FaultReport& last_fault() { return axial_fault_report; }

  /// Has hardware guard the lowest `guard_bytes` of the stack: a write there is a fault. False where the part cannot.
  /// From now on a fault restarts an emulated image too, which else ends with `fault_exit_code`.
  static bool guard_stack() {
    guarded_ = true;
    return Core::guard_stack();
  }
  static bool guarded() { return guarded_; }
  /// Whether nothing was written to the guard: to be asked each tick where no hardware does.
  static bool stack_intact() { return hal::stack_intact(); }

  /// Drives off, `cause` noted for the next start, restart.
  [[noreturn]] static void fail(ResetCause cause) {
    FaultReport report{};
    report.cause = cause;
    give_up<Derived>(report, axial_fault_report);
    for (;;) {
    }
  }
  [[noreturn]] static void reset() { fail(ResetCause::software); }

  /// For `give_up`: what a reader of the console learns. An emulated image that never asked for a guard is no firmware
  /// but a test or a measurement: a fault ends it.
  static void describe(const FaultReport& report) {
    if (report.cause == ResetCause::software) return;
    print(headline(report.cause));
    if (report.exception != 0) Core::describe(report);
    if (!guarded_) exit(fault_exit_code);
  }
  [[noreturn]] static void restart() { Core::restart(); }

  static void print(const char* text) { Core::print(text); }
  static void exit(int code) { Core::exit(code); }

 private:
  static const char* headline(ResetCause cause) {
    if (cause == ResetCause::watchdog) return "watchdog: not fed in time\n";
    return cause == ResetCause::stack_overflow ? "fault: the stack overflowed\n" : "fault\n";
  }

  static void announce_drives(bool on) {
    Core::print_line(on ? "drives: enabled at tick " : "drives: disabled at tick ", ticks());
  }

  inline static ClockReport clock_{};
  inline static ResetCause cause_ = ResetCause::unknown;
  inline static bool guarded_ = false;
  inline static StackMeter stack_meter_{axial_stack_bottom, axial_stack_top};
  inline static std::uint32_t baud_ = 0;
};

}  // namespace axial::hal
