/// Vector table and reset of every Cortex-M board. The build puts the board's folder on the include path.

#include <array>

#include <board.hpp>

#include <hal/cortex_m/faults.hpp>
#include <hal/cortex_m/registers.hpp>
#include <hal/interrupt.hpp>
#include <hal/memory.hpp>

int main();

namespace axial::hal::cortex_m {
namespace {

void allow_fpu() {
#ifdef __ARM_FP
  coprocessor_access() |= fpu_full_access;
  asm volatile("dsb\n\tisb");
#endif
}

struct VectorTable {
  std::uint32_t* stack_top;
  std::array<Handler, 15> core;
  std::array<Handler, Board::interrupt_lines> board;
};

}  // namespace
}  // namespace axial::hal::cortex_m

extern "C" [[gnu::used, noreturn]] void axial_reset() {
  axial::hal::Board::DrivePin::start();
  axial::hal::cortex_m::allow_fpu();
  axial::hal::prepare_memory();
  axial::hal::Board::run([] { main(); });
  for (;;)
    asm volatile("wfi");
}

namespace axial::hal::cortex_m {
namespace {

constexpr VectorTable make_vectors() {
  constexpr std::size_t reset = 0, sys_tick_index = 14;
  VectorTable table{axial_stack_top, {}, {}};
  for (auto& handler : table.core)
    handler = axial_fault;
  for (auto& handler : table.board)
    handler = axial_fault;
  table.core[reset] = axial_reset;
  table.core[sys_tick_index] = Board::sys_tick_interrupt;
  for (const auto& interrupt : Board::interrupts)
    table.board[interrupt.number] = interrupt.handler;
  return table;
}

[[gnu::section(".vectors"), gnu::used]] constexpr VectorTable vectors = make_vectors();

}  // namespace
}  // namespace axial::hal::cortex_m
