#pragma once
/// A board that only measures: an emulated core at a fixed clock without a serial port, so that the main job does not
/// run.

#include <cstddef>

#include <hal/cortex_m/board_base.hpp>

namespace axial::hal::cortex_m {

/// A serial port that is not there.
struct NoSerialPort {
  static std::uint32_t start(std::uint32_t, std::uint32_t) { return 0; }
  static bool read(std::uint8_t&) { return false; }
  static bool write(const std::uint8_t*, std::size_t) { return false; }
  static bool idle() { return true; }
  static std::uint32_t overruns() { return 0; }
  static void interrupt() {}
};

/// `Derived` gives name, flash_bytes and ram_bytes.
template <class Derived, std::uint32_t emulator_Hz, std::uint32_t instruction_ns = usual_instruction_ns>
struct MeasuringBoard : BoardBase<Derived, emulator_Hz, instruction_ns> {
  static constexpr std::uint32_t baud = 0;
  using Serial = NoSerialPort;

  static constexpr unsigned interrupt_lines = 32, serial_line = 0;
  static constexpr Interrupt interrupts[] = {{serial_line, Serial::interrupt}};

  static ClockReport start_clock() { return {ClockSource::emulator, emulator_Hz, emulator_Hz}; }
  static void connect_pins() {}
};

}  // namespace axial::hal::cortex_m
