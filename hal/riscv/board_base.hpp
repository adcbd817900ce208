#pragma once
/// The base of a RISC-V board. A board derives from this and adds its clocks, pins and serial port.

#include <cstdint>
#include <type_traits>

#include <hal/board_base.hpp>
#include <hal/interrupt.hpp>
#include <hal/riscv/core.hpp>
#include <hal/riscv/counter.hpp>
#include <hal/riscv/known_code.hpp>
#include <hal/riscv/plic.hpp>
#include <hal/riscv/semihosting.hpp>
#include <hal/riscv/stack_guard.hpp>
#include <hal/riscv/timer_tick.hpp>

namespace axial::hal::riscv {

/// The controller of a platform's interrupt lines: its own type `Interrupts`, or the standard one.
template <class Platform, class = void>
struct ControllerOf {
  using Type = Plic<Platform>;
};
template <class Platform>
struct ControllerOf<Platform, std::void_t<typename Platform::Interrupts>> {
  using Type = typename Platform::Interrupts;
};
template <class Platform>
using Controller = typename ControllerOf<Platform>::Type;

/// What hal::BoardBase asks of a core. `Platform`: see timer_tick.hpp and plic.hpp; restart() resets the part.
template <class Platform, std::uint32_t instruction_ns>
struct Core {
  using Counter = riscv::Counter<instruction_ns>;
  using Tick = TimerTick<Platform>;
  using Known = KnownCode;

  /// Interrupts are masked after reset; each line is still off.
  static void start() {
    Semihosting::probe();
    set<Csr::status>(status::interrupts);
  }
  static void enable_interrupt(unsigned line) { Controller<Platform>::enable(line); }
  template <class Predicate>
  static void sleep_unless(Predicate awake) {
    riscv::sleep_unless(awake);
  }
  static void print(const char* text) { Semihosting::write(text); }
  static void print_line(const char* name, std::uint32_t value) { Semihosting::write_line(name, value); }
  static void exit(int code) { Semihosting::exit(code); }

  static void describe(const FaultReport& report) {
    Semihosting::write_line("  cause ", report.exception);
    Semihosting::write_line("  pc    ", report.program_counter);
    Semihosting::write_line("  ra    ", report.return_address);
    Semihosting::write_line("  value ", report.address);
  }
#ifdef __riscv
  static bool guard_stack() { return riscv::guard_stack(); }
#endif
  [[noreturn]] static void restart() { Platform::restart(); }
};

/// `Derived` gives what hal::BoardBase asks for, and interrupts[].
template <class Derived, class Platform, std::uint32_t instruction_ns>
struct BoardBase : hal::BoardBase<Derived, Core<Platform, instruction_ns>> {
  using Controller = riscv::Controller<Platform>;
  static void timer_interrupt() { BoardBase::Tick::interrupt(); }

  /// The machine timer is the watchdog too: the same in the emulator.
  struct Watchdog {
    static void start(std::uint32_t ms) { BoardBase::Tick::watch(ms); }
    static void feed() { BoardBase::Tick::feed(); }
  };
  struct EmulatedWatchdog {
    static void start(std::uint32_t, std::uint32_t) {}
    static void feed() {}
    static void resume() {}
  };
  /// The emulator's core has no clock of its own: an instruction lasts what -icount says.
  static constexpr std::uint32_t emulator_Hz = 1'000'000'000u / instruction_ns;
};

}  // namespace axial::hal::riscv
