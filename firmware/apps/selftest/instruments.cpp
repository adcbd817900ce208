/// The instruments, before any figure of theirs is believed: known blocks of instructions, the clock, the tick.

#include "check.hpp"

namespace axial::apps {
namespace {

using hal::Board;
using hal::cortex_m::Measured;

template <int instructions>
[[gnu::naked, gnu::noinline]] void block(void*) {
  asm volatile(".rept %c0\n\tnop\n\t.endr\n\tbx lr" ::"i"(instructions));
}

/// 2 instructions a turn, and 2 that load the number of turns.
template <std::uint32_t turns>
[[gnu::naked, gnu::noinline]] void loop(void*) {
  asm volatile("movw r1, %c0\n\tmovt r1, %c1\n1:\tsubs r1, #1\n\tbne 1b\n\tbx lr" ::"i"(turns & 0xFFFFu),
               "i"(turns >> 16));
}
constexpr std::uint32_t loop_count(std::uint32_t turns) { return 2 + 2 * turns; }

std::uint32_t count(Measured code) { return Board::Counter::count(code, nullptr); }

void check_blocks(Checks& check) {
  for (int round = 0; round < 3; ++round) {
    check.equal(count(block<1>), 1, "1 instruction is counted as 1");
    check.equal(count(block<2>), 2, "2 instructions are counted as 2");
    check.equal(count(block<10>), 10, "10 instructions are counted as 10");
    check.equal(count(block<100>), 100, "100 instructions are counted as 100");
    check.equal(count(block<1000>), 1000, "1000 instructions are counted as 1000");
    check.equal(count(loop<100000>), loop_count(100000), "200 002 instructions are counted exactly");
  }
  check.equal(Board::empty_bracket(), 3, "the empty bracket is its store, call and return");
  check.equal(count(hal::cortex_m::empty_code), 0, "an empty piece of code costs nothing");
}

/// 2^24 ticks of SysTick; the loop takes 2 % more.
void check_overflow(Checks& check) {
  constexpr auto scale = hal::cortex_m::instructions_of_ticks(Board::emulator_Hz);
  constexpr auto span = static_cast<std::uint32_t>((std::uint64_t{1} << 24) * scale.numerator / scale.denominator);
  check.equal(count(loop<span / 2 + span / 100>), hal::cortex_m::count_overflow, "a count beyond 24 bits says so");
  check.equal(count(loop<span / 2 - span / 100>), loop_count(span / 2 - span / 100), "a count near 24 bits is exact");
}

/// The emulator models no clock controller: the start-up must have given up waiting and must say so.
void check_clock(Checks& check) {
  check.that(Board::clock().source == hal::ClockSource::emulator, "the fallback of the clock is reported");
  check.equal(Board::clock().core_Hz, Board::emulator_Hz, "the emulated core runs at its machine's rate");
  check.equal(Board::baud_running(), Board::baud, "the serial port runs at its rate");
  check.that(Board::counter_scale().kind == hal::CounterKind::instructions,
             "the counter says that it counts instructions");
}

/// At 64 ns an instruction 1 ms lasts 15 625 instructions.
constexpr std::uint32_t instructions_a_tick = 15625;

void check_tick(Checks& check) {
  Board::start_tick(1000);
  const std::uint32_t before = Board::ticks();
  loop<instructions_a_tick * 10 / 2>(nullptr);
  const std::uint32_t passed = Board::ticks() - before;
  Board::stop_tick();
  check.that(passed == 9 || passed == 10, "10 ms hold 10 ticks of 1 kHz, less one where the first is cut");
}

/// Measuring borrows SysTick from the tick; 20 measured pieces of 0.5 ms each must still let 10 ticks pass.
void check_tick_while_measuring(Checks& check) {
  Board::start_tick(1000);
  const std::uint32_t before = Board::ticks();
  for (int i = 0; i < 20; ++i)
    check.equal(count(loop<instructions_a_tick / 4>), loop_count(instructions_a_tick / 4), "exact");
  const std::uint32_t passed = Board::ticks() - before;
  Board::stop_tick();
  check.that(passed == 9 || passed == 10 || passed == 11, "the control tick keeps its pace while code is measured");
}

}  // namespace

void check_instruments(Checks& check) {
  check_clock(check);
  check_blocks(check);
  check_overflow(check);
  check_tick(check);
  check_tick_while_measuring(check);
}

}  // namespace axial::apps
