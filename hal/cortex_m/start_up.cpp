/// Vector table and reset of every Cortex-M board. The build puts the board's folder on the include path.

#include <hal/cortex_m/start_up.hpp>

#include <array>

#include <board.hpp>

#include <hal/cortex_m/faults.hpp>
#include <hal/cortex_m/registers.hpp>

int main();

namespace axial::hal::cortex_m {
namespace {

void fill(std::uint32_t* from, const std::uint32_t* to, std::uint32_t value) {
  while (from < to)
    *from++ = value;
}

void copy(std::uint32_t* from, const std::uint32_t* to, const std::uint32_t* source) {
  while (from < to)
    *from++ = *source++;
}

void paint_stack() {
  const auto* here = static_cast<const std::uint32_t*>(__builtin_frame_address(0));
  fill(axial_stack_bottom, here - 32, stack_paint);  // what lies under the frame is in use
}

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
  using namespace axial::hal::cortex_m;
  allow_fpu();
  copy(axial_data_begin, axial_data_end, axial_data_image);
  fill(axial_bss_begin, axial_bss_end, 0);
  paint_stack();
  main();
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
