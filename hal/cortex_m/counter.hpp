#pragma once
/// How much a piece of code costs: cycles on silicon, instructions in QEMU.
///
/// DWT's cycle counter where it advances. QEMU leaves it at 0, ARMv6-M has none; there, with `-icount shift=6`, every
/// instruction takes 64 ns of virtual time (128 ns with 7) and SysTick tells the time, so SysTick counts instructions.
/// One SysTick tick is shorter than one instruction on every board, and the bracket restarts the counter, so the
/// conversion is exact. Where SysTick stands still too (an nRF51 on silicon has none) nothing is counted, and the scale
/// says so.

#include <cstdint>

#include <hal/cortex_m/core.hpp>
#include <hal/cortex_m/known_code.hpp>
#include <hal/cortex_m/registers.hpp>
#include <hal/counter.hpp>

namespace axial::hal::cortex_m {

/// Virtual time of an instruction under `-icount shift=6`, which suits all but slow clocks.
constexpr std::uint32_t usual_instruction_ns = 64;

constexpr std::uint32_t greatest_common_divisor(std::uint32_t a, std::uint32_t b) {
  return b == 0 ? a : greatest_common_divisor(b, a % b);
}

/// Instructions per SysTick tick, as a reduced ratio: instructions per second over ticks per second.
constexpr CounterScale instructions_of_ticks(std::uint32_t tick_Hz,
                                             std::uint32_t instruction_ns = usual_instruction_ns) {
  const std::uint32_t instructions_per_s = 1'000'000'000u / instruction_ns;
  const std::uint32_t common = greatest_common_divisor(instructions_per_s, tick_Hz);
  return {CounterKind::instructions, instructions_per_s / common, tick_Hz / common};
}

/// Instructions from SysTick ticks since a restart. After k instructions the counter shows floor(k * d/n + c), where c,
/// the emulator's rounding to whole nanoseconds, was seen between 0 and 1/2. With d/n > 3/2 that differs for every k,
/// and the ceiling of (ticks - 1/2) * n/d gives k back exactly; tests/hal checks the arithmetic, the self-test the
/// emulator.
constexpr std::uint32_t instructions_of(std::uint32_t ticks, const CounterScale& scale) {
  if (ticks == 0) return 0;
  return ((2 * ticks - 1) * scale.numerator + 2 * scale.denominator - 1) / (2 * scale.denominator);
}

/// Restarts the counter at `counter` (a store of anything clears DWT and SysTick alike), calls `code(argument)`,
/// returns the counter. Between the store and the load lie `blx` and the code, nothing else, whatever the compiler.
[[gnu::naked, gnu::noinline]] inline std::uint32_t bracket(Register*, Measured, void*) {
  asm volatile(
      "push {r4, lr}\n\t"
      "mov r4, r0\n\t"
      "mov r0, r2\n\t"
      "str r4, [r4]\n\t"
      "blx r1\n\t"
      "ldr r0, [r4]\n\t"
      "pop {r4, pc}");
}

[[gnu::naked, gnu::noinline]] inline void empty_code(void*) { asm volatile("bx lr"); }

/// The counter of a board whose emulated core clock is `emulator_Hz`, as its board.json has the emulator run.
template <std::uint32_t emulator_Hz, std::uint32_t instruction_ns = usual_instruction_ns>
class Counter {
  static constexpr std::uint32_t sys_tick_span = 1u << 24;
  static constexpr CounterScale emulated = instructions_of_ticks(emulator_Hz, instruction_ns);
  static_assert(3 * emulated.numerator <= 2 * emulated.denominator,
                "a SysTick tick must be shorter than 2/3 of an emulated instruction: raise the icount shift");
  static_assert(emulated.numerator < 128, "instructions_of would leave 32 bits: widen it");

 public:
  using Known = KnownInstructions;
  /// Instructions per second in the emulator.
  static constexpr std::uint32_t per_second = 1'000'000'000u / instruction_ns;
  /// More instructions than these do not fit SysTick.
  static constexpr auto span =
      static_cast<std::uint32_t>(std::uint64_t{sys_tick_span} * emulated.numerator / emulated.denominator);

  /// Finds out what counts; measures the empty bracket.
  static void start() {
    kind_ = dwt_counts()                            ? CounterKind::cycles
            : by_sys_tick(empty_code, nullptr) != 0 ? CounterKind::instructions
                                                    : CounterKind::none;
    empty_ = 0;
    empty_ = count(empty_code, nullptr);
  }

  static CounterScale scale() {
    if (kind_ == CounterKind::instructions) return emulated;
    return kind_ == CounterKind::cycles ? CounterScale{kind_, 1, 1} : CounterScale{kind_, 0, 0};
  }

  /// The empty bracket: call and return. Already subtracted from every count.
  static std::uint32_t empty() { return empty_; }

  /// Instructions (or cycles) of `code(argument)`, without the call and the return; interrupts masked. `count_overflow`
  /// where SysTick's 24 bits did not suffice.
  static std::uint32_t count(Measured code, void* argument) {
    const InterruptMask mask;
    if (kind_ == CounterKind::cycles) return bracket(&dwt().cycle_count, code, argument) - empty_;
    const std::uint32_t ticks = by_sys_tick(code, argument);
    return ticks == count_overflow ? ticks : instructions_of(ticks, emulated) - empty_;
  }

 private:
  static bool dwt_counts() {
    if constexpr (!has_dwt) return false;
    debug_monitor_control() |= trace_enable;
    dwt().cycle_count = 0;
    dwt().control |= dwt_cycle_counter_enable;
    asm volatile("nop\n\tnop\n\tnop\n\tnop");
    return dwt().cycle_count != 0;
  }

  /// Borrows SysTick: the control tick's period resumes where it stood, less the time that the code took.
  static std::uint32_t by_sys_tick(Measured code, void* argument) {
    auto& tick = sys_tick();
    const std::uint32_t control = tick.control, period = tick.reload, left = tick.current;
    tick.control = sys_tick_control::core_clock;
    tick.reload = sys_tick_span - 1;
    tick.control = sys_tick_control::core_clock | sys_tick_control::enable;
    const std::uint32_t end = bracket(&tick.current, code, argument);
    const bool wrapped = (tick.control & sys_tick_control::wrapped) != 0;
    const std::uint32_t elapsed = (sys_tick_span - end) % sys_tick_span;
    if ((control & sys_tick_control::interrupts) != 0) give_back(control, period, left, elapsed);
    return wrapped ? count_overflow : elapsed;
  }

  static void give_back(std::uint32_t control, std::uint32_t period, std::uint32_t left, std::uint32_t elapsed) {
    auto& tick = sys_tick();
    const bool due = elapsed >= left;
    if (due) system_control().interrupt_control = interrupt_control::set_pending_sys_tick;
    tick.reload = due ? period : left - elapsed;
    tick.current = 0;
    tick.control = control;
    while (tick.current == 0) {
    }  // one tick: the shortened period is loaded
    tick.reload = period;
  }

  inline static CounterKind kind_ = CounterKind::none;
  inline static std::uint32_t empty_ = 0;
};

}  // namespace axial::hal::cortex_m
