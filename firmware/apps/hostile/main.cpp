/// Every public call with a status, asked of hostile numbers on the board.

#include <board.hpp>

#include "run.hpp"

AXIAL_HOSTED_IN_C

int main() {
  using axial::hal::Board;
  Board::start();
  const auto asked = axial::apps::ask_all(AXIAL_HOSTILE_STATES, [](const char* text) { Board::print(text); });
  Board::print(axial::hal::decimal(asked.calls).text);
  Board::print(" calls, ");
  Board::print(axial::hal::decimal(asked.wrong).text);
  Board::print(" wrong\n");
  Board::exit(asked.wrong == 0 ? 0 : 1);
}
