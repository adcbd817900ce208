#pragma once
/// Semihosting by the breakpoint of M-profile cores (Arm IHI 0100, 3.1).

#include <cstdint>

#include <hal/semihosting.hpp>

namespace axial::hal::cortex_m {

struct Breakpoint {
  static std::uint32_t call(std::uint32_t operation, const void* argument) {
    register std::uint32_t r0 asm("r0") = operation;
    register const void* r1 asm("r1") = argument;
    asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory", "cc");
    return r0;
  }
};

using Semihosting = hal::Semihosting<Breakpoint>;

}  // namespace axial::hal::cortex_m
