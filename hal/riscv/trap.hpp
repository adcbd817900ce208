#pragma once
/// Traps: interrupts to the board's handlers; an exception turns the drives off, is recorded, and restarts.

#include <cstdint>

#include <hal/memory.hpp>

namespace axial::hal::riscv {

/// What the entry of a trap saves: the registers that a function may change, in the order of the stores in trap.cpp.
struct TrapFrame {
  std::uint32_t ra, t0, t1, t2, a0, a1, a2, a3, a4, a5, a6, a7, t3, t4, t5, t6;
};

/// Stack that an interrupt's handler needs above the guard: with less left the stack counts as overflown.
constexpr int interrupt_room = 192;

/// The stack overflowed where its pointer has reached the guard (for an interrupt, the room above it), or where the
/// refused address lies in the guard.
constexpr bool overflowed(std::uintptr_t bottom, std::uintptr_t pointer, std::uintptr_t room, std::uintptr_t address) {
  return pointer < bottom + guard_bytes + room || (address >= bottom && address < bottom + guard_bytes);
}

}  // namespace axial::hal::riscv

/// Entry of every trap.
extern "C" void axial_trap_entry();
