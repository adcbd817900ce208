#pragma once
/// The guard under the stack: an entry of the physical memory protection that allows reads, for the paint in it, and
/// no writes; execution too, because the RP2350 has the bits of both exchanged (erratum RP2350-E6). Locked, so that it
/// binds machine mode. Source: Privileged Architecture 20211203, 3.7.

#include <cstdint>

#include <hal/memory.hpp>
#include <hal/riscv/csr.hpp>

namespace axial::hal::riscv {

namespace protection {
constexpr std::uint32_t read = 1u << 0, execute = 1u << 2, power_of_two = 3u << 3, locked = 1u << 7;
}

/// pmpaddr of `bytes`, a power of two of 8 or more, at `begin`, a multiple of it.
constexpr std::uint32_t power_of_two_region(std::uintptr_t begin, std::uintptr_t bytes) {
  return static_cast<std::uint32_t>(begin >> 2 | (bytes / 8 - 1));
}

#ifdef __riscv
/// Entry 1; entry 0 protects the code (start_up.cpp). An emulator that keeps locked entries over a reset keeps this
/// one, with the same bounds.
inline bool guard_stack() {
  constexpr std::uint32_t guard =
      protection::read | protection::execute | protection::power_of_two | protection::locked;
  write<Csr::pmp_address_1>(power_of_two_region(reinterpret_cast<std::uintptr_t>(axial_stack_bottom), guard_bytes));
  set<Csr::pmp_configuration_0>(guard << 8);
  return (read<Csr::pmp_configuration_0>() >> 8 & 0xFFu) == guard;
}
#endif

}  // namespace axial::hal::riscv
