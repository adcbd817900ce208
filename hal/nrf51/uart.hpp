#pragma once
/// The UART of the nRF51 series: received by interrupt into a ring, sent by polling with a bound.
/// Source: nRF51 Series Reference Manual 3.0, chapter 29.

#include <cstddef>
#include <cstdint>

#include <hal/serial_port.hpp>

namespace axial::hal::nrf51 {

using Register = volatile std::uint32_t;

/// A task starts when 1 is written to it; an event reads as 1 until 0 is written to it.
struct UartRegisters {
  Register start_receiver, stop_receiver, start_transmitter, stop_transmitter;
  Register reserved0[60];
  Register clear_to_send, not_clear_to_send, received;
  Register reserved1[4];
  Register sent, reserved2, error;
  Register reserved3[119];
  Register interrupt_enable_set, interrupt_enable_clear;
  Register reserved4[93];
  Register error_source;
  Register reserved5[31];
  Register enable, reserved6, pin_request_to_send, pin_transmit, pin_clear_to_send, pin_receive, receive, transmit;
  Register reserved7, baud;
};
static_assert(offsetof(UartRegisters, received) == 0x108 && offsetof(UartRegisters, error) == 0x124);
static_assert(offsetof(UartRegisters, interrupt_enable_set) == 0x304 && offsetof(UartRegisters, error_source) == 0x480);
static_assert(offsetof(UartRegisters, enable) == 0x500 && offsetof(UartRegisters, baud) == 0x524);

namespace uart_interrupt {
constexpr std::uint32_t received = 1u << 2, error = 1u << 9;
}
constexpr std::uint32_t uart_overrun = 1u << 0, uart_enabled = 4;
constexpr std::uint32_t uart_clock_Hz = 16'000'000, most_baud = 1'000'000;

/// Contents of the baud register for a rate, and the rate that results.
struct UartRate {
  std::uint32_t baud_register, baud;
};

/// The register holds the rate in steps of 16 MHz / 2^20, in its upper 20 bits; 1 Mbit/s is the most.
constexpr UartRate uart_rate(std::uint32_t baud) {
  const std::uint64_t wanted = baud < most_baud ? baud : most_baud;
  const std::uint64_t steps = ((wanted << 20) + uart_clock_Hz / 2) / uart_clock_Hz;
  return {static_cast<std::uint32_t>(steps << 12), static_cast<std::uint32_t>((steps * uart_clock_Hz) >> 20)};
}

/// One serial port. `Port` gives `static UartRegisters& registers()` and the numbers of its pins, `transmit_pin` and
/// `receive_pin`.
template <class Port, std::size_t receive_capacity>
class Uart : public SerialPort<Uart<Port, receive_capacity>, receive_capacity> {
  using Base = SerialPort<Uart, receive_capacity>;

 public:
  /// Starts the port; returns the baud rate that runs. Its clock is always 16 MHz.
  static std::uint32_t start(std::uint32_t, std::uint32_t baud) {
    const UartRate rate = uart_rate(baud);
    auto& port = Port::registers();
    port.pin_transmit = Port::transmit_pin;
    port.pin_receive = Port::receive_pin;
    port.baud = rate.baud_register;
    port.enable = uart_enabled;
    port.interrupt_enable_set = uart_interrupt::received | uart_interrupt::error;
    port.start_transmitter = 1;
    port.start_receiver = 1;
    return rate.baud;
  }

  /// The interrupt: empties the receiver's queue of six bytes. The event is cleared before a byte is taken: the next
  /// byte in the queue sets it again.
  static void interrupt() {
    auto& port = Port::registers();
    while (port.received != 0) {
      port.received = 0;
      if (!Base::keep(static_cast<std::uint8_t>(port.receive))) Base::lose();
    }
    if (port.error == 0) return;
    port.error = 0;
    const std::uint32_t source = port.error_source;
    port.error_source = source;  // written ones clear
    if ((source & uart_overrun) != 0) Base::lose();
  }

 private:
  friend Base;

  /// Sends a byte, as SerialPort asks.
  static bool send(std::uint8_t byte) {
    auto& port = Port::registers();
    port.sent = 0;
    port.transmit = byte;
    return Base::wait_until([&port] { return port.sent != 0; });
  }
};

}  // namespace axial::hal::nrf51
