#pragma once
/// Code whose instructions are known, by which the self-test judges the counter before anyone believes it.

#include <cstdint>

namespace axial::hal::riscv {

struct KnownCode {
  /// As many instructions as the parameter says, and the return.
  template <int instructions>
  [[gnu::naked, gnu::noinline]] static void block(void*) {
    asm volatile(".rept %0\n\tnop\n\t.endr\n\tret" ::"i"(instructions));
  }

  /// 2 instructions per turn, and the return; the argument is the number of turns, at least 1.
  [[gnu::naked, gnu::noinline]] static void loop(void*) { asm volatile("1:\taddi a0, a0, -1\n\tbnez a0, 1b\n\tret"); }

  static constexpr std::uint32_t loop_cost(std::uint32_t turns) { return 2 * turns; }
  /// The most turns that cost no more than `cost`.
  static constexpr std::uint32_t turns_of(std::uint32_t cost) { return cost / 2; }

  /// Cost of an empty bracket: read, call, return.
  static constexpr std::uint32_t empty_bracket = 3;
};

}  // namespace axial::hal::riscv
