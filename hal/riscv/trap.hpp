#pragma once
/// Traps: interrupts to the board's handlers; exceptions are recorded, reported, and stop the image.

#include <cstdint>

namespace axial::hal::riscv {

/// What the entry of a trap saves: the registers that a function may change, in the order of the stores in trap.cpp.
struct TrapFrame {
  std::uint32_t ra, t0, t1, t2, a0, a1, a2, a3, a4, a5, a6, a7, t3, t4, t5, t6;
};

/// What a fault leaves behind: readable by a debugger, and after a reset that keeps RAM.
struct FaultRecord {
  static constexpr std::uint32_t valid = 0xFA17FA17;
  std::uint32_t mark;  ///< `valid` once a fault was recorded
  std::uint32_t cause, pc, ra, value;
};

extern FaultRecord fault_record;

/// Stack that a trap leaves free for its own handler: below it the stack counts as overflown.
constexpr int trap_room = 192;

}  // namespace axial::hal::riscv

/// Entry of every trap.
extern "C" void axial_trap_entry();
