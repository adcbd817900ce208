#pragma once
/// RV32IMAC of QEMU's `virt` machine, without a floating-point unit: no part of silicon. Memory as on a small part:
/// 256 KiB of flash, 32 KiB of RAM, both cut out of the machine's RAM; the flash is protected from stores.
/// The machine has no pins: a word of RAM, `axial_drive_pin`, stands for the drives' pin. Nor has it a watchdog: the
/// machine timer is one. Source: the machine's device tree (QEMU 7.2, -machine dumpdtb).

#include <hal/ns16550/uart.hpp>
#include <hal/riscv/board_base.hpp>

namespace axial::hal {

namespace rv32_virt {

struct Platform {
  static constexpr std::uint32_t timebase_Hz = 10'000'000;
  static volatile std::uint32_t* timer_compare() { return words(0x02004000); }
  static volatile std::uint32_t* timer() { return words(0x0200BFF8); }
  static volatile std::uint32_t* plic() { return words(0x0C000000); }

  /// Restarts by the machine's test device, "sifive,test1".
  [[noreturn]] static void restart() {
    constexpr std::uint32_t reset = 0x7777;
    for (;;)
      *words(0x00100000) = reset;
  }

 private:
  static volatile std::uint32_t* words(std::uintptr_t address) {
    return reinterpret_cast<volatile std::uint32_t*>(address);
  }
};

constexpr std::uint32_t uart_clock_Hz = 3'686'400;

struct Uart0 {
  static ns16550::UartRegisters& registers() { return *reinterpret_cast<ns16550::UartRegisters*>(0x10000000); }
};

}  // namespace rv32_virt

struct Rv32Virt : riscv::BoardBase<Rv32Virt, rv32_virt::Platform, 64> {
  static constexpr const char* name = "rv32_virt";
  static constexpr std::uint32_t flash_bytes = 256 * 1024, ram_bytes = 32 * 1024;
  /// The most that the port's clock gives, and exact. A 7-axis arm's request and answer take 6.3 ms: the tick is 10 ms.
  static constexpr std::uint32_t baud = 230'400, tick_Hz = 100;
  using Serial = ns16550::Uart<rv32_virt::Uart0, 1024>;

  struct DrivePin {
    static constexpr volatile std::uint32_t* off_register = &axial_drive_pin;
    static constexpr std::uint32_t off_word = 0;
    static void start() { set(false); }
    static void set(bool enabled) { *off_register = enabled ? 1 : off_word; }
    static bool level() { return *off_register != 0; }
  };
  /// The machine has no flags: a report tells, or nobody does.
  static ResetCause take_reset_flags() { return ResetCause::power_on; }

  static constexpr unsigned serial_line = 10;
  static constexpr Interrupt interrupts[] = {{serial_line, Serial::interrupt}};

  /// There is nothing to start.
  static ClockReport start_clock() { return {ClockSource::emulator, emulator_Hz, rv32_virt::uart_clock_Hz}; }
  static void connect_pins() {}
};

using Board = Rv32Virt;

static_assert(ns16550::uart_baud(rv32_virt::uart_clock_Hz, Rv32Virt::baud) == Rv32Virt::baud);

}  // namespace axial::hal
