#pragma once
/// The watchdog of the RP2350: the RP2040's, which counts its tick once. Source: RP2350 Datasheet, 7.3 (power-on state
/// machine), 12.9 (watchdog).

#include <hal/rp2040/watchdog.hpp>

namespace axial::hal::rp2350 {

struct Watch {
  /// Ticks of 1 us; at most 16 777 ms.
  static constexpr std::uint32_t a_ms = 1000;
  /// What a restart resets: all but the ring (bit 2) and the crystal (bit 3).
  static constexpr std::uint32_t everything = 0x1FFFFFF & ~0xCu;
};

template <class Port>
using Watchdog = rp2040::Watchdog<Port, Watch>;

}  // namespace axial::hal::rp2350
