/// Prints what a momentum observer makes of a fixed sequence, and its cost; README.md has the format.

#include <board.hpp>
#include <robot.hpp>

#include <hal/text.hpp>

#include "sequence.hpp"

namespace {

using namespace axial;
using hal::Board;
using Watched = axial::Scene<apps::Robot, Gravity, RotorInertia>;

struct Counter {
  template <class Code>
  [[gnu::noinline]] std::uint32_t operator()(Code& code) const {
    return Board::count(code);
  }
};

void print(std::uint32_t number) { Board::print(","), Board::print(hal::decimal(number).text); }

}  // namespace

int main() {
  Board::start();
  const auto all = apps::observer::report<Watched, AXIAL_NUMBER>(Counter{});
  for (const char* text : {"observer,", apps::Robot::name, ","})
    Board::print(text);
  Board::print(hal::hex(static_cast<std::uint32_t>(all.hash >> 32)).text);
  Board::print(hal::hex(static_cast<std::uint32_t>(all.hash)).text);
  print(static_cast<std::uint32_t>(all.refused));
  print(static_cast<std::uint32_t>(all.collisions));
  print(all.least);
  print(all.most);
  Board::print("\nend\n");
  Board::exit(0);
}
