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
}  // namespace watchdog_words

/// What the parts of this family differ in.
struct Rp2040Watch {
  /// Half ticks of 1 us.
  static constexpr std::uint32_t a_ms = 2000;
  /// What a restart resets: all but the ring (bit 0) and the crystal (bit 1), as power-on does.
  static constexpr std::uint32_t everything = 0x1FFFF & ~3u;
};

/// Counts in `ms`; at most 8 388 ms on the RP2040.
template <class Watch = Rp2040Watch>
constexpr std::uint32_t watchdog_load(std::uint32_t ms) {
  return ms > watchdog_words::most_load / Watch::a_ms ? watchdog_words::most_load : Watch::a_ms * ms;
}

/// `Port` gives `registers()` and `power()`.
template <class Port, class Watch = Rp2040Watch>
class Watchdog {
 public:
  /// Runs on under a debugger.
  static void start(std::uint32_t ms) {
    load_ = watchdog_load<Watch>(ms);
    Port::power().watchdog_select = Watch::everything;
    feed();
    Port::registers().control = watchdog_words::enable;
  }

  static void feed() { Port::registers().load = load_; }

  /// Restarts the part at once.
  static void trigger() {
    Port::power().watchdog_select = Watch::everything;
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
