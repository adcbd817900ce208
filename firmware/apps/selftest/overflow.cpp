/// Runs the stack out of RAM on purpose: the image must stop with a report, not run on with spoilt variables.

#include <board.hpp>

namespace {

/// The empty assembly makes every frame hold its bytes, and the multiplication after the call keeps it a real call.
[[gnu::noinline]] int descend(int depth) {
  volatile char room[64];
  room[0] = static_cast<char>(depth);
  asm volatile("" ::"r"(&room[0]) : "memory");
  return depth == 0 ? 0 : 3 * descend(depth - 1) + room[0];
}

}  // namespace

int main() {
  using axial::hal::Board;
  Board::start();
  descend(1'000'000);
  Board::print("the stack had no end\n");
  Board::exit(0);
}
