#pragma once
/// The 16550 UART: received by interrupt into a ring, sent by polling with a bound.
/// Source: PC16550D data sheet (Texas Instruments SNLS378), section 8.

#include <cstddef>
#include <cstdint>

#include <hal/ring.hpp>

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
class Uart {
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
      if ((status & line_status::overrun) != 0) lose();
      if ((status & line_status::received) == 0) return;
      if (!received_.push(port.data)) lose();
    }
  }

  static bool read(std::uint8_t& byte) { return received_.pop(byte); }
  static bool idle() { return received_.empty(); }

  /// Bytes lost because the ring or the queue was full; at least one each.
  static std::uint32_t overruns() { return overruns_; }

  /// Sends `count` bytes. False when the port did not take a byte in time: the rest is dropped.
  static bool write(const std::uint8_t* bytes, std::size_t count) {
    auto& port = Port::registers();
    for (std::size_t i = 0; i < count; ++i) {
      if (!wait_for_room(port)) return false;
      port.data = bytes[i];
    }
    return true;
  }

 private:
  static void lose() { overruns_ = overruns_ + 1; }

  template <class Registers>
  static bool wait_for_room(Registers& port) {
    constexpr unsigned polls = 20000;  // a byte takes under 1 000 looks at every supported rate
    for (unsigned i = 0; i < polls; ++i) {
      if ((port.line_status & line_status::room_to_send) != 0) return true;
    }
    return false;
  }

  inline static ByteRing<receive_capacity> received_{};
  inline static volatile std::uint32_t overruns_ = 0;
};

}  // namespace axial::hal::ns16550
