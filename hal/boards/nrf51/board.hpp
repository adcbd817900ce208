#pragma once
/// nRF51822 of the BBC micro:bit: Cortex-M0, 16 MHz, 256 KiB flash, 16 KiB RAM. Measures only: no serial port, so that
/// the main job does not run here. Emulated by QEMU's `microbit`, whose core has the SysTick that counts; the part
/// itself has none. Source: nRF51 Series Reference Manual 3.0, memory map.

#include <hal/cortex_m/board_base.hpp>
#include <hal/no_serial_port.hpp>

namespace axial::hal {

struct Nrf51 : cortex_m::BoardBase<Nrf51, 16'000'000, 128> {
  static constexpr const char* name = "nrf51";
  static constexpr std::uint32_t flash_bytes = 256 * 1024, ram_bytes = 16 * 1024;
  static constexpr std::uint32_t baud = 0;
  using Serial = NoSerialPort;

  static constexpr unsigned interrupt_lines = 32, serial_line = 0;
  static constexpr cortex_m::Interrupt interrupts[] = {{serial_line, Serial::interrupt}};

  static ClockReport start_clock() { return {ClockSource::emulator, emulator_Hz, emulator_Hz}; }
  static void connect_pins() {}
};

using Board = Nrf51;

}  // namespace axial::hal
