#pragma once
/// Arm MPS2 with the AN500 image: Cortex-M7 in an FPGA, 25 MHz. Measures only: no serial port, so that the main job
/// does not run here. Emulated by QEMU's `mps2-an500`. Source: Arm DAI 0500, memory map.

#include <hal/cortex_m/measuring_board.hpp>

namespace axial::hal {

namespace mps2_an500 {
struct Fpga {
  static constexpr std::uintptr_t lights_address = 0x40028000, watchdog_address = 0x40008000;
  static constexpr std::uint32_t watchdog_Hz = 25'000'000;
};
}  // namespace mps2_an500

struct Mps2An500 : cortex_m::MeasuringBoard<Mps2An500, mps2_an500::Fpga, 25'000'000> {
  static constexpr const char* name = "mps2_an500";
  static constexpr std::uint32_t flash_bytes = 4096 * 1024, ram_bytes = 4096 * 1024;
};

using Board = Mps2An500;

}  // namespace axial::hal
