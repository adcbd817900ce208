#pragma once
/// Semihosting: console and exit through a debugger or an emulator. Source: Arm IHI 0100, "Semihosting for AArch32
/// and AArch64", release 3.0; RISC-V Semihosting 0.4 takes all but the breakpoint from there.
///
/// Compiled in where AXIAL_SEMIHOSTING is 1. On silicon without a debugger the breakpoint is a fault; each core's
/// handler steps over it and notes that nobody answers, so such an image runs on.

#include <cstdint>

#include <hal/text.hpp>

#ifndef AXIAL_SEMIHOSTING
#define AXIAL_SEMIHOSTING 0
#endif

namespace axial::hal {

/// Exit code of an emulated image that faulted.
constexpr int fault_exit_code = 70;

/// `Breakpoint` gives `static std::uint32_t call(std::uint32_t operation, const void* argument)`, the core's own.
template <class Breakpoint>
struct Semihosting {
  /// Set by the handler of faults when a call met no listener.
  inline static volatile bool unanswered = false;

  /// Whether somebody listens; found out once, at start-up, because a handler of faults may not try.
  static void probe() { call(error_number, nullptr); }
  static bool present() { return AXIAL_SEMIHOSTING != 0 && !unanswered; }

  static void write(const char* text) {
    if (present()) call(write_string, text);
  }

  /// A name and a number in hexadecimal. Once in an image.
  [[gnu::noinline]] static void write_line(const char* name, std::uint32_t value) {
    write(name);
    write(hex(value).text);
    write("\n");
  }

  /// Ends the emulator with `code`. Returns where nobody listens.
  static void exit(int code) {
    constexpr std::uint32_t application_exit = 0x20026;
    const std::uint32_t arguments[2] = {application_exit, static_cast<std::uint32_t>(code)};
    if (present()) call(exit_extended, arguments);
  }

 private:
  static constexpr std::uint32_t write_string = 0x04, error_number = 0x13, exit_extended = 0x20;

  static void call(std::uint32_t operation, const void* argument) {
    if constexpr (AXIAL_SEMIHOSTING != 0) Breakpoint::call(operation, argument);
  }
};

}  // namespace axial::hal
