#pragma once
/// What a board lists: `static constexpr Interrupt interrupts[]`, the lines that it serves.

namespace axial::hal {

using Handler = void (*)();

struct Interrupt {
  unsigned number;
  Handler handler;
};

/// Calls the handler of a line; false where it has none.
template <class Interrupts>
bool call_handler(const Interrupts& interrupts, unsigned line) {
  for (const auto& interrupt : interrupts) {
    if (interrupt.number != line) continue;
    interrupt.handler();
    return true;
  }
  return false;
}

}  // namespace axial::hal
