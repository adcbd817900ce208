/// Prints what the safe calls of a loop make of a fixed sequence, and their cost; README.md has the format.

#include "../counted.hpp"
#include "sequence.hpp"

int main() {
  using namespace axial::apps;
  using axial::hal::Board;
  Board::start();
  const auto all = safe_loop::report<Robot, AXIAL_NUMBER>(Counter{});
  print_line("safe_loop", all.hash);
  print_number(static_cast<std::uint32_t>(all.met)), print_number(static_cast<std::uint32_t>(all.refused));
  for (const auto& cost : {all.gravity, all.tracking, all.bad})
    print_number(cost.least), print_number(cost.most);
  if (!axial::is_stored_v<AXIAL_NUMBER>)
    for (const auto& cost : {all.limiting, all.telling})
      print_number(cost.least), print_number(cost.most);
  Board::print("\nend\n");
  Board::exit(0);
}
