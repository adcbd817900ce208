#pragma once
/// The watchdog of Arm's CMSDK: its first time-out raises the non-maskable interrupt, the second, a time later, resets.
/// Source: Cortex-M System Design Kit, technical reference manual (Arm DDI 0479), section 4.6.

#include <cstddef>
#include <cstdint>

namespace axial::hal::cmsdk {

struct WatchdogRegisters {
  volatile std::uint32_t load, value, control, clear, raw_status, status;
  volatile std::uint32_t reserved[762];
  volatile std::uint32_t lock;
};
static_assert(offsetof(WatchdogRegisters, lock) == 0xC00);

namespace watchdog_words {
constexpr std::uint32_t unlock = 0x1ACCE551, lock = 1;
constexpr std::uint32_t interrupt = 1u << 0, reset = 1u << 1;
}  // namespace watchdog_words

/// `Port` gives `registers()` and `clock_Hz`; `ms` is at most 2^32 clocks.
template <class Port>
struct Watchdog {
  static void start(std::uint32_t ms) {
    auto& watchdog = Port::registers();
    watchdog.lock = watchdog_words::unlock;
    watchdog.load = static_cast<std::uint32_t>(std::uint64_t{Port::clock_Hz} * ms / 1000);
    watchdog.control = watchdog_words::interrupt | watchdog_words::reset;
    watchdog.lock = watchdog_words::lock;
  }

  /// Clearing the interrupt loads the counter anew.
  static void feed() {
    auto& watchdog = Port::registers();
    watchdog.lock = watchdog_words::unlock;
    watchdog.clear = 1;
    watchdog.lock = watchdog_words::lock;
  }
};

}  // namespace axial::hal::cmsdk
