#pragma once
/// What a board's counter counts.

#include <cstdint>

namespace axial::hal {

enum class CounterKind : std::uint8_t {
  instructions = 0,  ///< in QEMU
  cycles = 1,        ///< on silicon
  none = 2           ///< a host: every count is 0
};

/// Count over raw ticks, as a ratio.
struct CounterScale {
  CounterKind kind;
  std::uint32_t numerator, denominator;
};

}  // namespace axial::hal
