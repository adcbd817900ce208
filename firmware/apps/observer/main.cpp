/// Prints what a momentum observer and a payload estimator make of a fixed sequence, and their cost; README.md has the
/// format.

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
void begin(const char* line, std::uint64_t hash) {
  for (const char* text : {line, ",", apps::Robot::name, ","})
    Board::print(text);
  Board::print(hal::hex(static_cast<std::uint32_t>(hash >> 32)).text);
  Board::print(hal::hex(static_cast<std::uint32_t>(hash)).text);
}

}  // namespace

int main() {
  Board::start();
  const auto all = apps::observer::report<Watched, AXIAL_NUMBER>(Counter{});
  begin("observer", all.hash);
  print(static_cast<std::uint32_t>(all.refused));
  print(static_cast<std::uint32_t>(all.collisions));
  print(all.least);
  print(all.most);
  const auto load = apps::observer::weighing<Watched, AXIAL_NUMBER>(Counter{});
  begin("\nweighing", load.hash);
  print(static_cast<std::uint32_t>(load.ready));
  print(load.weigh.least), print(load.weigh.most);
  print(load.estimate.least), print(load.estimate.most);
  Board::print("\nend\n");
  Board::exit(0);
}
