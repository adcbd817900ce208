#pragma once
/// What may go wrong in an image, each on purpose.

#include <board.hpp>

namespace axial::apps {

using hal::Board;

constexpr std::uint32_t watchdog_ms = 200;

struct Step {
  const char* name;
  void (*run)();
};

inline void print_tick(const char* what) {
  Board::print(what);
  Board::print(hal::hex(Board::ticks()).text);
  Board::print("\n");
}

/// The empty assembly makes every frame hold its bytes, and the multiplication after the call keeps it a real call.
[[gnu::noinline]] inline int descend(int depth) {
  volatile char room[64];
  room[0] = static_cast<char>(depth);
  asm volatile("" ::"r"(&room[0]) : "memory");
  return depth == 0 ? 0 : 3 * descend(depth - 1) + room[0];
}

inline void overflow_the_stack() {
  print_tick("  begun at tick ");
  descend(1'000'000);
}

/// Stores to a word of the stack counted from its bottom. Without hardware that guards it, the canary must tell.
inline void store(std::uint32_t word) {
  print_tick("  begun at tick ");
  static_cast<volatile std::uint32_t*>(axial_stack_bottom)[word] = 0;
  if (!Board::stack_intact()) Board::fail(hal::ResetCause::stack_overflow);
}

constexpr std::uint32_t guard_words = hal::guard_bytes / sizeof(std::uint32_t);

inline void store_at_the_bottom() { store(0); }
inline void store_at_the_guards_end() { store(guard_words - 1); }

/// The first word above the guard is the program's; then the image restarts as asked.
inline void store_above_the_guard() {
  store(guard_words);
  Board::reset();
}

/// An address that no processor here executes: Arm's device memory, nothing at all in the RISC-V machine.
inline void jump_astray() {
  print_tick("  begun at tick ");
#ifdef __arm__
  constexpr std::uintptr_t nowhere = 0xA0000001;
#else
  constexpr std::uintptr_t nowhere = 0x05000000;
#endif
  reinterpret_cast<void (*)()>(nowhere)();
}

/// Fed for three times the watchdog's time, which it must bear, then no more.
inline void hang() {
  constexpr std::uint32_t fed_ticks = Board::tick_Hz * watchdog_ms / 1000 * 3;
  for (const std::uint32_t begin = Board::ticks(); Board::ticks() - begin < fed_ticks;)
    Board::feed_watchdog();
  Board::feed_watchdog();
  print_tick("  begun at tick ");
  for (;;)
    asm volatile("");
}

/// As `hang`, while no tick runs: the watchdog needs none.
inline void hang_without_a_tick() {
  Board::stop_tick();
  Board::feed_watchdog();
  print_tick("  begun at tick ");
  for (;;)
    asm volatile("");
}

inline void reset() {
  print_tick("  begun at tick ");
  Board::reset();
}

/// A report that does not match its check word, as a brown-out may leave it.
inline void spoil_the_report() {
  print_tick("  begun at tick ");
  hal::FaultReport report{};
  report.cause = hal::ResetCause::fault;
  seal(report, hal::FaultReport::fresh);
  report.program_counter = 4;
  axial_fault_report = report;
  Board::enable_drives(false);
  Board::restart();
}

constexpr Step steps[] = {{"stack overflow", overflow_the_stack},
                          {"store at the bottom", store_at_the_bottom},
                          {"store at the guard's end", store_at_the_guards_end},
                          {"store above the guard", store_above_the_guard},
                          {"wild jump", jump_astray},
                          {"hang", hang},
                          {"hang without a tick", hang_without_a_tick},
                          {"spoilt report", spoil_the_report},
                          {"reset", reset}};

}  // namespace axial::apps
