#pragma once
/// Memory that a reset keeps: start-up neither clears nor fills it. Defined in kept.cpp.

#include <cstddef>
#include <cstdint>

#include <hal/fault_report.hpp>

extern "C" {
/// 1 while the drives' pin says "enabled", else 0: what a test reads where the emulator has no such pin.
extern volatile std::uint32_t axial_drives;
/// The drives' pin of a board without pins: 1 is "enabled".
extern volatile std::uint32_t axial_drive_pin;
/// What the last fault left behind.
extern axial::hal::FaultReport axial_fault_report;
/// What entropy() was last.
extern std::uint32_t axial_entropy;
/// Stack of fault handlers: a fault may mean that the main one cannot be used.
extern std::uint32_t axial_fault_stack[];
}

namespace axial::hal {

/// RISC-V's entry saves all that a function may change, and its frames are longer.
#ifdef __riscv
constexpr std::size_t fault_stack_bytes = 256;
#else
constexpr std::size_t fault_stack_bytes = 192;
#endif

}  // namespace axial::hal
