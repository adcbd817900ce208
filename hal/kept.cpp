/// Definitions of kept.hpp.

#include <hal/kept.hpp>

extern "C" {
[[gnu::section(".noinit"), gnu::used]] volatile std::uint32_t axial_drives;
[[gnu::section(".noinit.drive_pin")]] volatile std::uint32_t axial_drive_pin;
[[gnu::section(".noinit"), gnu::used]] axial::hal::FaultReport axial_fault_report;
[[gnu::section(".noinit")]] std::uint32_t axial_entropy;
[[gnu::section(".noinit"),
  gnu::used]] alignas(16) std::uint32_t axial_fault_stack[axial::hal::fault_stack_bytes / sizeof(std::uint32_t)];
}
