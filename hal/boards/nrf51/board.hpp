#pragma once
/// nRF51822: Cortex-M0, 16 MHz, 256 KiB flash, 16 KiB RAM. Wired as on the BBC micro:bit: 16 MHz crystal; UART on P0.24
/// (transmit) and P0.25 (receive); the drives' pin is P0.03, the edge connector's ring 0, high for enabled, with a
/// pull-down of 10 kOhm outside, because it is an open input out of reset. Emulated by QEMU's `microbit`, whose core
/// has a SysTick that counts instructions; the part itself has none, so there no counter runs. Source: nRF51 Series
/// Reference Manual 3.0 (clock: chapter 13; GPIO: 14; TIMER: 18; UART: 29).

#include <hal/cortex_m/board_base.hpp>
#include <hal/nrf51/timer_tick.hpp>
#include <hal/nrf51/uart.hpp>
#include <hal/nrf51/watchdog.hpp>

namespace axial::hal {

namespace nrf51 {

using cortex_m::at;

struct ClockRegisters {
  Register start_crystal, stop_crystal;
  Register reserved0[62];
  Register crystal_started;
  Register reserved1[194];
  Register status;
};
static_assert(offsetof(ClockRegisters, crystal_started) == 0x100 && offsetof(ClockRegisters, status) == 0x40C);
struct PinRegisters {
  Register reserved0[321];
  Register output, output_set, output_clear, input, direction, direction_set, direction_clear;
  Register reserved1[120];
  Register configuration[32];
};
static_assert(offsetof(PinRegisters, output) == 0x504 && offsetof(PinRegisters, configuration) == 0x700);

inline ClockRegisters& clock_registers() { return at<ClockRegisters>(0x40000000); }
constexpr std::uintptr_t pins_address = 0x50000000;
inline PinRegisters& pins() { return at<PinRegisters>(pins_address); }
inline Register& reset_reasons() { return at<Register>(0x40000400); }

namespace clock {
constexpr std::uint32_t core_Hz = 16'000'000;  // crystal and internal oscillator alike; there is no PLL
constexpr std::uint32_t from_crystal = 1u << 0, running = 1u << 16;

/// Crystal, else the internal oscillator that runs since reset; the wait is bounded. QEMU reads 1 everywhere: a crystal
/// that is said to have started, and a clock that does not run. The registers are an argument so that a host test can
/// play a broken crystal.
template <class Registers>
ClockReport start(Registers& registers, std::uint32_t emulator_Hz) {
  registers.crystal_started = 0;
  registers.start_crystal = 1;
  const bool started = wait_until([&] { return registers.crystal_started != 0; });
  const std::uint32_t status = registers.status;
  if ((status & running) == 0) return {ClockSource::emulator, emulator_Hz, emulator_Hz};
  if (started && (status & from_crystal) != 0) return {ClockSource::crystal, core_Hz, core_Hz};
  return {ClockSource::internal, core_Hz, core_Hz};
}
}  // namespace clock

/// P0.03.
namespace drive_pin {
constexpr std::uint32_t on = 1u << 3;

template <class Pins>
void set(Pins& pins, bool enabled) {
  (enabled ? pins.output_set : pins.output_clear) = on;
}

/// Low first, then an output. The registers are an argument so that a host test can play them.
template <class Pins>
void start(Pins& pins) {
  set(pins, false);
  pins.direction_set = on;
}

/// Whether the port drives the pin high.
template <class Pins>
bool level(Pins& pins) {
  return (pins.direction & pins.output & on) != 0;
}
}  // namespace drive_pin

struct WatchdogPort {
  static WatchdogRegisters& registers() { return at<WatchdogRegisters>(0x40010000); }
};
struct Uart0 {
  static constexpr std::uint32_t transmit_pin = 24, receive_pin = 25;
  static UartRegisters& registers() { return at<UartRegisters>(0x40002000); }
};
struct Timer0 {
  static constexpr unsigned line = 8;
  static TimerRegisters& registers() { return at<TimerRegisters>(0x40008000); }
  static void enable_line() { cortex_m::enable_interrupt(line); }
};

}  // namespace nrf51

struct Nrf51 : cortex_m::BoardBase<Nrf51, nrf51::clock::core_Hz, cortex_m::Counter<nrf51::clock::core_Hz, 128>> {
  static constexpr const char* name = "nrf51";
  static constexpr std::uint32_t flash_bytes = 256 * 1024, ram_bytes = 16 * 1024;
  /// The most that the part has, and exact. A 7-axis arm's request and answer take 1.5 ms: the tick is 2 ms.
  static constexpr std::uint32_t baud = nrf51::most_baud, tick_Hz = 500;
  using Serial = nrf51::Uart<nrf51::Uart0, 512>;
  using Tick = nrf51::TimerTick<nrf51::Timer0>;
  using Watchdog = nrf51::Watchdog<nrf51::WatchdogPort>;
  struct DrivePin {
    static constexpr std::uintptr_t off_register = nrf51::pins_address + offsetof(nrf51::PinRegisters, output_clear);
    static constexpr std::uint32_t off_word = nrf51::drive_pin::on;
    static void start() { nrf51::drive_pin::start(nrf51::pins()); }
    static void set(bool enabled) { nrf51::drive_pin::set(nrf51::pins(), enabled); }
    static bool level() { return nrf51::drive_pin::level(nrf51::pins()); }
  };

  static constexpr unsigned interrupt_lines = 26, serial_line = 2;
  static constexpr Interrupt interrupts[] = {{serial_line, Serial::interrupt}, {nrf51::Timer0::line, Tick::interrupt}};
  /// Only an emulator has the timer.
  static void sys_tick_interrupt() {
    if constexpr (AXIAL_SEMIHOSTING != 0) EmulatedWatchdog::interrupt();
  }

  static ResetCause take_reset_flags() { return nrf51::take_reset_flags(nrf51::reset_reasons()); }

  static ClockReport start_clock() { return nrf51::clock::start(nrf51::clock_registers(), emulator_Hz); }

  /// The transmitter's pin drives high while the port is off; the receiver's has a pull-up, so that an open line reads
  /// idle.
  static void connect_pins() {
    constexpr std::uint32_t input_with_pull_up = 3u << 2;
    auto& pins = nrf51::pins();
    pins.output_set = 1u << nrf51::Uart0::transmit_pin;
    pins.direction_set = 1u << nrf51::Uart0::transmit_pin;
    pins.configuration[nrf51::Uart0::receive_pin] = input_with_pull_up;
  }
};

using Board = Nrf51;

static_assert(nrf51::uart_rate(Nrf51::baud).baud == Nrf51::baud);

}  // namespace axial::hal
