#pragma once
/// Arm's PL011: received by interrupt into a ring, sent by polling with a bound, both through its queues of 32 bytes.
/// Source: PrimeCell UART (PL011) Technical Reference Manual (Arm DDI 0183), chapter 3.

#include <cstddef>
#include <cstdint>

#include <hal/serial_port.hpp>

namespace axial::hal::pl011 {

using Register = volatile std::uint32_t;

struct UartRegisters {
  Register data, errors, reserved0[4], flags, reserved1[2], whole_divider, fraction_divider, line, control, levels;
  Register interrupt_mask, raw_interrupts, interrupts, interrupt_clear;
};
static_assert(offsetof(UartRegisters, flags) == 0x18 && offsetof(UartRegisters, whole_divider) == 0x24);
static_assert(offsetof(UartRegisters, control) == 0x30 && offsetof(UartRegisters, interrupt_clear) == 0x44);

namespace flag {
constexpr std::uint32_t receive_empty = 1u << 4, send_full = 1u << 5;
}
namespace line {
constexpr std::uint32_t queues = 1u << 4, bits_8 = 3u << 5;
}
namespace control {
constexpr std::uint32_t enable = 1u << 0, send = 1u << 8, receive = 1u << 9;
}
namespace interrupt {
constexpr std::uint32_t received = 1u << 4, received_and_silent = 1u << 6;
}
constexpr std::uint32_t data_overrun = 1u << 11;

/// The divider in 64ths, and the rate that results.
struct UartRate {
  std::uint32_t divider, baud;
};

/// The nearest divider; from 1, a sixteenth of the clock, to 65 535.
constexpr UartRate uart_rate(std::uint32_t clock_Hz, std::uint32_t baud) {
  constexpr std::uint64_t least = 64, most = 65535 * 64;
  const std::uint64_t nearest = (std::uint64_t{8} * clock_Hz / baud + 1) / 2;
  const std::uint64_t divider = nearest < least ? least : nearest > most ? most : nearest;
  return {static_cast<std::uint32_t>(divider), static_cast<std::uint32_t>(std::uint64_t{4} * clock_Hz / divider)};
}

/// One serial port. `Port` gives `registers()`, a reference to UartRegisters or to what plays them.
template <class Port, std::size_t receive_capacity>
class Uart : public SerialPort<Uart<Port, receive_capacity>, receive_capacity> {
  using Base = SerialPort<Uart, receive_capacity>;

 public:
  /// Starts the port; returns the baud rate that runs. The line register comes after the dividers, which it has taken
  /// over. Out of reset the receiver interrupts when its queue is half full, or holds something and is silent for 32
  /// bits.
  static std::uint32_t start(std::uint32_t clock_Hz, std::uint32_t baud) {
    const UartRate rate = uart_rate(clock_Hz, baud);
    auto& port = Port::registers();
    port.whole_divider = rate.divider / 64;
    port.fraction_divider = rate.divider % 64;
    port.line = line::queues | line::bits_8;
    port.interrupt_mask = interrupt::received | interrupt::received_and_silent;
    port.control = control::enable | control::send | control::receive;
    return rate.baud;
  }

  /// Takes bytes until the queue is empty, which withdraws both interrupts. The byte behind a lost one says so.
  static void interrupt() {
    auto& port = Port::registers();
    while ((port.flags & flag::receive_empty) == 0) {
      const std::uint32_t data = port.data;
      const bool full = !Base::keep(static_cast<std::uint8_t>(data));
      if (full || (data & data_overrun) != 0) Base::lose();
    }
  }

 private:
  friend Base;

  /// Sends a byte, as SerialPort asks.
  static bool send(std::uint8_t byte) {
    auto& port = Port::registers();
    if (!Base::wait_until([&port] { return (port.flags & flag::send_full) == 0; })) return false;
    port.data = byte;
    return true;
  }
};

}  // namespace axial::hal::pl011
