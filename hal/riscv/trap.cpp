/// The one entry of all traps (direct mode), and what happens then. One exception goes on: a semihosting breakpoint
/// without a listener is stepped over, which happens once, at start-up, while the drives are off.

#include <hal/riscv/trap.hpp>

#include <board.hpp>

#include <hal/failure.hpp>
#include <hal/kept.hpp>
#include <hal/memory.hpp>
#include <hal/riscv/csr.hpp>
#include <hal/riscv/semihosting.hpp>

namespace axial::hal::riscv {
namespace {

bool is_unanswered_semihosting(std::uint32_t cause, std::uint32_t pc) {
  constexpr std::uint32_t breakpoint_cause = 3;
  if (cause != breakpoint_cause) return false;
  const auto* at = reinterpret_cast<const std::uint32_t*>(pc);
  return pc % 4 == 0 && at[-1] == Breakpoint::before && at[0] == Breakpoint::itself && at[1] == Breakpoint::after;
}

void step_over(TrapFrame& frame, std::uint32_t pc) {
  Semihosting::unanswered = true;
  frame.a0 = ~0u;
  write<Csr::exception_pc>(pc + 4);
}

bool is_interrupt(std::uint32_t cause) { return (cause & interrupt_cause) != 0; }

FaultReport make_report(const TrapFrame& frame, std::uint32_t pointer, std::uint32_t cause) {
  const std::uint32_t value = read<Csr::trap_value>(), room = is_interrupt(cause) ? interrupt_room : 0;
  const bool overflow = overflowed(reinterpret_cast<std::uintptr_t>(axial_stack_bottom), pointer, room, value);
  return {0,        overflow ? ResetCause::stack_overflow : ResetCause::fault,
          cause,    read<Csr::exception_pc>(),
          frame.ra, pointer,
          0,        0,
          value,    0};
}

[[noreturn]] void fail(const FaultReport& report) {
  give_up<Board>(report, axial_fault_report);
  for (;;) {
  }
}

}  // namespace
}  // namespace axial::hal::riscv

/// Interrupts, on the main stack.
extern "C" [[gnu::used]] void axial_interrupt(axial::hal::riscv::TrapFrame* frame) {
  using namespace axial::hal::riscv;
  using axial::hal::Board;
  const std::uint32_t cause = read<Csr::cause>();
  if (cause == (interrupt_cause | timer_cause)) return Board::timer_interrupt();
  if (cause == (interrupt_cause | external_cause) && Board::Controller::serve(Board::interrupts)) return;
  fail(make_report(*frame, static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(frame + 1)), cause));
}

/// Exceptions, and interrupts without room on the main stack; on the stack of faults. `pointer` is the main stack's.
extern "C" [[gnu::used]] void axial_exception(axial::hal::riscv::TrapFrame* frame, std::uint32_t pointer) {
  using namespace axial::hal::riscv;
  const std::uint32_t cause = read<Csr::cause>(), pc = read<Csr::exception_pc>();
  if (is_unanswered_semihosting(cause, pc)) return step_over(*frame, pc);
  fail(make_report(*frame, pointer, cause));
}

extern "C" void axial_watchdog_expired() { axial::hal::Board::fail(axial::hal::ResetCause::watchdog); }

/// An interrupt looks at the stack before it trusts it. Anything else disables the drives by one store, before anything
/// that a stack is needed for, and goes on with a stack of its own. Traps do not nest: the processor masks interrupts
/// until mret.
extern "C" [[gnu::naked, gnu::aligned(4)]] void axial_trap_entry() {
  using Pin = axial::hal::Board::DrivePin;
  asm volatile(
      ".macro save_registers\n\t"
      "addi sp, sp, -64\n\t"
      "sw ra, 0(sp)\n\tsw t0, 4(sp)\n\tsw t1, 8(sp)\n\tsw t2, 12(sp)\n\t"
      "sw a0, 16(sp)\n\tsw a1, 20(sp)\n\tsw a2, 24(sp)\n\tsw a3, 28(sp)\n\t"
      "sw a4, 32(sp)\n\tsw a5, 36(sp)\n\tsw a6, 40(sp)\n\tsw a7, 44(sp)\n\t"
      "sw t3, 48(sp)\n\tsw t4, 52(sp)\n\tsw t5, 56(sp)\n\tsw t6, 60(sp)\n\t"
      "mv a0, sp\n\t"
      ".endm\n\t"
      ".macro restore_registers\n\t"
      "lw ra, 0(sp)\n\tlw t0, 4(sp)\n\tlw t1, 8(sp)\n\tlw t2, 12(sp)\n\t"
      "lw a0, 16(sp)\n\tlw a1, 20(sp)\n\tlw a2, 24(sp)\n\tlw a3, 28(sp)\n\t"
      "lw a4, 32(sp)\n\tlw a5, 36(sp)\n\tlw a6, 40(sp)\n\tlw a7, 44(sp)\n\t"
      "lw t3, 48(sp)\n\tlw t4, 52(sp)\n\tlw t5, 56(sp)\n\tlw t6, 60(sp)\n\t"
      "addi sp, sp, 64\n\t"
      ".endm\n\t"
      "csrw mscratch, t0\n\t"
      "csrr t0, mcause\n\t"
      "bgez t0, 1f\n\t"
      "la t0, axial_stack_bottom + %0\n\t"
      "bltu sp, t0, 1f\n\t"
      "csrr t0, mscratch\n\t"
      "save_registers\n\t"
      "call axial_interrupt\n\t"
      "restore_registers\n\t"
      "mret\n"
      // Two words at the bottom of the stack of faults keep t1 and sp. No address is taken from gp: it may be wrong.
      ".option push\n\t.option norelax\n"
      "1:\tla t0, axial_fault_stack\n\t"
      "sw t1, 0(t0)\n\t"
      "la t0, %1\n\t"
      "li t1, %2\n\t"
      "sw t1, 0(t0)\n\t"
      "la t0, axial_fault_stack\n\t"
      "lw t1, 0(t0)\n\t"
      "sw sp, 4(t0)\n\t"
      "addi sp, t0, %3\n\t"
      "la gp, __global_pointer$\n\t"
      ".option pop\n\t"
      "csrr t0, mscratch\n\t"
      "save_registers\n\t"
      "lw a1, axial_fault_stack + 4\n\t"
      "call axial_exception\n\t"
      "restore_registers\n\t"
      "lw sp, axial_fault_stack + 4\n\t"
      "mret" ::"i"(axial::hal::guard_bytes + axial::hal::riscv::interrupt_room),
      "i"(Pin::off_register), "i"(Pin::off_word), "i"(axial::hal::fault_stack_bytes));
}
