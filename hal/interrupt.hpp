#pragma once
/// What a board lists: `static constexpr Interrupt interrupts[]`, the lines that it serves.

namespace axial::hal {

using Handler = void (*)();

struct Interrupt {
  unsigned number;
  Handler handler;
};

}  // namespace axial::hal
