#pragma once
/// The base of a Cortex-M board. A board derives from this and adds its clocks, pins and serial port.

#include <cstdint>

#include <hal/board_base.hpp>
#include <hal/cortex_m/core.hpp>
#include <hal/cortex_m/counter.hpp>
#include <hal/cortex_m/emulated_watchdog.hpp>
#include <hal/cortex_m/faults.hpp>
#include <hal/cortex_m/semihosting.hpp>
#include <hal/cortex_m/stack_guard.hpp>
#include <hal/cortex_m/tick.hpp>
#include <hal/interrupt.hpp>

namespace axial::hal::cortex_m {

/// What hal::BoardBase asks of a core.
template <class Counter_>
struct Core {
  using Counter = Counter_;
  using Tick = cortex_m::Tick;
  using Known = typename Counter::Known;

  static void start() { Semihosting::probe(); }
  static void enable_interrupt(unsigned line) { cortex_m::enable_interrupt(line); }
  template <class Predicate>
  static void sleep_unless(Predicate awake) {
    cortex_m::sleep_unless(awake);
  }
  static void print(const char* text) { Semihosting::write(text); }
  static void print_line(const char* name, std::uint32_t value) { Semihosting::write_line(name, value); }
  static void exit(int code) { Semihosting::exit(code); }

  static void describe(const FaultReport& report) {
    Semihosting::write_line("  exception ", report.exception);
    Semihosting::write_line("  pc   ", report.program_counter);
    Semihosting::write_line("  lr   ", report.return_address);
    Semihosting::write_line("  cfsr ", report.status);
    Semihosting::write_line("  hfsr ", report.hard_status);
  }
#ifdef __arm__
  static bool guard_stack() { return cortex_m::guard_stack(); }
  [[noreturn]] static void restart() {
    asm volatile("dsb" ::: "memory");
    system_control().reset_control = reset_control::key | reset_control::request;
    for (;;)
      asm volatile("dsb" ::: "memory");
  }
#endif
};

/// `Derived` gives what hal::BoardBase asks for, and interrupt_lines, interrupts[]; a part without SysTick its own Tick
/// and sys_tick_interrupt; a part whose watchdog the emulator has, NoEmulatedWatchdog.
template <class Derived, std::uint32_t emulator_Hz_, class Counter = cortex_m::Counter<emulator_Hz_>>
struct BoardBase : hal::BoardBase<Derived, Core<Counter>> {
  static constexpr std::uint32_t emulator_Hz = emulator_Hz_;
  using EmulatedWatchdog = cortex_m::EmulatedWatchdog<Derived>;
  /// Whether the watchdog warns by a non-maskable interrupt before it restarts the part.
  static constexpr bool watchdog_is_non_maskable = false;

  static void sys_tick_interrupt() {
    Derived::Tick::interrupt();
    if constexpr (AXIAL_SEMIHOSTING != 0) Derived::EmulatedWatchdog::interrupt();
  }
};

}  // namespace axial::hal::cortex_m
