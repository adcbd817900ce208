/// Goes through everything that ends in a restart, one start after the other, with the drives on each time. The console
/// tells what happens in which order; tests/target/restarts_test.py reads it.

#include <board.hpp>

#include "steps.hpp"

namespace {

using axial::apps::Step;
using axial::apps::steps;
using axial::hal::Board;
using axial::hal::ResetCause;

/// Kept over a reset: how far the image has come.
struct Progress {
  static constexpr std::uint32_t begun = 0x57E9B001;
  std::uint32_t mark, step;
};
[[gnu::section(".noinit")]] Progress progress;

constexpr std::uint32_t step_count = sizeof steps / sizeof *steps;

const char* text(ResetCause cause) {
  constexpr const char* names[] = {"power_on", "watchdog", "fault", "stack_overflow", "software", "unknown"};
  return names[static_cast<std::uint32_t>(cause)];
}

void print_line(const char* name, const char* value) {
  Board::print(name);
  Board::print(value);
  Board::print("\n");
}

void print_drives() {
  print_line("  drives ", Board::drives_enabled() ? "enabled" : "disabled");
  print_line("  pin ", Board::drive_pin() ? "high" : "low");
}

/// Bytes of the fault stack that no fault has touched; its lowest two words are the trap's on RISC-V.
std::uint32_t fault_stack_left() {
  constexpr std::uint32_t words = axial::hal::fault_stack_bytes / sizeof(std::uint32_t), reserved = 2;
  std::uint32_t word = reserved;
  while (word < words && axial_fault_stack[word] == axial::hal::stack_paint)
    ++word;
  return (word - reserved) * static_cast<std::uint32_t>(sizeof(std::uint32_t));
}

void begin() {
  progress = {Progress::begun, 0};
  axial::hal::fill(axial_fault_stack, axial_fault_stack + axial::hal::fault_stack_bytes / sizeof(std::uint32_t),
                   axial::hal::stack_paint);
}

[[noreturn]] void end() {
  print_line("fault stack left ", axial::hal::hex(fault_stack_left()).text);
  Board::exit(0);
  for (;;) {
  }
}

void print_start() {
  print_line("start: ", text(Board::reset_cause()));
  print_drives();
  const auto& report = Board::last_fault();
  if (!sound(report)) return;
  print_line("  reported ", text(report.cause));
  print_line("  reported pc ", axial::hal::hex(report.program_counter).text);
  print_line("  reported address ", axial::hal::hex(report.address).text);
}

}  // namespace

int main() {
  Board::start();
  print_start();
  if (Board::reset_cause() == ResetCause::power_on) begin();
  if (progress.mark != Progress::begun) Board::exit(1);
  if (progress.step == step_count) end();
  const Step& step = steps[progress.step++];
  print_line("step: ", step.name);
  print_line("  guard ", Board::guard_stack() ? "hardware" : "canary");
  print_line("  stack ", Board::stack_intact() ? "intact" : "spoilt");
  Board::start_tick(Board::tick_Hz);
  Board::start_watchdog(axial::apps::watchdog_ms);
  Board::enable_drives(true);
  print_drives();
  step.run();
  print_line("nothing came of ", step.name);
  Board::exit(1);
}
