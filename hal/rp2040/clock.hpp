#pragma once
/// Clocks of the RP2040: ring oscillator out of reset, 12 MHz crystal, 125 MHz by the PLL.
/// Source: RP2040 Datasheet, 2.14 (resets), 2.15 (clocks), 2.16 (crystal), 2.17 (ring), 2.18 (PLL), 4.7.2 (tick).

#include <cstddef>
#include <cstdint>

#include <hal/clock.hpp>

namespace axial::hal::rp2040 {

using Register = volatile std::uint32_t;

struct ResetRegisters {
  Register reset, watchdog_select, done;
};
namespace block {
constexpr std::uint32_t io_bank0 = 1u << 5, pads_bank0 = 1u << 8, pll_sys = 1u << 12, sysinfo = 1u << 19,
                        timer = 1u << 21, uart0 = 1u << 22;
}

/// Takes blocks out of reset, and waits, with a bound, until they are.
template <class Resets>
void release(Resets& resets, std::uint32_t blocks) {
  resets.reset = resets.reset & ~blocks;
  wait_until([&] { return (resets.done & blocks) == blocks; });
}

struct CrystalRegisters {
  Register control, status, dormant, start_up;
};
struct PllRegisters {
  Register control, power, feedback, post_dividers;
};
struct ClockGenerator {
  Register control, divider, selected;
};
struct ClockRegisters {
  ClockGenerator outputs[4], reference, system, peripheral;
};
static_assert(offsetof(ClockRegisters, reference) == 0x30 && offsetof(ClockRegisters, peripheral) == 0x48);

namespace clock {
constexpr std::uint32_t crystal_Hz = 12'000'000, ring_Hz = 6'500'000;  // the ring's is nominal: 1.8 to 12 MHz
constexpr std::uint32_t feedback = 125, post_divider_1 = 6, post_divider_2 = 2;
constexpr std::uint32_t vco_Hz = crystal_Hz * feedback;                        // 12 MHz * 125 = 1 500 MHz
constexpr std::uint32_t core_Hz = vco_Hz / (post_divider_1 * post_divider_2);  // 1 500 MHz / 12 = 125 MHz
static_assert(vco_Hz >= 750'000'000 && vco_Hz <= 1'600'000'000, "VCO: 750 to 1 600 MHz (2.18.2)");
static_assert(feedback >= 16 && feedback <= 320, "feedback divider: 16 to 320 (2.18.2)");
static_assert(post_divider_1 >= post_divider_2, "the larger post divider comes first (2.18.2)");
static_assert(core_Hz == 125'000'000, "the core runs at 125 MHz");

// XOSC
constexpr std::uint32_t range_1_to_15_MHz = 0xAA0, crystal_enable = 0xFABu << 12, crystal_stable = 1u << 31;
constexpr std::uint32_t start_up_delay = (crystal_Hz / 1000 + 128) / 256;  // 1 ms in steps of 256 periods (2.16.3)
// PLL_SYS
constexpr std::uint32_t locked = 1u << 31, reference_by_1 = 1, dsm_power_down = 1u << 2, post_power_down = 1u << 3;
constexpr std::uint32_t post_dividers = post_divider_1 << 16 | post_divider_2 << 12;
// CLK_REF_CTRL, CLK_SYS_CTRL, CLK_PERI_CTRL; WATCHDOG_TICK
constexpr std::uint32_t reference_from_crystal = 2, system_from_reference = 0, system_from_pll = 1;
constexpr std::uint32_t peripheral_enable = 1u << 11, tick_enable = 1u << 9;

/// Has a multiplexer choose an input; `selected` has one bit for each, and the switch no glitch.
template <class Generator>
bool select(Generator& generator, std::uint32_t source) {
  generator.control = source;
  return wait_until([&] { return generator.selected == 1u << source; });
}

template <class Crystal>
bool start_crystal(Crystal& crystal) {
  crystal.control = range_1_to_15_MHz;
  crystal.start_up = start_up_delay;
  crystal.control = range_1_to_15_MHz | crystal_enable;
  return wait_until([&] { return (crystal.status & crystal_stable) != 0; });
}

/// What the parts of this family differ in.
struct Rp2040Plan {
  static constexpr std::uint32_t ring_Hz = clock::ring_Hz, core_Hz = clock::core_Hz, pll_block = block::pll_sys;
  static constexpr std::uint32_t feedback = clock::feedback, post_dividers = clock::post_dividers;

  /// Has the tick of the timer and of the watchdog be `cycles` of the reference.
  template <class Chip>
  static void start_tick(Chip& chip, std::uint32_t cycles) {
    chip.tick = tick_enable | cycles;
  }
};

template <class Plan, class Chip>
bool start_pll(Chip& chip) {
  auto& pll = chip.pll;
  release(chip.resets, Plan::pll_block);
  pll.control = reference_by_1;
  pll.feedback = Plan::feedback;
  pll.power = dsm_power_down | post_power_down;
  if (!wait_until([&] { return (pll.control & locked) != 0; })) return false;
  pll.post_dividers = Plan::post_dividers;
  pll.power = dsm_power_down;
  return true;
}

/// Crystal, PLL, switch-over; each wait is bounded. Without the PLL the crystal drives the core, without the crystal
/// the ring that runs since reset. The port's clock is the core's; the tick of the timer and of the watchdog is 1 us of
/// the reference, longer by a thirteenth on the nominal ring. `Chip` holds the registers `crystal`, `pll`, `clocks`,
/// `resets` and `tick`, so that a host test can play them.
template <class Plan = Rp2040Plan, class Chip>
ClockReport start(Chip&& chip) {
  const auto run = [&](ClockSource source, std::uint32_t system_Hz, std::uint32_t reference_Hz) -> ClockReport {
    chip.clocks.peripheral.control = peripheral_enable;
    Plan::start_tick(chip, (reference_Hz + 999'999) / 1'000'000);
    return {source, system_Hz, system_Hz};
  };
  select(chip.clocks.system, system_from_reference);
  if (!start_crystal(chip.crystal) || !select(chip.clocks.reference, reference_from_crystal))
    return run(ClockSource::internal, Plan::ring_Hz, Plan::ring_Hz);
  if (start_pll<Plan>(chip) && select(chip.clocks.system, system_from_pll))
    return run(ClockSource::crystal, Plan::core_Hz, crystal_Hz);
  select(chip.clocks.system, system_from_reference);
  return run(ClockSource::crystal_alone, crystal_Hz, crystal_Hz);
}
}  // namespace clock

}  // namespace axial::hal::rp2040
