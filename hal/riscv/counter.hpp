#pragma once
/// Count of the instructions that a piece of code retires, by minstret.
///
/// QEMU 7.2 with `-icount shift=6` shows virtual time in minstret, 64 ns per instruction; a part, and QEMU without that
/// flag, shows instructions. The empty bracket, whose instructions are known, tells which.

#include <cstdint>

#include <hal/counter.hpp>
#include <hal/riscv/core.hpp>
#include <hal/riscv/known_code.hpp>

namespace axial::hal::riscv {

/// Calls `code(argument)`; returns by how much minstret's lower half grew. Between the two reads lie `jalr` and the
/// code, nothing else, whatever the compiler.
[[gnu::naked, gnu::noinline]] inline std::uint32_t bracket(Measured, void*) {
  asm volatile(
      "addi sp, sp, -16\n\t"
      "sw ra, 12(sp)\n\t"
      "sw s0, 8(sp)\n\t"
      "mv t0, a0\n\t"
      "mv a0, a1\n\t"
      "csrr s0, minstret\n\t"
      "jalr t0\n\t"
      "csrr t0, minstret\n\t"
      "sub a0, t0, s0\n\t"
      "lw s0, 8(sp)\n\t"
      "lw ra, 12(sp)\n\t"
      "addi sp, sp, 16\n\t"
      "ret");
}

/// The counter of a core that its board.json emulates with `instruction_ns` of virtual time an instruction.
template <std::uint32_t instruction_ns>
class Counter {
 public:
  /// Instructions per second in the emulator.
  static constexpr std::uint32_t per_second = 1'000'000'000u / instruction_ns;
  /// More instructions than these do not fit the counter's lower half in the emulator.
  static constexpr std::uint32_t span = 0xFFFFFFFFu / instruction_ns;

  /// Finds out what minstret shows; measures the empty bracket.
  static void start() {
    const bool shows_instructions = raw(KnownCode::block<0>, nullptr) == KnownCode::empty_bracket;
    raw_per_instruction_ = shows_instructions ? 1 : instruction_ns;
    empty_ = 0;
    empty_ = count(KnownCode::block<0>, nullptr);
  }

  static CounterScale scale() { return {CounterKind::instructions, 1, raw_per_instruction_}; }

  /// The empty bracket: read, call and return. Already subtracted from every count.
  static std::uint32_t empty() { return empty_; }

  /// Instructions of `code(argument)`, without the call and the return; interrupts masked. `count_overflow` where the
  /// lower half of minstret did not suffice.
  static std::uint32_t count(Measured code, void* argument) {
    const InterruptMask mask;
    const std::uint64_t begin = retired();
    const std::uint32_t counted = raw(code, argument);
    if (retired() - begin > 0xFFFFFFFFu) return count_overflow;
    return counted / raw_per_instruction_ - empty_;
  }

 private:
  static std::uint32_t raw(Measured code, void* argument) { return bracket(code, argument); }

  static std::uint64_t retired() {
    while (true) {
      std::uint32_t low;
      const std::uint32_t high = read<Csr::retired_high>();
      asm volatile("csrr %0, minstret" : "=r"(low)::"memory");
      if (read<Csr::retired_high>() == high) return std::uint64_t{high} << 32 | low;
    }
  }

  inline static std::uint32_t raw_per_instruction_ = 1, empty_ = 0;
};

}  // namespace axial::hal::riscv
