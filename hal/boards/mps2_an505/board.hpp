#pragma once
/// Arm MPS2+ with the AN505 image: Cortex-M33 in an FPGA, 20 MHz, in secure state. Measures only: no serial port, so
/// that the main job does not run here. Emulated by QEMU's `mps2-an505`, which gives it the floating-point unit that
/// most parts with this core have. Source: Arm DAI 0505, memory map.

#include <hal/cortex_m/measuring_board.hpp>

namespace axial::hal {

namespace mps2_an505 {
struct Fpga {
  static constexpr std::uintptr_t lights_address = 0x50302000, watchdog_address = 0x5002E000;
  static constexpr std::uint32_t watchdog_Hz = 32'768;
};
}  // namespace mps2_an505

struct Mps2An505 : cortex_m::MeasuringBoard<Mps2An505, mps2_an505::Fpga, 20'000'000, 128> {
  static constexpr const char* name = "mps2_an505";
  static constexpr std::uint32_t flash_bytes = 4096 * 1024, ram_bytes = 4096 * 1024;
};

using Board = Mps2An505;

}  // namespace axial::hal
