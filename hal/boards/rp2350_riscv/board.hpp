#pragma once
/// RP2350 on a Raspberry Pi Pico 2, its RISC-V cores: Hazard3 at 150 MHz, RV32IMAC with bit manipulation and without a
/// floating-point unit, 4 MiB of flash, 520 KiB of SRAM, where start-up copies the code to, 12 MHz crystal; UART0 on
/// GPIO 0 (sends) and GPIO 1 (receives); the drives' pin is GPIO 2, high for enabled. The second core is left where the
/// boot ROM has it. QEMU has the core and no peripheral. Source: RP2350 Datasheet (SIO and its timer: 3.1; addresses:
/// 2.2; interrupts: 3.2).

#include <hal/pl011/uart.hpp>
#include <hal/riscv/board_base.hpp>
#include <hal/riscv/hazard3.hpp>
#include <hal/rp2350/clock.hpp>
#include <hal/rp2350/pins.hpp>
#include <hal/rp2350/watchdog.hpp>

namespace axial::hal {

namespace rp2350 {

template <class Block>
Block& at(std::uintptr_t address) {
  return *reinterpret_cast<Block*>(address);
}

constexpr std::uintptr_t port_address = 0xD0000000;
inline rp2040::ResetRegisters& resets() { return at<rp2040::ResetRegisters>(0x40020000); }
inline BankRegisters& bank() { return at<BankRegisters>(0x40028000); }
inline PadRegisters& pads() { return at<PadRegisters>(0x40038000); }
inline PortRegisters& port() { return at<PortRegisters>(port_address); }

struct WatchdogPort {
  static rp2040::WatchdogRegisters& registers() { return at<rp2040::WatchdogRegisters>(0x400D8000); }
  static rp2040::PowerRegisters& power() { return at<rp2040::PowerRegisters>(0x40018000); }
};
struct Uart0 {
  static pl011::UartRegisters& registers() { return at<pl011::UartRegisters>(0x40070000); }
};

/// What clock::start asks for.
struct Chip {
  rp2040::CrystalRegisters& crystal = at<rp2040::CrystalRegisters>(0x40048000);
  rp2040::PllRegisters& pll = at<rp2040::PllRegisters>(0x40050000);
  rp2040::ClockRegisters& clocks = at<rp2040::ClockRegisters>(0x40010000);
  rp2040::ResetRegisters& resets = rp2350::resets();
  TicksRegisters& ticks = at<TicksRegisters>(0x40108000);
};

/// The timer counts the tick of 1 us.
struct Platform {
  using Interrupts = riscv::Hazard3Interrupts<riscv::Hazard3Registers>;
  static constexpr std::uint32_t timebase_Hz = 1'000'000;
  static volatile std::uint32_t* timer() { return &at<volatile std::uint32_t>(port_address + 0x1B0); }
  static volatile std::uint32_t* timer_compare() { return &at<volatile std::uint32_t>(port_address + 0x1B8); }

  /// Restarts by the watchdog, which resets all but the oscillators.
  [[noreturn]] static void restart() {
    Watchdog<WatchdogPort>::trigger();
    for (;;)
      asm volatile("" ::: "memory");
  }
};

}  // namespace rp2350

struct Rp2350Riscv : riscv::BoardBase<Rp2350Riscv, rp2350::Platform, 64> {
  static constexpr const char* name = "rp2350_riscv";
  static constexpr std::uint32_t flash_bytes = 4096 * 1024, ram_bytes = 520 * 1024;
  /// 150 MHz / (16 * 4.6875); from the crystal alone 750 kbit/s.
  static constexpr std::uint32_t baud = 2'000'000;
  using Serial = pl011::Uart<rp2350::Uart0, 1024>;
  using Watchdog = rp2350::Watchdog<rp2350::WatchdogPort>;

  struct DrivePin {
    static constexpr std::uintptr_t off_register = rp2350::port_address + offsetof(rp2350::PortRegisters, output_clear);
    static constexpr std::uint32_t off_word = rp2350::drive_pin::on;
    static void start() { rp2350::drive_pin::start(rp2350::resets(), rp2350::port(), rp2350::bank(), rp2350::pads()); }
    static void set(bool enabled) { rp2350::drive_pin::set(rp2350::port(), enabled); }
    static bool level() { return rp2350::drive_pin::level(rp2350::port(), rp2350::bank()); }
  };

  static constexpr unsigned serial_line = 33;
  static constexpr Interrupt interrupts[] = {{serial_line, Serial::interrupt}};

  static ResetCause take_reset_flags() { return rp2040::reset_cause(rp2350::WatchdogPort::registers().reason); }

  /// The core counts nothing until it is told to.
  static ClockReport start_clock() {
    riscv::write<riscv::Csr::count_inhibit>(0);
    if (!riscv::Hazard3Registers::present()) return {ClockSource::emulator, emulator_Hz, rp2350::clock::core_Hz};
    return rp2040::clock::start<rp2350::Plan>(rp2350::Chip{});
  }
  static void connect_pins() { rp2350::connect_uart0(rp2350::resets(), rp2350::bank(), rp2350::pads()); }
};

using Board = Rp2350Riscv;

static_assert(pl011::uart_rate(rp2350::clock::core_Hz, Rp2350Riscv::baud).baud == Rp2350Riscv::baud);

}  // namespace axial::hal
