#pragma once
/// What a fault leaves on the stack, and what a report says of it.

#include <cstdint>

#include <hal/cortex_m/registers.hpp>
#include <hal/fault_report.hpp>

namespace axial::hal::cortex_m {

/// Registers that the processor pushes on entry to a handler (DDI 0403E, B1.5.6).
struct ExceptionFrame {
  std::uint32_t r0, r1, r2, r3, r12, lr, pc, xpsr;
};

/// Where the stack lies: its guard from `bottom` to `guard_end`.
struct StackBounds {
  std::uintptr_t bottom, guard_end, top;

  /// Whether a frame at `address` lies in the stack, guard included.
  constexpr bool holds_frame(std::uintptr_t address) const {
    return address >= bottom && address % 4 == 0 && address + sizeof(ExceptionFrame) <= top;
  }
};

/// The address that was refused, 0 where the processor does not know it.
constexpr std::uint32_t refused_address(std::uint32_t status, std::uint32_t memory, std::uint32_t bus) {
  if ((status & configurable_fault::memory_address_valid) != 0) return memory;
  return (status & configurable_fault::bus_address_valid) != 0 ? bus : 0;
}

/// The stack overflowed where the fault's own frame, at `frame`, has reached the guard, where a frame did not fit at
/// all, or where the refused address lies in the guard.
constexpr bool overflowed(const StackBounds& stack, std::uintptr_t frame, std::uint32_t status, std::uint32_t address) {
  return frame < stack.guard_end || (status & configurable_fault::stacking) != 0 ||
         (address >= stack.bottom && address < stack.guard_end);
}

}  // namespace axial::hal::cortex_m

/// Entry of every fault and of every interrupt without a handler.
extern "C" void axial_fault();
