/// Prints the hash and the cost of fixed-point kernels of one robot, those that AXIAL_GOLDEN names; README.md has the
/// format.

#include "../counted.hpp"
#include "golden.hpp"

namespace {

using namespace axial;
using hal::Board;

void print(const apps::fixed::Golden& g) {
  for (const char* text : {"fixed,", g.kernel, ",", apps::Robot::name, ",", g.arithmetic, ","})
    Board::print(text);
  apps::print_hash(g.hash);
  for (const std::uint32_t count : {g.least, g.most})
    apps::print_number(count);
  Board::print("\n");
}

}  // namespace

int main() {
  Board::start();
  axial::apps::fixed::AXIAL_GOLDEN<axial::apps::Robot>(axial::apps::Counter{}, print);
  Board::print("end\n");
  Board::exit(0);
}
