#pragma once
/// The 16550 UART: received by interrupt into a ring, sent by polling with a bound.
/// Source: PC16550D data sheet (Texas Instruments SNLS378), section 8.

#include <cstddef>
#include <cstdint>

#include <hal/serial_port.hpp>

namespace axial::hal::ns16550 {

using Register = volatile std::uint8_t;

/// With the divisor latch open, `data` and `interrupt_enable` are the divisor's lower and upper byte.
struct UartRegisters {
  Register data, interrupt_enable, fifo_control, line_control, modem_control, line_status;
};

namespace line_status {
constexpr unsigned received = 1u << 0, overrun = 1u << 1, room_to_send = 1u << 5;
}
namespace interrupt_enable {
constexpr std::uint8_t received = 1u << 0, line_status = 1u << 2;
}
constexpr std::uint8_t eight_bits = 3, divisor_latch = 1u << 7;
/// Queues on and cleared; the receiver speaks up at the first byte.
constexpr std::uint8_t clear_queues = 7;

/// Sixteen clocks a bit times this; at least 1.
constexpr std::uint32_t uart_divisor(std::uint32_t clock_Hz, std::uint32_t baud) {
  const std::uint32_t nearest = (clock_Hz + 8 * baud) / (16 * baud);
  return nearest == 0 ? 1 : nearest;
}
constexpr std::uint32_t uart_baud(std::uint32_t clock_Hz, std::uint32_t baud) {
  return clock_Hz / 16 / uart_divisor(clock_Hz, baud);
}

/// One serial port. `Port` gives `registers()`, a reference to UartRegisters or to what plays them.
template <class Port, std::size_t receive_capacity>
class Uart : public SerialPort<Uart<Port, receive_capacity>, receive_capacity> {
  using Base = SerialPort<Uart, receive_capacity>;

 public:
  /// Starts the port; returns the baud rate that runs.
  static std::uint32_t start(std::uint32_t clock_Hz, std::uint32_t baud) {
    const std::uint32_t divisor = uart_divisor(clock_Hz, baud);
    auto& port = Port::registers();
    port.interrupt_enable = 0;
    port.line_control = divisor_latch | eight_bits;
    port.data = static_cast<std::uint8_t>(divisor);
    port.interrupt_enable = static_cast<std::uint8_t>(divisor >> 8);
    port.line_control = eight_bits;
    port.fifo_control = clear_queues;
    port.interrupt_enable = interrupt_enable::received | interrupt_enable::line_status;
    return uart_baud(clock_Hz, baud);
  }

  /// The interrupt: empties the receiver's queue. Reading the status clears the overrun flag.
  static void interrupt() {
    auto& port = Port::registers();
    while (true) {
      const unsigned status = port.line_status;
      if ((status & line_status::overrun) != 0) Base::lose();
      if ((status & line_status::received) == 0) return;
      if (!Base::keep(port.data)) Base::lose();
    }
  }

 private:
  friend Base;

  /// Sends a byte, as SerialPort asks.
  static bool send(std::uint8_t byte) {
    auto& port = Port::registers();
    if (!Base::wait_until([&port] { return (port.line_status & line_status::room_to_send) != 0; })) return false;
    port.data = byte;
    return true;
  }
};

}  // namespace axial::hal::ns16550
