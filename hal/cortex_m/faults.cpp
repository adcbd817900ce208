/// Fault handlers: record, report, stop. One exception: a semihosting breakpoint without a listener is stepped over.

#include <hal/cortex_m/faults.hpp>

#include <hal/cortex_m/registers.hpp>
#include <hal/cortex_m/semihosting.hpp>
#include <hal/memory.hpp>

namespace axial::hal::cortex_m {

[[gnu::section(".noinit")]] FaultRecord fault_record;

namespace {

/// A breakpoint that no debugger takes escalates to a hard fault and leaves the configurable faults clear; any other
/// fault sets one of them (not on ARMv6-M, which has none), and its pc need not be readable.
bool is_unanswered_semihosting(const ExceptionFrame& frame) {
  constexpr std::uint16_t breakpoint_ab = 0xBEAB;
  const auto* at = reinterpret_cast<const std::uint16_t*>(frame.pc);
  return system_control().configurable_fault == 0 && at >= axial_code_begin && at < axial_code_end &&
         *at == breakpoint_ab;
}

void step_over(ExceptionFrame& frame) {
  Semihosting::unanswered = true;
  frame.r0 = ~0u;
  frame.pc += 2;
  system_control().hard_fault = system_control().hard_fault;  // written ones clear
}

void record(const ExceptionFrame& frame) {
  auto& control = system_control();
  fault_record = {FaultRecord::valid,
                  control.interrupt_control & 0x1FFu,
                  frame.pc,
                  frame.lr,
                  control.configurable_fault,
                  control.hard_fault,
                  control.memory_address,
                  control.bus_address};
}

void report() {
  Semihosting::write_line("fault: exception ", fault_record.exception);
  Semihosting::write_line("  pc   ", fault_record.pc);
  Semihosting::write_line("  lr   ", fault_record.lr);
  Semihosting::write_line("  cfsr ", fault_record.configurable_fault);
  Semihosting::write_line("  hfsr ", fault_record.hard_fault);
}

}  // namespace
}  // namespace axial::hal::cortex_m

/// `frame` is null where the stack ran out of RAM: then nothing could be saved.
extern "C" [[gnu::used]] void axial_fault_with_frame(axial::hal::cortex_m::ExceptionFrame* frame) {
  using namespace axial::hal::cortex_m;
  if (frame != nullptr && is_unanswered_semihosting(*frame)) return step_over(*frame);
  if (frame == nullptr) Semihosting::write("fault: the stack overflowed\n");
  record(frame != nullptr ? *frame : ExceptionFrame{});
  report();
  Semihosting::exit(axial::hal::fault_exit_code);
  for (;;)
    asm volatile("wfi");
}

/// Finds the frame: bit 2 of the return code in lr tells which stack holds it. An overflown stack starts afresh.
/// Only instructions that ARMv6-M has too.
extern "C" [[gnu::naked]] void axial_fault() {
  asm volatile(
      "mov r0, lr\n\t"
      "movs r1, #4\n\t"
      "tst r0, r1\n\t"
      "beq 1f\n\t"
      "mrs r0, psp\n\t"
      "b 2f\n"
      "1:\tmrs r0, msp\n"
      "2:\tldr r1, =axial_stack_bottom\n\t"
      "cmp r0, r1\n\t"
      "bhs 3f\n\t"
      "movs r0, #0\n\t"
      "ldr r1, =axial_stack_top\n\t"
      "mov sp, r1\n"
      "3:\tldr r1, =axial_fault_with_frame\n\t"
      "bx r1\n\t"
      ".ltorg");
}
