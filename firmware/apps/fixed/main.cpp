/// Prints the hash and the cost of fixed-point kernels of one robot, those that AXIAL_GOLDEN names; README.md has the
/// format.

#include <board.hpp>
#include <robot.hpp>

#include <hal/text.hpp>

#include "golden.hpp"

namespace {

using namespace axial;
using hal::Board;

struct Counter {
  template <class Code>
  [[gnu::noinline]] std::uint32_t operator()(Code& code) const {
    return Board::count(code);
  }
};

void print(const apps::fixed::Golden& g) {
  for (const char* text : {"fixed,", g.kernel, ",", apps::Robot::name, ",", g.arithmetic, ","})
    Board::print(text);
  Board::print(hal::hex(static_cast<std::uint32_t>(g.hash >> 32)).text);
  Board::print(hal::hex(static_cast<std::uint32_t>(g.hash)).text);
  for (const std::uint32_t count : {g.least, g.most}) {
    Board::print(",");
    Board::print(hal::decimal(count).text);
  }
  Board::print("\n");
}

}  // namespace

int main() {
  Board::start();
  axial::apps::fixed::AXIAL_GOLDEN<axial::apps::Robot>(Counter{}, print);
  Board::print("end\n");
  Board::exit(0);
}
