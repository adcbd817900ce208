/// The instruments, before any figure of theirs is believed: known blocks of instructions, the clock, the tick.

#include "check.hpp"

namespace axial::apps {
namespace {

using hal::Board;
using Known = Board::Known;

std::uint32_t count(hal::Measured code) { return Board::Counter::count(code, nullptr); }

/// Known::loop wants the number of turns as its argument.
void* argument(std::uint32_t turns) { return reinterpret_cast<void*>(std::uintptr_t{turns}); }

std::uint32_t count_loop(std::uint32_t turns) { return Board::Counter::count(Known::loop, argument(turns)); }

void check_blocks(Checks& check) {
  for (int round = 0; round < 3; ++round) {
    check.equal(count(Known::block<1>), 1, "1 instruction is counted as 1");
    check.equal(count(Known::block<2>), 2, "2 instructions are counted as 2");
    check.equal(count(Known::block<10>), 10, "10 instructions are counted as 10");
    check.equal(count(Known::block<100>), 100, "100 instructions are counted as 100");
    check.equal(count(Known::block<1000>), 1000, "1000 instructions are counted as 1000");
    check.equal(count_loop(100001), Known::loop_cost(100001), "200 002 instructions are counted exactly");
  }
  check.equal(Board::empty_bracket(), Known::empty_bracket, "the empty bracket is what stands in it");
  check.equal(count(Known::block<0>), 0, "an empty piece of code costs nothing");
}

void check_overflow(Checks& check) {
  constexpr std::uint32_t span = Board::Counter::span;
  constexpr std::uint32_t beyond = Known::turns_of(span + span / 50), near = Known::turns_of(span - span / 50);
  check.equal(count_loop(beyond), hal::count_overflow, "a count beyond the counter's span says so");
  check.equal(count_loop(near), Known::loop_cost(near), "a count near the counter's span is exact");
}

/// Where the emulator models no clock controller, the start-up must have given up waiting and must say so.
void check_clock(Checks& check) {
  check.that(Board::clock().source == Board::emulated_clock, "the clock, or its fallback, is reported");
  check.equal(Board::clock().core_Hz, Board::emulator_Hz, "the emulated core runs at its machine's rate");
  check.equal(Board::baud_running(), Board::baud, "the serial port runs at its rate");
  check.that(Board::counter_scale().kind == Board::emulated_counter, "the counter says what it counts");
}

constexpr std::uint32_t cost_of_10_ms = Board::Counter::per_second / 100;

void check_tick(Checks& check) {
  Board::start_tick(1000);
  const std::uint32_t before = Board::ticks();
  Known::loop(argument(Known::turns_of(cost_of_10_ms)));
  const std::uint32_t passed = Board::ticks() - before;
  Board::stop_tick();
  check.that(passed == 9 || passed == 10, "10 ms hold 10 ticks of 1 kHz, less one where the first is cut");
}

/// Measuring may borrow the timer of the tick; 20 measured pieces of 0.5 ms each must still let 10 ticks pass.
void check_tick_while_measuring(Checks& check) {
  constexpr std::uint32_t piece = Known::turns_of(cost_of_10_ms / 20);
  Board::start_tick(1000);
  const std::uint32_t before = Board::ticks();
  for (int i = 0; i < 20; ++i)
    check.equal(count_loop(piece), Known::loop_cost(piece), "exact");
  const std::uint32_t passed = Board::ticks() - before;
  Board::stop_tick();
  check.that(passed == 9 || passed == 10 || passed == 11, "the control tick keeps its pace while code is measured");
}

/// A stopped tick counts no more, not even one that was pending.
void check_stopped_tick(Checks& check) {
  const std::uint32_t before = Board::ticks();
  Known::loop(argument(Known::turns_of(cost_of_10_ms)));
  check.equal(Board::ticks() - before, 0, "a stopped tick stands still");
}

}  // namespace

void check_instruments(Checks& check) {
  check_clock(check);
  check_blocks(check);
  check_overflow(check);
  check_tick(check);
  check_tick_while_measuring(check);
  check_stopped_tick(check);
}

}  // namespace axial::apps
