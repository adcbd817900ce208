/// Prints what a momentum observer and a payload estimator make of a fixed sequence, and their cost; README.md has the
/// format.

#include "../counted.hpp"
#include "sequence.hpp"

namespace {

using namespace axial;
using hal::Board;
using Watched = axial::Scene<apps::Robot, Gravity, RotorInertia>;

}  // namespace

int main() {
  Board::start();
  const auto all = apps::observer::report<Watched, AXIAL_NUMBER>(apps::Counter{});
  apps::print_line("observer", all.hash);
  apps::print_number(static_cast<std::uint32_t>(all.refused));
  apps::print_number(static_cast<std::uint32_t>(all.collisions));
  apps::print_number(all.least);
  apps::print_number(all.most);
  const auto load = apps::observer::weighing<Watched, AXIAL_NUMBER>(apps::Counter{});
  apps::print_line("\nweighing", load.hash);
  apps::print_number(static_cast<std::uint32_t>(load.ready));
  apps::print_number(load.weigh.least), apps::print_number(load.weigh.most);
  apps::print_number(load.estimate.least), apps::print_number(load.estimate.most);
  Board::print("\nend\n");
  Board::exit(0);
}
