#pragma once
/// What a fault leaves behind: readable by a debugger, and after a reset that keeps RAM.

#include <cstdint>

namespace axial::hal::cortex_m {

/// Registers that the processor pushes on entry to a handler (DDI 0403E, B1.5.6).
struct ExceptionFrame {
  std::uint32_t r0, r1, r2, r3, r12, lr, pc, xpsr;
};

struct FaultRecord {
  static constexpr std::uint32_t valid = 0xFA17FA17;
  std::uint32_t mark;  ///< `valid` once a fault was recorded
  std::uint32_t exception, pc, lr;
  std::uint32_t configurable_fault, hard_fault, memory_address, bus_address;
};

extern FaultRecord fault_record;

}  // namespace axial::hal::cortex_m

/// Entry of every fault and of every interrupt without a handler.
extern "C" void axial_fault();
