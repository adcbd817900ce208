#pragma once
/// Which clock a board runs from after start-up.

#include <cstdint>

namespace axial::hal {

enum class ClockSource : std::uint8_t {
  crystal = 0,   ///< the PLL on the external crystal, as designed
  internal = 1,  ///< the internal oscillator: the crystal, or the PLL on it, did not become ready in time
  emulator = 2,  ///< the fallback was taken and not even the running oscillator reads as ready: the clock controller
                 ///< is not modelled, and the emulated machine's fixed rate applies
  crystal_alone = 3  ///< the external crystal without its PLL, which did not become ready in time
};

struct ClockReport {
  ClockSource source;
  std::uint32_t core_Hz;
  std::uint32_t uart_Hz;  ///< clock of the serial port's bus
};

/// Waits until `ready()` holds, for at most `polls` looks. At 16 MHz 20 000 looks last about 10 ms; a crystal starts
/// in 2 ms.
template <class Ready>
bool wait_until(Ready ready, unsigned polls = 20000) {
  for (unsigned i = 0; i < polls; ++i) {
    if (ready()) return true;
  }
  return false;
}

}  // namespace axial::hal
