#pragma once
/// Control and status registers of machine mode. Source: The RISC-V Instruction Set Manual, volume II: Privileged
/// Architecture, version 20211203, chapters 2 and 3.

#include <cstdint>

namespace axial::hal::riscv {

enum class Csr : unsigned {
  status = 0x300,
  interrupt_enable = 0x304,
  trap_vector = 0x305,
  count_inhibit = 0x320,
  exception_pc = 0x341,
  cause = 0x342,
  trap_value = 0x343,
  pmp_configuration_0 = 0x3A0,
  pmp_address_0 = 0x3B0,
  pmp_address_1 = 0x3B1,
  retired_high = 0xB82,
  architecture_id = 0xF12
};

template <Csr csr>
std::uint32_t read() {
  std::uint32_t value;
  asm volatile("csrr %0, %1" : "=r"(value) : "i"(csr) : "memory");
  return value;
}
template <Csr csr>
void write(std::uint32_t value) {
  asm volatile("csrw %0, %1" ::"i"(csr), "r"(value) : "memory");
}
template <Csr csr>
void set(std::uint32_t bits) {
  asm volatile("csrs %0, %1" ::"i"(csr), "r"(bits) : "memory");
}
/// Returns what the register held before.
template <Csr csr>
std::uint32_t clear(std::uint32_t bits) {
  std::uint32_t before;
  asm volatile("csrrc %0, %1, %2" : "=r"(before) : "i"(csr), "r"(bits) : "memory");
  return before;
}

namespace status {
constexpr std::uint32_t interrupts = 1u << 3;
}
/// Bits of Csr::interrupt_enable; their numbers are the causes too.
constexpr std::uint32_t timer_cause = 7, external_cause = 11, interrupt_cause = 1u << 31;

}  // namespace axial::hal::riscv
