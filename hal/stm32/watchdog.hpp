#pragma once
/// The independent watchdog (IWDG) of the STM32 families, on the low-speed internal oscillator: nothing but a reset
/// stops it, and the reset leaves every pin an input. Source: RM0090 and RM0041, the chapters on the independent
/// watchdog and, of reset flags, on the reset and clock control.

#include <cstdint>

#include <hal/clock.hpp>
#include <hal/fault_report.hpp>

namespace axial::hal::stm32 {

struct WatchdogRegisters {
  volatile std::uint32_t key, prescaler, reload, status;
};
namespace watchdog_key {
constexpr std::uint32_t unlock = 0x5555, feed = 0xAAAA, start = 0xCCCC;
}

/// Prescaler's code (4 times 2 to its power) and reload value.
struct WatchdogTime {
  std::uint32_t prescaler, reload;
};

/// The finest prescaler that reaches `ms`, at most 100 s, at `clock_Hz`, whole kHz; the longest time where none does.
constexpr WatchdogTime watchdog_time(std::uint32_t clock_Hz, std::uint32_t ms) {
  constexpr std::uint32_t coarsest = 6, most = 4096;
  for (std::uint32_t code = 0; code <= coarsest; ++code) {
    const std::uint32_t counts = (clock_Hz / 1000 * ms + (4u << code) - 1) >> (2 + code);
    if (counts <= most) return {code, counts == 0 ? 0 : counts - 1};
  }
  return {coarsest, most - 1};
}

/// `Port` gives `registers()` and `clock_Hz`, the oscillator's nominal rate.
template <class Port>
struct Watchdog {
  /// Starts the watchdog, which starts its oscillator; then its time, fed last. The wait for the registers to be taken
  /// over is bounded.
  static void start(std::uint32_t ms) {
    auto& watchdog = Port::registers();
    const WatchdogTime time = watchdog_time(Port::clock_Hz, ms);
    watchdog.key = watchdog_key::start;
    watchdog.key = watchdog_key::unlock;
    watchdog.prescaler = time.prescaler;
    watchdog.reload = time.reload;
    wait_until([&] { return watchdog.status == 0; });
    feed();
  }

  static void feed() { Port::registers().key = watchdog_key::feed; }
};

/// RCC_CSR, alike in both families.
namespace reset_flags {
constexpr std::uint32_t remove = 1u << 24, pin = 1u << 26, power = 1u << 27 | 1u << 25, software = 1u << 28,
                        watchdog = 1u << 29 | 1u << 30, low_power = 1u << 31;
}

/// The reset pin's flag accompanies every other. `power` holds the supply's, which come with others of old.
constexpr ResetCause reset_cause(std::uint32_t flags) {
  if ((flags & reset_flags::power) != 0) return ResetCause::power_on;
  if ((flags & reset_flags::watchdog) != 0) return ResetCause::watchdog;
  if ((flags & reset_flags::software) != 0) return ResetCause::software;
  return (flags & reset_flags::low_power) != 0 ? ResetCause::unknown : ResetCause::power_on;
}

/// Reads the flags and clears them for the next reset.
template <class Register>
ResetCause take_reset_flags(Register& status) {
  const ResetCause cause = reset_cause(status);
  status = status | reset_flags::remove;
  return cause;
}

}  // namespace axial::hal::stm32
