#pragma once
/// Semihosting: console and exit through a debugger or an emulator. Source: Arm IHI 0100, "Semihosting for AArch32
/// and AArch64", release 3.0.
///
/// Compiled in where AXIAL_SEMIHOSTING is 1. On silicon without a debugger the call's breakpoint escalates to a hard
/// fault; the handler in faults.cpp steps over it and notes that nobody answers, so such an image runs on.

#include <cstdint>

#ifndef AXIAL_SEMIHOSTING
#define AXIAL_SEMIHOSTING 0
#endif

namespace axial::hal::cortex_m::semihosting {

enum class Operation : std::uint32_t { write_string = 0x04, error_number = 0x13, exit_extended = 0x20 };

/// Set by the hard fault handler when a call met no listener.
inline volatile bool unanswered = false;

inline std::uint32_t call(Operation operation, const void* argument) {
#if AXIAL_SEMIHOSTING
  register std::uint32_t r0 asm("r0") = static_cast<std::uint32_t>(operation);
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory", "cc");
  return r0;
#else
  static_cast<void>(operation);
  static_cast<void>(argument);
  return ~0u;
#endif
}

/// Whether somebody listens; found out once, at start-up, because a handler of faults may not try.
inline void probe() { call(Operation::error_number, nullptr); }
inline bool present() { return AXIAL_SEMIHOSTING != 0 && !unanswered; }

inline void write(const char* text) {
  if (present()) call(Operation::write_string, text);
}

/// Ends the emulator with `code`. Returns where nobody listens.
inline void exit(int code) {
  constexpr std::uint32_t application_exit = 0x20026;
  const std::uint32_t arguments[2] = {application_exit, static_cast<std::uint32_t>(code)};
  if (present()) call(Operation::exit_extended, arguments);
}

}  // namespace axial::hal::cortex_m::semihosting
