#pragma once
/// Code of known cost, by which the self-test judges the counter before anyone believes it.

#include <cstdint>

namespace axial::hal::cortex_m {

struct KnownCode {
  /// As many instructions as the parameter says, and the return.
  template <int instructions>
  [[gnu::naked, gnu::noinline]] static void block(void*) {
    asm volatile(".rept %c0\n\tnop\n\t.endr\n\tbx lr" ::"i"(instructions));
  }

  /// 2 instructions per turn, and the return; the argument is the number of turns, at least 1, `loop_cost` what they
  /// cost.
  [[gnu::naked, gnu::noinline]] static void loop(void*) {
    asm volatile(".syntax unified\n1:\tsubs r0, #1\n\tbne 1b\n\tbx lr");
  }
};

/// What KnownCode costs in instructions. An instruction of a block costs 1 in cycles too.
struct KnownInstructions : KnownCode {
  static constexpr std::uint32_t loop_cost(std::uint32_t turns) { return 2 * turns; }
  /// The most turns that cost no more than `cost`.
  static constexpr std::uint32_t turns_of(std::uint32_t cost) { return cost / 2; }
  /// Cost of an empty bracket: store, call, return.
  static constexpr std::uint32_t empty_bracket = 3;
};

/// What KnownCode costs in cycles of the Cortex-M0+, whose taken branches, calls, returns and stores take 2 (Arm DDI
/// 0484, 3.3).
struct KnownCyclesM0Plus : KnownCode {
  static constexpr std::uint32_t loop_cost(std::uint32_t turns) { return 3 * turns - 1; }
  static constexpr std::uint32_t turns_of(std::uint32_t cost) { return (cost + 1) / 3; }
  static constexpr std::uint32_t empty_bracket = 6;
};

}  // namespace axial::hal::cortex_m
