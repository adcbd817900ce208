/// Prints what fall-backs exert, of stops from full speed and behind a broken wire, and their cost; README.md has the
/// format.

#include "../counted.hpp"
#include "broken_pair.hpp"
#include "sequence.hpp"

int main() {
  using namespace axial::apps;
  using axial::hal::Board;
  Board::start();
  const auto all = controlled_stop::report<Robot, AXIAL_NUMBER>(Counter{});
  print_line("controlled_stop", all.hash);
  print_number(static_cast<std::uint32_t>(all.to_rest));
  print_number(all.braking.least), print_number(all.braking.most);
  const auto broken = broken_pair::report<Robot, AXIAL_NUMBER>();
  Board::print("\n");
  print_line("broken_pair", broken.hash);
  print_number(static_cast<std::uint32_t>(broken.soonest)), print_number(static_cast<std::uint32_t>(broken.latest));
  print_number(broken.refused ? 1 : 0);
  Board::print("\nend\n");
  Board::exit(0);
}
