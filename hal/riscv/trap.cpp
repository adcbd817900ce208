/// The one entry of all traps (direct mode), and what happens then. One exception goes on: a semihosting breakpoint
/// without a listener is stepped over.

#include <hal/riscv/trap.hpp>

#include <board.hpp>

#include <hal/memory.hpp>
#include <hal/riscv/csr.hpp>
#include <hal/riscv/semihosting.hpp>

namespace axial::hal::riscv {

[[gnu::section(".noinit")]] FaultRecord fault_record;

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

[[noreturn]] void stop(const TrapFrame* frame, std::uint32_t cause) {
  if (frame == nullptr) Semihosting::write("fault: the stack overflowed\n");
  fault_record = {FaultRecord::valid, cause, read<Csr::exception_pc>(), frame != nullptr ? frame->ra : 0,
                  read<Csr::trap_value>()};
  Semihosting::write_line("fault: cause ", fault_record.cause);
  Semihosting::write_line("  pc    ", fault_record.pc);
  Semihosting::write_line("  ra    ", fault_record.ra);
  Semihosting::write_line("  value ", fault_record.value);
  Semihosting::exit(fault_exit_code);
  for (;;)
    asm volatile("wfi");
}

bool serve(std::uint32_t cause) {
  if (cause == (interrupt_cause | timer_cause)) {
    Board::Tick::interrupt();
    return true;
  }
  return cause == (interrupt_cause | external_cause) && Board::Plic::serve(Board::interrupts);
}

}  // namespace
}  // namespace axial::hal::riscv

/// `frame` is null where the stack ran out of RAM: then nothing could be saved.
extern "C" [[gnu::used]] void axial_trap(axial::hal::riscv::TrapFrame* frame) {
  using namespace axial::hal::riscv;
  const std::uint32_t cause = read<Csr::cause>(), pc = read<Csr::exception_pc>();
  if (frame != nullptr && serve(cause)) return;
  if (frame != nullptr && is_unanswered_semihosting(cause, pc)) return step_over(*frame, pc);
  stop(frame, cause);
}

/// Looks at the stack before it trusts it; an overflown one starts afresh. Traps do not nest: the processor masks
/// interrupts until mret.
extern "C" [[gnu::naked, gnu::aligned(4)]] void axial_trap_entry() {
  asm volatile(
      "csrw mscratch, t0\n\t"
      "la t0, axial_stack_bottom + %0\n\t"
      "bltu sp, t0, 1f\n\t"
      "csrr t0, mscratch\n\t"
      "addi sp, sp, -64\n\t"
      "sw ra, 0(sp)\n\tsw t0, 4(sp)\n\tsw t1, 8(sp)\n\tsw t2, 12(sp)\n\t"
      "sw a0, 16(sp)\n\tsw a1, 20(sp)\n\tsw a2, 24(sp)\n\tsw a3, 28(sp)\n\t"
      "sw a4, 32(sp)\n\tsw a5, 36(sp)\n\tsw a6, 40(sp)\n\tsw a7, 44(sp)\n\t"
      "sw t3, 48(sp)\n\tsw t4, 52(sp)\n\tsw t5, 56(sp)\n\tsw t6, 60(sp)\n\t"
      "mv a0, sp\n\t"
      "call axial_trap\n\t"
      "lw ra, 0(sp)\n\tlw t0, 4(sp)\n\tlw t1, 8(sp)\n\tlw t2, 12(sp)\n\t"
      "lw a0, 16(sp)\n\tlw a1, 20(sp)\n\tlw a2, 24(sp)\n\tlw a3, 28(sp)\n\t"
      "lw a4, 32(sp)\n\tlw a5, 36(sp)\n\tlw a6, 40(sp)\n\tlw a7, 44(sp)\n\t"
      "lw t3, 48(sp)\n\tlw t4, 52(sp)\n\tlw t5, 56(sp)\n\tlw t6, 60(sp)\n\t"
      "addi sp, sp, 64\n\t"
      "mret\n"
      "1:\tla sp, axial_stack_top\n\t"
      "li a0, 0\n\t"
      "call axial_trap" ::"i"(axial::hal::riscv::trap_room));
}
