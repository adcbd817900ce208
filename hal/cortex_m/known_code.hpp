#pragma once
/// Code whose instructions are known, by which the self-test judges the counter before anyone believes it.

#include <cstdint>

namespace axial::hal::cortex_m {

struct KnownCode {
  /// As many instructions as it says, and the return.
  template <int instructions>
  [[gnu::naked, gnu::noinline]] static void block(void*) {
    asm volatile(".rept %c0\n\tnop\n\t.endr\n\tbx lr" ::"i"(instructions));
  }

  /// 2 instructions a turn, and the return; the argument is the number of turns, at least 1.
  [[gnu::naked, gnu::noinline]] static void loop(void*) {
    asm volatile(".syntax unified\n1:\tsubs r0, #1\n\tbne 1b\n\tbx lr");
  }

  /// Of an empty bracket: store, call, return.
  static constexpr std::uint32_t empty_bracket = 3;
};

}  // namespace axial::hal::cortex_m
