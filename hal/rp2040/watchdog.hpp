#pragma once
/// The watchdog of the RP2040, which also restarts the part on request, and why the part restarted. It counts the tick
/// of 1 us, twice a tick (erratum RP2040-E1). Source: RP2040 Datasheet, 2.13 (power-on state machine), 4.7.

#include <cstddef>
#include <cstdint>

#include <hal/fault_report.hpp>

namespace axial::hal::rp2040 {

struct WatchdogRegisters {
  volatile std::uint32_t control, load, reason, scratch[8], tick;
};
static_assert(offsetof(WatchdogRegisters, tick) == 0x2C);
struct PowerRegisters {
  volatile std::uint32_t force_on, force_off, watchdog_select, done;
};

namespace watchdog_words {
constexpr std::uint32_t trigger = 1u << 31, enable = 1u << 30, most_load = 0xFFFFFF;
/// What a restart resets: all but the ring (bit 0) and the crystal (bit 1), as power-on does.
constexpr std::uint32_t everything = 0x1FFFF & ~3u;
}  // namespace watchdog_words

/// Half ticks in `ms`, at most 8 388 ms.
constexpr std::uint32_t watchdog_load(std::uint32_t ms) {
  constexpr std::uint32_t a_ms = 2000;
  return ms > watchdog_words::most_load / a_ms ? watchdog_words::most_load : a_ms * ms;
}

/// `Port` gives `registers()` and `power()`.
template <class Port>
class Watchdog {
 public:
  /// Runs on under a debugger.
  static void start(std::uint32_t ms) {
    load_ = watchdog_load(ms);
    Port::power().watchdog_select = watchdog_words::everything;
    feed();
    Port::registers().control = watchdog_words::enable;
  }

  static void feed() { Port::registers().load = load_; }

  /// Restarts the part at once.
  static void trigger() {
    Port::power().watchdog_select = watchdog_words::everything;
    Port::registers().control = watchdog_words::trigger;
  }

 private:
  inline static std::uint32_t load_ = watchdog_words::most_load;
};

/// REASON of the watchdog. Supply and reset pin clear it.
namespace reset_reason {
constexpr std::uint32_t timer = 1u << 0, forced = 1u << 1;
}

constexpr ResetCause reset_cause(std::uint32_t reason) {
  if ((reason & reset_reason::timer) != 0) return ResetCause::watchdog;
  return (reason & reset_reason::forced) != 0 ? ResetCause::software : ResetCause::power_on;
}

}  // namespace axial::hal::rp2040
