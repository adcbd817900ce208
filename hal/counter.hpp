#pragma once
/// What a board's counter counts.

#include <cstdint>

namespace axial::hal {

enum class CounterKind : std::uint8_t {
  instructions = 0,  ///< in QEMU
  cycles = 1,        ///< on silicon
  none = 2           ///< a host, or a core without a counter: every count is 0
};

/// A count that the counter could not hold.
constexpr std::uint32_t count_overflow = 0xFFFFFFFF;

/// A piece of code to measure: a function and its argument.
using Measured = void (*)(void*);

/// Count over raw ticks, as a ratio.
struct CounterScale {
  CounterKind kind;
  std::uint32_t numerator, denominator;
};

}  // namespace axial::hal
