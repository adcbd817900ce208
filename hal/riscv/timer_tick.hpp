#pragma once
/// The machine timer's two jobs, both by its one interrupt: the control tick, and a watchdog for parts without one.
/// Source: Privileged Architecture 20211203, 3.2.1; the registers' places: RISC-V Advanced Core Local Interruptor
/// 1.0-rc4, chapter 2.

#include <cstdint>

#include <hal/riscv/core.hpp>

/// Drives off, reason noted, restart; in trap.cpp.
extern "C" void axial_watchdog_expired();

namespace axial::hal::riscv {

/// `Platform` gives `timebase_Hz`, and the registers `timer_compare()` and `timer()`, each two words, the lower first.
template <class Platform>
class TimerTick {
  static constexpr std::uint64_t never = ~std::uint64_t{0};
  /// Interrupts of the watchdog in its time; it restarts at the one after.
  static constexpr std::uint32_t watch_steps = 8;

 public:
  /// Starts the tick at `rate_Hz`, rounded to whole steps of the time base.
  static void start(std::uint32_t, std::uint32_t rate_Hz) {
    stop();
    period_ = (Platform::timebase_Hz + rate_Hz / 2) / rate_Hz;
    due_ = now() + period_;
    arm();
    set<Csr::interrupt_enable>(1u << timer_cause);
  }

  static void stop() {
    const InterruptMask mask;
    due_ = never;
    arm();
  }

  /// Starts the watchdog: it restarts the board between `ms` and 9/8 of that after it was fed last. It does not see a
  /// hang with interrupts masked.
  static void watch(std::uint32_t ms) {
    const InterruptMask mask;
    watch_period_ = Platform::timebase_Hz / 1000 * ms / watch_steps;
    watch_due_ = now() + watch_period_;
    feed();
    arm();
    set<Csr::interrupt_enable>(1u << timer_cause);
  }

  static void feed() { steps_left_ = watch_steps; }

  static void interrupt() {
    const std::uint64_t time = now();
    if (time >= due_) tick();
    if (time >= watch_due_) watch_step(time);
    arm();
  }

  /// Ticks since the start of the image; wraps.
  static std::uint32_t count() { return count_; }
  /// The timer that it counts by.
  static std::uint32_t phase() { return static_cast<std::uint32_t>(now()); }

 private:
  /// The period runs from the last due time, not from now: a late interrupt shifts no later one.
  static void tick() {
    due_ += period_;
    count_ = count_ + 1;
  }

  /// The watchdog's period runs from now: after a pause of the emulator the program gets its whole time.
  static void watch_step(std::uint64_t time) {
    watch_due_ = time + watch_period_;
    if (steps_left_ == 0) axial_watchdog_expired();
    steps_left_ = steps_left_ - 1;
  }

  static std::uint64_t now() {
    volatile auto* timer = Platform::timer();
    while (true) {
      const std::uint32_t high = timer[1], low = timer[0];
      if (timer[1] == high) return std::uint64_t{high} << 32 | low;
    }
  }

  /// The upper half first to its largest: no value in between is due.
  static void arm() {
    const std::uint64_t next = due_ < watch_due_ ? due_ : watch_due_;
    volatile auto* compare = Platform::timer_compare();
    compare[1] = ~0u;
    compare[0] = static_cast<std::uint32_t>(next);
    compare[1] = static_cast<std::uint32_t>(next >> 32);
  }

  inline static std::uint64_t due_ = never, watch_due_ = never;
  inline static std::uint32_t period_ = 0, watch_period_ = 0;
  inline static volatile std::uint32_t count_ = 0, steps_left_ = 0;
};

}  // namespace axial::hal::riscv
