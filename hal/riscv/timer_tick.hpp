#pragma once
/// The control tick: the machine timer's interrupt at a fixed rate. Source: Privileged Architecture 20211203, 3.2.1;
/// the registers' places: RISC-V Advanced Core Local Interruptor 1.0-rc4, chapter 2.

#include <cstdint>

#include <hal/riscv/core.hpp>

namespace axial::hal::riscv {

/// `Platform` gives `timebase_Hz`, and the registers `timer_compare()` and `timer()`, each two words, the lower first.
template <class Platform>
class TimerTick {
 public:
  /// Starts the tick at `rate_Hz`, rounded to whole steps of the time base.
  static void start(std::uint32_t, std::uint32_t rate_Hz) {
    stop();
    period_ = (Platform::timebase_Hz + rate_Hz / 2) / rate_Hz;
    due_ = now() + period_;
    arm();
    set<Csr::interrupt_enable>(1u << timer_cause);
  }

  static void stop() { clear<Csr::interrupt_enable>(1u << timer_cause); }

  /// The period runs from the last due time, not from now: a late interrupt shifts no later one.
  static void interrupt() {
    due_ += period_;
    arm();
    count_ = count_ + 1;
  }

  /// Ticks since the start of the image; wraps.
  static std::uint32_t count() { return count_; }

 private:
  static std::uint64_t now() {
    volatile auto* timer = Platform::timer();
    while (true) {
      const std::uint32_t high = timer[1], low = timer[0];
      if (timer[1] == high) return std::uint64_t{high} << 32 | low;
    }
  }

  /// The upper half first to its largest: no value in between is due.
  static void arm() {
    volatile auto* compare = Platform::timer_compare();
    compare[1] = ~0u;
    compare[0] = static_cast<std::uint32_t>(due_);
    compare[1] = static_cast<std::uint32_t>(due_ >> 32);
  }

  inline static std::uint64_t due_ = 0;
  inline static std::uint32_t period_ = 0;
  inline static volatile std::uint32_t count_ = 0;
};

}  // namespace axial::hal::riscv
