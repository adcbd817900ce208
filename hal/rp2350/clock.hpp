#pragma once
/// Clocks of the RP2350, which are those of the RP2040 but for the blocks' numbers and the tick: ring oscillator out of
/// reset, 12 MHz crystal, 150 MHz by the PLL. Source: RP2350 Datasheet, 7.5 (resets), 8.1 (clocks), 8.5 (ticks), 8.6
/// (PLL).

#include <cstddef>
#include <cstdint>

#include <hal/rp2040/clock.hpp>

namespace axial::hal::rp2350 {

using rp2040::release;
using Register = volatile std::uint32_t;

namespace block {
constexpr std::uint32_t io_bank0 = 1u << 6, pads_bank0 = 1u << 9, pll_sys = 1u << 14, uart0 = 1u << 26;
}

/// One generator of a tick: so many cycles of the reference make one.
struct TickRegisters {
  Register control, cycles, count;
};
struct TicksRegisters {
  TickRegisters processor[2], timer[2], watchdog, riscv;
};
static_assert(offsetof(TicksRegisters, watchdog) == 0x30 && offsetof(TicksRegisters, riscv) == 0x3C);

namespace clock {
constexpr std::uint32_t feedback = 125, post_divider_1 = 5, post_divider_2 = 2;
constexpr std::uint32_t vco_Hz = rp2040::clock::crystal_Hz * feedback;         // 12 MHz * 125 = 1 500 MHz
constexpr std::uint32_t core_Hz = vco_Hz / (post_divider_1 * post_divider_2);  // 1 500 MHz / 10 = 150 MHz
static_assert(vco_Hz >= 750'000'000 && vco_Hz <= 1'600'000'000, "VCO: 750 to 1 600 MHz (8.6.2)");
static_assert(post_divider_1 >= post_divider_2, "the larger post divider comes first (8.6.2)");
static_assert(core_Hz == 150'000'000, "the core runs at 150 MHz");
}  // namespace clock

/// What rp2040::clock::start asks of the part.
struct Plan {
  static constexpr std::uint32_t ring_Hz = 11'000'000;  // nominal: 4.6 to 19.2 MHz
  static constexpr std::uint32_t core_Hz = clock::core_Hz, feedback = clock::feedback, pll_block = block::pll_sys;
  static constexpr std::uint32_t post_dividers = clock::post_divider_1 << 16 | clock::post_divider_2 << 12;

  /// The length comes before the start.
  template <class Chip>
  static void start_tick(Chip& chip, std::uint32_t cycles) {
    constexpr std::uint32_t enable = 1;
    chip.ticks.watchdog.cycles = cycles;
    chip.ticks.watchdog.control = enable;
    chip.ticks.riscv.cycles = cycles;
    chip.ticks.riscv.control = enable;
  }
};

}  // namespace axial::hal::rp2350
