#pragma once
/// Semihosting by the breakpoint of RISC-V (RISC-V Semihosting 0.4): three instructions that nobody writes by chance.

#include <cstdint>

#include <hal/semihosting.hpp>

namespace axial::hal::riscv {

struct Breakpoint {
  /// slli x0, x0, 0x1f and srai x0, x0, 7, before and after the breakpoint; each is one word, so that all lie in one
  /// page.
  static constexpr std::uint32_t before = 0x01F01013, itself = 0x00100073, after = 0x40705013;

  static std::uint32_t call(std::uint32_t operation, const void* argument) {
    register std::uint32_t a0 asm("a0") = operation;
    register const void* a1 asm("a1") = argument;
    asm volatile(
        ".balign 16\n\t.option push\n\t.option norvc\n\t"
        "slli x0, x0, 0x1f\n\tebreak\n\tsrai x0, x0, 7\n\t"
        ".option pop"
        : "+r"(a0)
        : "r"(a1)
        : "memory");
    return a0;
  }
};

using Semihosting = hal::Semihosting<Breakpoint>;

}  // namespace axial::hal::riscv
