#pragma once
/// The base of a Cortex-M board. A board derives from this and adds its clocks, pins and serial port.

#include <cstdint>

#include <hal/board_base.hpp>
#include <hal/cortex_m/core.hpp>
#include <hal/cortex_m/counter.hpp>
#include <hal/cortex_m/known_code.hpp>
#include <hal/cortex_m/semihosting.hpp>
#include <hal/cortex_m/tick.hpp>
#include <hal/interrupt.hpp>

namespace axial::hal::cortex_m {

/// What hal::BoardBase asks of a core.
template <std::uint32_t emulator_Hz, std::uint32_t instruction_ns>
struct Core {
  using Counter = cortex_m::Counter<emulator_Hz, instruction_ns>;
  using Tick = cortex_m::Tick;
  using Known = KnownCode;

  static void start() { Semihosting::probe(); }
  static void enable_interrupt(unsigned line) { cortex_m::enable_interrupt(line); }
  template <class Predicate>
  static void sleep_unless(Predicate awake) {
    cortex_m::sleep_unless(awake);
  }
  static void print(const char* text) { Semihosting::write(text); }
  static void exit(int code) { Semihosting::exit(code); }
};

/// `Derived` gives what hal::BoardBase asks for, and interrupt_lines, interrupts[]; a part without SysTick its own Tick
/// and sys_tick_interrupt.
template <class Derived, std::uint32_t emulator_Hz_, std::uint32_t instruction_ns = usual_instruction_ns>
struct BoardBase : hal::BoardBase<Derived, Core<emulator_Hz_, instruction_ns>> {
  static constexpr std::uint32_t emulator_Hz = emulator_Hz_;
  static constexpr Handler sys_tick_interrupt = Tick::interrupt;
};

}  // namespace axial::hal::cortex_m
