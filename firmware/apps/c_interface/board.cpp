/// The board's services under C's names.

#include "board.h"

#include <board.hpp>

#include <hal/text.hpp>

using axial::hal::Board;

namespace {
std::uint32_t seen = 0;
}

void board_start(std::uint32_t tick_Hz) {
  Board::start();
  Board::start_tick(tick_Hz);
}
std::uint32_t board_wait_for_tick() {
  while (Board::ticks() == seen)
    Board::sleep_unless([] { return Board::ticks() != seen; });
  return ++seen;
}
void board_print(const char* text) { Board::print(text); }
void board_print_hex(std::uint32_t word) { Board::print(axial::hal::hex(word).text); }
void board_exit(int code) { Board::exit(code); }
