/// Fault handlers: drives off, report, restart. One exception: a semihosting breakpoint without a listener is stepped
/// over, which happens once, at start-up, while the drives are off.

#include <hal/cortex_m/faults.hpp>

#include <board.hpp>

#include <hal/cortex_m/registers.hpp>
#include <hal/cortex_m/semihosting.hpp>
#include <hal/failure.hpp>
#include <hal/kept.hpp>
#include <hal/memory.hpp>

namespace axial::hal::cortex_m {
namespace {

std::uintptr_t place(const void* p) { return reinterpret_cast<std::uintptr_t>(p); }

StackBounds main_stack() {
  const std::uintptr_t bottom = place(axial_stack_bottom);
  return {bottom, bottom + guard_bytes, place(axial_stack_top)};
}

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

ResetCause cause_of(std::uint32_t exception, bool overflow) {
  constexpr std::uint32_t non_maskable = 2;
  if (Board::watchdog_is_non_maskable && exception == non_maskable) return ResetCause::watchdog;
  return overflow ? ResetCause::stack_overflow : ResetCause::fault;
}

/// Whether the processor could save its registers at `frame`.
bool is_saved(std::uintptr_t frame) {
  return main_stack().holds_frame(frame) && (system_control().configurable_fault & configurable_fault::stacking) == 0;
}

/// `frame` is where the frame should be; `saved` what it holds, zeros where it could not be saved.
FaultReport make_report(std::uintptr_t frame, const ExceptionFrame& saved) {
  auto& control = system_control();
  const std::uint32_t status = control.configurable_fault, exception = control.interrupt_control & 0x1FFu;
  const std::uint32_t address = refused_address(status, control.memory_address, control.bus_address);
  const ResetCause cause = cause_of(exception, overflowed(main_stack(), frame, status, address));
  return {0,       cause, exception, saved.pc, saved.lr, static_cast<std::uint32_t>(frame), status, control.hard_fault,
          address, 0};
}

}  // namespace
}  // namespace axial::hal::cortex_m

extern "C" [[gnu::used]] void axial_fault_with_frame(axial::hal::cortex_m::ExceptionFrame* frame) {
  using namespace axial::hal::cortex_m;
  const bool saved = is_saved(place(frame));
  if (saved && is_unanswered_semihosting(*frame)) return step_over(*frame);
  axial::hal::give_up<axial::hal::Board>(make_report(place(frame), saved ? *frame : ExceptionFrame{}),
                                         axial_fault_report);
}

extern "C" void axial_watchdog_expired() { axial::hal::Board::fail(axial::hal::ResetCause::watchdog); }

/// Disables the drives by one store, before anything that a stack is needed for. Then finds the frame (bit 2 of the
/// return code in lr tells which stack holds it) and goes on with a stack of its own. Only instructions that ARMv6-M
/// has too.
extern "C" [[gnu::naked]] void axial_fault() {
  using Pin = axial::hal::Board::DrivePin;
  asm volatile(
      "ldr r0, =%c0\n\t"
      "ldr r1, =%c1\n\t"
      "str r1, [r0]\n\t"
      "mov r0, lr\n\t"
      "movs r1, #4\n\t"
      "mrs r2, msp\n\t"
      "tst r0, r1\n\t"
      "mrs r0, psp\n\t"
      "bne 1f\n\t"
      "mov r0, r2\n"
      "1:\tldr r3, =axial_fault_stack + %c2\n\t"
      "mov sp, r3\n\t"
      "push {r2, lr}\n\t"
      "bl axial_fault_with_frame\n\t"
      "pop {r2, r3}\n\t"
      "mov sp, r2\n\t"
      "bx r3\n\t"
      ".ltorg" ::"i"(Pin::off_register),
      "i"(Pin::off_word), "i"(axial::hal::fault_stack_bytes));
}
