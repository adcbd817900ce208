/// Prints what the safe calls of a loop make of a fixed sequence, and their cost; README.md has the format.

#include <board.hpp>
#include <robot.hpp>

#include <hal/text.hpp>

#include "sequence.hpp"

namespace {

using axial::hal::Board;

struct Counter {
  template <class Code>
  [[gnu::noinline]] std::uint32_t operator()(Code& code) const {
    return Board::count(code);
  }
};

void print(std::uint32_t number) { Board::print(","), Board::print(axial::hal::decimal(number).text); }

}  // namespace

int main() {
  Board::start();
  const auto all = axial::apps::safe_loop::report<axial::apps::Robot, AXIAL_NUMBER>(Counter{});
  for (const char* text : {"safe_loop,", axial::apps::Robot::name, ","})
    Board::print(text);
  Board::print(axial::hal::hex(static_cast<std::uint32_t>(all.hash >> 32)).text);
  Board::print(axial::hal::hex(static_cast<std::uint32_t>(all.hash)).text);
  print(static_cast<std::uint32_t>(all.met)), print(static_cast<std::uint32_t>(all.refused));
  for (const auto& cost : {all.gravity, all.tracking, all.bad})
    print(cost.least), print(cost.most);
  if (!axial::is_stored_v<AXIAL_NUMBER>)
    for (const auto& cost : {all.limiting, all.telling})
      print(cost.least), print(cost.most);
  Board::print("\nend\n");
  Board::exit(0);
}
