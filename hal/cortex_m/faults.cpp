/// Fault handlers: record, report, stop. One exception: a semihosting breakpoint without a listener is stepped over.

#include <hal/cortex_m/faults.hpp>

#include <hal/cortex_m/registers.hpp>
#include <hal/cortex_m/semihosting.hpp>
#include <hal/text.hpp>

namespace axial::hal::cortex_m {

[[gnu::section(".noinit")]] FaultRecord fault_record;

namespace {

constexpr std::uint32_t hard_fault_by_debug_event = 1u << 31;

bool is_unanswered_semihosting(const ExceptionFrame& frame) {
  constexpr std::uint16_t breakpoint_ab = 0xBEAB;
  return (system_control().hard_fault & hard_fault_by_debug_event) != 0 &&
         *reinterpret_cast<const std::uint16_t*>(frame.pc) == breakpoint_ab;
}

void step_over(ExceptionFrame& frame) {
  semihosting::unanswered = true;
  frame.r0 = ~0u;
  frame.pc += 2;
  system_control().hard_fault = hard_fault_by_debug_event;  // written ones clear
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

void write_line(const char* name, std::uint32_t value) {
  semihosting::write(name);
  semihosting::write(hex(value).text);
  semihosting::write("\n");
}

void report() {
  write_line("fault: exception ", fault_record.exception);
  write_line("  pc   ", fault_record.pc);
  write_line("  lr   ", fault_record.lr);
  write_line("  cfsr ", fault_record.configurable_fault);
  write_line("  hfsr ", fault_record.hard_fault);
}

}  // namespace
}  // namespace axial::hal::cortex_m

extern "C" [[gnu::used]] void axial_fault_with_frame(axial::hal::cortex_m::ExceptionFrame* frame) {
  using namespace axial::hal::cortex_m;
  if (is_unanswered_semihosting(*frame)) return step_over(*frame);
  record(*frame);
  report();
  semihosting::exit(fault_exit_code);
  for (;;)
    asm volatile("wfi");
}

/// Finds the frame: bit 2 of the return code in lr tells which stack holds it.
extern "C" [[gnu::naked]] void axial_fault() {
  asm volatile(
      "tst lr, #4\n\t"
      "ite eq\n\t"
      "mrseq r0, msp\n\t"
      "mrsne r0, psp\n\t"
      "b axial_fault_with_frame");
}
