#pragma once
/// The end of a self-test: a line for the reader, an exit code for the machine.

#include "check.hpp"

namespace axial::apps {

using hal::Board;

inline void give_verdict(const Checks& checks) {
  Board::print(hal::decimal(checks.made()).text);
  Board::print(" checks, ");
  Board::print(hal::decimal(checks.failed()).text);
  Board::print(" failed\n");
  Board::exit(checks.failed() == 0 ? 0 : 1);
}

}  // namespace axial::apps
