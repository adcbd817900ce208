#pragma once
/// The nRF51 series' watchdog, on the 32.768 kHz oscillator: nothing but a reset stops it, and the reset leaves every
/// pin an input. Source: nRF51 Series Reference Manual 3.0, the chapters on the watchdog and, of reset reasons, on
/// power.

#include <cstddef>
#include <cstdint>

#include <hal/fault_report.hpp>

namespace axial::hal::nrf51 {

struct WatchdogRegisters {
  volatile std::uint32_t start;
  volatile std::uint32_t reserved0[63];
  volatile std::uint32_t timed_out;
  volatile std::uint32_t reserved1[128];
  volatile std::uint32_t interrupt_enable_set, interrupt_enable_clear;
  volatile std::uint32_t reserved2[61];
  volatile std::uint32_t running, requests;
  volatile std::uint32_t reserved3[63];
  volatile std::uint32_t reload, requests_enabled, configuration;
  volatile std::uint32_t reserved4[60];
  volatile std::uint32_t request[8];
};
static_assert(offsetof(WatchdogRegisters, timed_out) == 0x100 && offsetof(WatchdogRegisters, running) == 0x400);
static_assert(offsetof(WatchdogRegisters, reload) == 0x504 && offsetof(WatchdogRegisters, request) == 0x600);

namespace watchdog_words {
constexpr std::uint32_t feed = 0x6E524635, request_0 = 1u << 0;
constexpr std::uint32_t run_while_asleep = 1u << 0;
}  // namespace watchdog_words

/// Counts of 32.768 kHz in `ms`, at most 131 s: the time is (reload + 1) of them; the part takes no less than 15.
constexpr std::uint32_t watchdog_reload(std::uint32_t ms) {
  constexpr std::uint32_t least = 15;
  const std::uint32_t counts = (ms * 32768u + 999u) / 1000u;
  return counts <= least ? least : counts - 1;
}

/// `Port` gives `registers()`.
template <class Port>
struct Watchdog {
  static void start(std::uint32_t ms) {
    auto& watchdog = Port::registers();
    watchdog.reload = watchdog_reload(ms);
    watchdog.requests_enabled = watchdog_words::request_0;
    watchdog.configuration = watchdog_words::run_while_asleep;
    watchdog.start = 1;
  }

  static void feed() { Port::registers().request[0] = watchdog_words::feed; }
};

/// RESETREAS: the bits stay until ones are written to them.
namespace reset_flags {
constexpr std::uint32_t pin = 1u << 0, watchdog = 1u << 1, software = 1u << 2, lock_up = 1u << 3, wake_up = 7u << 16;
}

constexpr ResetCause reset_cause(std::uint32_t flags) {
  if ((flags & reset_flags::watchdog) != 0) return ResetCause::watchdog;
  if ((flags & reset_flags::lock_up) != 0) return ResetCause::fault;
  if ((flags & reset_flags::software) != 0) return ResetCause::software;
  return (flags & reset_flags::wake_up) != 0 ? ResetCause::unknown : ResetCause::power_on;
}

/// Reads the reasons and clears them for the next reset.
template <class Register>
ResetCause take_reset_flags(Register& reasons) {
  const std::uint32_t flags = reasons;
  reasons = flags;
  return reset_cause(flags);
}

}  // namespace axial::hal::nrf51
