/// Reset of every RISC-V board.

#include <board.hpp>

#include <hal/memory.hpp>
#include <hal/riscv/csr.hpp>
#include <hal/riscv/stack_guard.hpp>
#include <hal/riscv/trap.hpp>

int main();

extern "C" {
extern char axial_flash_begin[], axial_flash_bytes[];
}

namespace axial::hal::riscv {
namespace {

/// Forbids stores into the image's code for good (PMP): an emulator's flash is RAM, and what runs out of the bottom of
/// the stack must not spoil it. The flash is a power of two long and aligned to it. A core without PMP traps here.
void protect_code() {
  const auto begin = reinterpret_cast<std::uintptr_t>(axial_flash_begin);
  const auto bytes = reinterpret_cast<std::uintptr_t>(axial_flash_bytes);
  write<Csr::pmp_address_0>(power_of_two_region(begin, bytes));
  set<Csr::pmp_configuration_0>(protection::read | protection::execute | protection::power_of_two | protection::locked);
}

}  // namespace
}  // namespace axial::hal::riscv

extern "C" [[gnu::used, noreturn]] void axial_start() {
  using namespace axial::hal::riscv;
  axial::hal::Board::DrivePin::start();
  write<Csr::trap_vector>(static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(axial_trap_entry)));
  protect_code();
  axial::hal::prepare_memory();
  main();
  for (;;)
    asm volatile("wfi");
}

/// First instruction of the image. gp first: what follows may be relaxed to lie relative to it.
extern "C" [[gnu::naked, gnu::section(".vectors"), gnu::used]] void axial_reset() {
  asm volatile(
      ".option push\n\t.option norelax\n\tla gp, __global_pointer$\n\t.option pop\n\t"
      "la sp, axial_stack_top\n\t"
      "j axial_start");
}
