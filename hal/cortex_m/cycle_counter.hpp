#pragma once
/// Cycles by SysTick, on a part whose core has no DWT and whose control tick leaves SysTick alone.

#include <cstdint>

#include <hal/cortex_m/core.hpp>
#include <hal/cortex_m/counter.hpp>
#include <hal/cortex_m/known_code.hpp>
#include <hal/cortex_m/registers.hpp>
#include <hal/counter.hpp>

namespace axial::hal::cortex_m {

/// Cycle counter of a core that runs at `core_Hz`; `Known_` is the cost of known code in its cycles.
template <std::uint32_t core_Hz, class Known_>
class CycleCounter {
 public:
  using Known = Known_;
  static constexpr std::uint32_t per_second = core_Hz;
  /// More cycles than these do not fit SysTick.
  static constexpr std::uint32_t span = 1u << 24;

  /// Lets SysTick run; measures the empty bracket.
  static void start() {
    auto& timer = sys_tick();
    timer.reload = span - 1;
    timer.control = sys_tick_control::core_clock | sys_tick_control::enable;
    empty_ = 0;
    empty_ = count(empty_code, nullptr);
  }

  static CounterScale scale() { return {CounterKind::cycles, 1, 1}; }

  /// The empty bracket: store, call and return. Already subtracted from every count.
  static std::uint32_t empty() { return empty_; }

  /// Cycles of `code(argument)`, without the call and the return; interrupts masked. `count_overflow` where SysTick's
  /// 24 bits did not suffice.
  static std::uint32_t count(Measured code, void* argument) {
    const InterruptMask mask;
    const std::uint32_t end = bracket(&sys_tick().current, code, argument);
    if ((sys_tick().control & sys_tick_control::wrapped) != 0) return count_overflow;
    return (span - end) % span - empty_;
  }

 private:
  inline static std::uint32_t empty_ = 0;
};

}  // namespace axial::hal::cortex_m
