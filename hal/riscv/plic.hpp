#pragma once
/// The platform-level interrupt controller, as far as one core in machine mode needs it.
/// Source: RISC-V Platform-Level Interrupt Controller Specification 1.0.0.

#include <cstdint>

#include <hal/interrupt.hpp>
#include <hal/riscv/core.hpp>

namespace axial::hal::riscv {

/// `Platform` gives `plic()`, the first word of the controller's registers; context 0 is this core's machine mode.
template <class Platform>
struct Plic {
  static void enable(unsigned line) {
    volatile auto* registers = Platform::plic();
    registers[line] = 1;  // priority: above the threshold
    registers[enables + line / 32] = registers[enables + line / 32] | 1u << (line % 32);
    registers[threshold] = 0;
    set<Csr::interrupt_enable>(1u << external_cause);
  }

  /// Serves every line that waits. `interrupts` lists lines and handlers; false where a line has no handler.
  template <class Interrupts>
  static bool serve(const Interrupts& interrupts) {
    volatile auto* registers = Platform::plic();
    while (const std::uint32_t line = registers[claim]) {
      if (!call_handler(interrupts, line)) return false;
      registers[claim] = line;
    }
    return true;
  }

 private:
  static constexpr unsigned enables = 0x2000 / 4, threshold = 0x200000 / 4, claim = 0x200004 / 4;
};

}  // namespace axial::hal::riscv
