#pragma once
/// A board that only measures: an emulated core at a fixed clock without a serial port, so that the main job does not
/// run.

#include <cstddef>

#include <hal/cmsdk/light_pin.hpp>
#include <hal/cmsdk/watchdog.hpp>
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

/// `Derived` gives name, flash_bytes and ram_bytes; `Fpga` the addresses of its lights and watchdog, and the watchdog's
/// clock.
template <class Derived, class Fpga, std::uint32_t emulator_Hz, std::uint32_t instruction_ns = usual_instruction_ns>
struct MeasuringBoard : BoardBase<Derived, emulator_Hz, Counter<emulator_Hz, instruction_ns>> {
  static constexpr std::uint32_t baud = 0;
  using Serial = NoSerialPort;
  struct WatchdogPort {
    static constexpr std::uint32_t clock_Hz = Fpga::watchdog_Hz;
    static cmsdk::WatchdogRegisters& registers() { return at<cmsdk::WatchdogRegisters>(Fpga::watchdog_address); }
  };
  using Watchdog = cmsdk::Watchdog<WatchdogPort>;
  using EmulatedWatchdog = NoEmulatedWatchdog;
  static constexpr bool watchdog_is_non_maskable = true;
  using DrivePin = cmsdk::LightPin<Fpga::lights_address>;

  static constexpr unsigned interrupt_lines = 32, serial_line = 0;
  static constexpr Interrupt interrupts[] = {{serial_line, Serial::interrupt}};

  /// The boards have no flags: a report tells, or nobody does.
  static ResetCause take_reset_flags() { return ResetCause::power_on; }
  static ClockReport start_clock() { return {ClockSource::emulator, emulator_Hz, emulator_Hz}; }
  static void connect_pins() {}
};

}  // namespace axial::hal::cortex_m
