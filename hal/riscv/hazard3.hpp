#pragma once
/// Interrupt lines of Hazard3, which are control registers of the core: a line is enabled by its bit in a window of 16,
/// and `next` names one that waits. Source: Hazard3 1.0, "Xh3irq: Hazard3 interrupt controller".

#include <cstdint>

#include <hal/interrupt.hpp>
#include <hal/riscv/csr.hpp>

namespace axial::hal::riscv {

/// The core's identity in Csr::architecture_id.
constexpr std::uint32_t hazard3_architecture = 27;

struct Hazard3Registers {
  static constexpr auto enables = static_cast<Csr>(0xBE0), next_line = static_cast<Csr>(0xBE4);

  /// An emulated core of another make traps at them.
  static bool present() { return read<Csr::architecture_id>() == hazard3_architecture; }
  static void set_enables(std::uint32_t window) { set<enables>(window); }
  static std::uint32_t next() { return read<next_line>(); }
  static void enable_all() { set<Csr::interrupt_enable>(1u << external_cause); }
};

/// `Registers` as above, or what plays them.
template <class Registers>
struct Hazard3Interrupts {
  /// The window's number stands in the low bits, its 16 lines in the upper half.
  static void enable(unsigned line) {
    if (!Registers::present()) return;
    Registers::set_enables(1u << (16 + line % 16) | line / 16);
    Registers::enable_all();
  }

  /// Serves every line that waits. `interrupts` lists lines and handlers; false where a line has no handler.
  template <class Interrupts>
  static bool serve(const Interrupts& interrupts) {
    for (std::uint32_t next = Registers::next(); (next & none) == 0; next = Registers::next()) {
      if (!call_handler(interrupts, next >> 2 & line_mask)) return false;
    }
    return true;
  }

 private:
  static constexpr std::uint32_t none = 1u << 31, line_mask = 0x1FF;
};

}  // namespace axial::hal::riscv
