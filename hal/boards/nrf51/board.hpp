#pragma once
/// nRF51822 of the BBC micro:bit: Cortex-M0, 16 MHz, 256 KiB flash, 16 KiB RAM. Measures only: no serial port, so that
/// the main job does not run here. Emulated by QEMU's `microbit`, whose core has the SysTick that counts; the part
/// itself has none. Source: nRF51 Series Reference Manual 3.0, memory map.

#include <hal/cortex_m/measuring_board.hpp>

namespace axial::hal {

struct Nrf51 : cortex_m::MeasuringBoard<Nrf51, 16'000'000, 128> {
  static constexpr const char* name = "nrf51";
  static constexpr std::uint32_t flash_bytes = 256 * 1024, ram_bytes = 16 * 1024;
};

using Board = Nrf51;

}  // namespace axial::hal
