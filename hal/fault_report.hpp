#pragma once
/// Why the board started, and what a fault leaves behind for the next start.

#include <cstddef>
#include <cstdint>

namespace axial::hal {

enum class ResetCause : std::uint32_t {
  power_on = 0,        ///< supply or reset pin
  watchdog = 1,        ///< nobody fed it in time
  fault = 2,           ///< the processor refused an instruction or an access
  stack_overflow = 3,  ///< the guard under the stack was touched
  software = 4,        ///< Board::reset()
  unknown = 5          ///< the part names another reason, or the report does not match its check word
};

/// Kept in RAM that start-up leaves alone; believed only with its mark and its check word.
struct FaultReport {
  static constexpr std::uint32_t fresh = 0xFA17FA17;  ///< mark of a report that no start has seen
  static constexpr std::uint32_t told = 0x701DFA17;   ///< mark of a report of an earlier start

  std::uint32_t mark;
  ResetCause cause;
  std::uint32_t exception;        ///< Arm: number of the exception; RISC-V: mcause
  std::uint32_t program_counter;  ///< 0 where the processor could not save it
  std::uint32_t return_address;   ///< lr or ra, as it was
  std::uint32_t stack_pointer;
  std::uint32_t status;       ///< Arm: CFSR, 0 on ARMv6-M; RISC-V: 0
  std::uint32_t hard_status;  ///< Arm: HFSR, 0 on ARMv6-M; RISC-V: 0
  std::uint32_t address;      ///< address that was refused, where the processor knows it
  std::uint32_t check;        ///< over all words above
};

/// Differs for any two reports that differ in one word: each step is a bijection of the sum. Source: FNV-1a, by words.
/// Once in an image, as all that only restarts need: flash is dearer than time there.
[[gnu::noinline]] constexpr std::uint32_t check_word(const FaultReport& report) {
  std::uint32_t sum = 2166136261u;
  const auto add = [&sum](std::uint32_t word) { sum = (sum ^ word) * 16777619u; };
  add(report.mark);
  add(static_cast<std::uint32_t>(report.cause));
  add(report.exception);
  add(report.program_counter);
  add(report.return_address);
  add(report.stack_pointer);
  add(report.status);
  add(report.hard_status);
  add(report.address);
  return sum;
}

constexpr void seal(FaultReport& report, std::uint32_t mark) {
  report.mark = mark;
  report.check = check_word(report);
}

/// Whether the report is whole, be it fresh or told.
constexpr bool sound(const FaultReport& report) {
  return (report.mark == FaultReport::fresh || report.mark == FaultReport::told) && report.check == check_word(report);
}

/// Why the board started: a fresh report tells, else the part's own flags, `hardware`. Called once after a reset; the
/// report is marked as told, so that the next reset is not blamed on it.
constexpr ResetCause take_cause(FaultReport& kept, ResetCause hardware) {
  if (kept.mark != FaultReport::fresh) return hardware;
  const bool whole = sound(kept);
  seal(kept, whole ? FaultReport::told : 0);
  return whole ? kept.cause : ResetCause::unknown;
}

}  // namespace axial::hal
