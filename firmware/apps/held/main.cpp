/// Prints where joints go that stick and that meet end stops, and what a step costs; README.md has the format.

#include "../counted.hpp"
#include "sequence.hpp"

int main() {
  using namespace axial::apps;
  using axial::hal::Board;
  Board::start();
  const auto all = held::report<Robot>(Counter{});
  print_line("held", all.hash);
  print_number(static_cast<std::uint32_t>(all.stuck)), print_number(static_cast<std::uint32_t>(all.stopped));
  print_number(all.step.least), print_number(all.step.most);
  Board::print("\nend\n");
  Board::exit(0);
}
