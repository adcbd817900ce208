#pragma once
/// The base of a RISC-V board. A board derives from this and adds its clocks, pins and serial port.

#include <cstdint>

#include <hal/board_base.hpp>
#include <hal/interrupt.hpp>
#include <hal/riscv/core.hpp>
#include <hal/riscv/counter.hpp>
#include <hal/riscv/known_code.hpp>
#include <hal/riscv/plic.hpp>
#include <hal/riscv/semihosting.hpp>
#include <hal/riscv/timer_tick.hpp>

namespace axial::hal::riscv {

/// What hal::BoardBase asks of a core. `Platform`: see timer_tick.hpp and plic.hpp.
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
  static void enable_interrupt(unsigned line) { Plic<Platform>::enable(line); }
  template <class Predicate>
  static void sleep_unless(Predicate awake) {
    riscv::sleep_unless(awake);
  }
  static void print(const char* text) { Semihosting::write(text); }
  static void exit(int code) { Semihosting::exit(code); }
};

/// `Derived` gives what hal::BoardBase asks for, and interrupts[].
template <class Derived, class Platform, std::uint32_t instruction_ns>
struct BoardBase : hal::BoardBase<Derived, Core<Platform, instruction_ns>> {
  using Plic = riscv::Plic<Platform>;
  /// The emulator's core has no clock of its own: an instruction lasts what -icount says.
  static constexpr std::uint32_t emulator_Hz = 1'000'000'000u / instruction_ns;
};

}  // namespace axial::hal::riscv
