#pragma once
/// Arm MPS2 with the AN500 image: Cortex-M7 in an FPGA, 25 MHz. Measures only: no serial port, so that the main job does
/// not run here. Emulated by QEMU's `mps2-an500`. Source: Arm DAI 0500, memory map.

#include <hal/cortex_m/board_base.hpp>
#include <hal/no_serial_port.hpp>

namespace axial::hal {

struct Mps2An500 : cortex_m::BoardBase<Mps2An500, 25'000'000> {
  static constexpr const char* name = "mps2_an500";
  static constexpr std::uint32_t flash_bytes = 4096 * 1024, ram_bytes = 4096 * 1024;
  static constexpr std::uint32_t baud = 0;
  using Serial = NoSerialPort;

  static constexpr unsigned interrupt_lines = 32, serial_line = 0;
  static constexpr cortex_m::Interrupt interrupts[] = {{serial_line, Serial::interrupt}};

  /// The FPGA's clock is fixed.
  static ClockReport start_clock() { return {ClockSource::emulator, emulator_Hz, emulator_Hz}; }
  static void connect_pins() {}
};

using Board = Mps2An500;

}  // namespace axial::hal
