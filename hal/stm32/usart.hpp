#pragma once
/// The USART of STM32F1 and STM32F4: received by interrupt into a ring, sent by polling with a bound.
/// Source: RM0090 chapter 30, RM0041 chapter 23 (the register blocks are the same).

#include <cstddef>
#include <cstdint>

#include <hal/serial_port.hpp>

namespace axial::hal::stm32 {

using Register = volatile std::uint32_t;

struct UsartRegisters {
  Register status, data, baud, control1, control2, control3;
};
namespace usart_status {
constexpr std::uint32_t overrun = 1u << 3, received = 1u << 5, sent = 1u << 7;
}
namespace usart_control1 {
constexpr std::uint32_t receiver = 1u << 2, transmitter = 1u << 3, receive_interrupt = 1u << 5, enable = 1u << 13,
                        oversample_8 = 1u << 15;
}

/// Contents of the baud register for a clock and a rate.
struct UsartDivider {
  std::uint32_t baud_register;
  bool oversample_8;
  std::uint32_t baud;  ///< the rate that results
};

/// Nearest whole number of clocks a bit; oversampling by 16 where it allows, else by 8. A rate above clock/8 is out of
/// reach: the result is clock/8.
constexpr UsartDivider usart_divider(std::uint32_t clock_Hz, std::uint32_t baud) {
  const std::uint32_t nearest = (clock_Hz + baud / 2) / baud;
  const std::uint32_t clocks = nearest < 8 ? 8 : nearest;
  const bool by_8 = clocks < 16;
  // By 8 the fraction has three bits (eighths) in a four-bit field.
  const std::uint32_t value = by_8 ? ((clocks >> 3) << 4) | (clocks & 7u) : clocks;
  return {value, by_8, clock_Hz / clocks};
}

/// One serial port. `Port` gives `registers()`, a reference to UsartRegisters or to what plays them.
template <class Port, std::size_t receive_capacity>
class Usart : public SerialPort<Usart<Port, receive_capacity>, receive_capacity> {
  using Base = SerialPort<Usart, receive_capacity>;

 public:
  /// Starts the port; returns the baud rate that runs.
  static std::uint32_t start(std::uint32_t clock_Hz, std::uint32_t baud) {
    using namespace usart_control1;
    const UsartDivider divider = usart_divider(clock_Hz, baud);
    auto& port = Port::registers();
    port.baud = divider.baud_register;
    port.control1 = enable | receiver | transmitter | receive_interrupt | (divider.oversample_8 ? oversample_8 : 0u);
    return divider.baud;
  }

  /// The interrupt: takes bytes until none is left; QEMU withdraws the interrupt with the first, even if it has handed
  /// over a second. Reading status, then data, clears the overrun flag too.
  static void interrupt() {
    using namespace usart_status;
    auto& port = Port::registers();
    while (true) {
      const std::uint32_t status = port.status;
      if ((status & (received | overrun)) == 0) return;
      const auto byte = static_cast<std::uint8_t>(port.data);
      const bool full = (status & received) != 0 && !Base::keep(byte);
      if (full || (status & overrun) != 0) Base::lose();
    }
  }

 private:
  friend Base;

  /// Sends a byte, as SerialPort asks.
  static bool send(std::uint8_t byte) {
    auto& port = Port::registers();
    if (!Base::wait_until([&port] { return (port.status & usart_status::sent) != 0; })) return false;
    port.data = byte;
    return true;
  }
};

}  // namespace axial::hal::stm32
