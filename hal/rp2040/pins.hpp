#pragma once
/// Pins of the RP2040: bank 0, its pads, and the processors' own port (SIO).
/// Source: RP2040 Datasheet, 2.3.1.2 (SIO), 2.19 (GPIO).

#include <cstddef>
#include <cstdint>

#include <hal/rp2040/clock.hpp>

namespace axial::hal::rp2040 {

struct BankRegisters {
  struct {
    Register status, control;
  } pin[30];
};
struct PadRegisters {
  Register voltage, pin[30];
};
struct PortRegisters {
  Register processor, input, input_flash, reserved;
  Register output, output_set, output_clear, output_toggle;
  Register drive, drive_set, drive_clear, drive_toggle;
};
static_assert(offsetof(PortRegisters, output_clear) == 0x18 && offsetof(PortRegisters, drive_set) == 0x24);

namespace function {
constexpr std::uint32_t uart = 2, port = 5, mask = 31;
}
namespace pad {
constexpr std::uint32_t hysteresis = 1u << 1, pull_up = 1u << 3, drive_4_mA = 1u << 4, input = 1u << 6;
}

/// GPIO 2, the Pico's pin 4: high for enabled. Out of reset the part itself pulls it down.
namespace drive_pin {
constexpr unsigned number = 2;
constexpr std::uint32_t on = 1u << number;

template <class Port>
void set(Port& port, bool enabled) {
  (enabled ? port.output_set : port.output_clear) = on;
}

/// Low first, then an output, then let through to the pin. The registers are arguments so that a host test can play
/// them.
template <class Resets, class Port, class Bank>
void start(Resets& resets, Port& port, Bank& bank) {
  set(port, false);
  port.drive_set = on;
  release(resets, block::io_bank0 | block::pads_bank0);
  bank.pin[number].control = function::port;
}

/// Whether the port drives the pin high.
template <class Port, class Bank>
bool level(Port& port, Bank& bank) {
  return (port.drive & port.output & on) != 0 && (bank.pin[number].control & function::mask) == function::port;
}
}  // namespace drive_pin

/// GPIO 0 sends and GPIO 1 receives; a pull-up lets an open line read idle. The port is released before its pins.
template <class Resets, class Bank, class Pads>
void connect_uart0(Resets& resets, Bank& bank, Pads& pads) {
  constexpr unsigned send = 0, receive = 1;
  release(resets, block::uart0);
  pads.pin[receive] = pad::input | pad::drive_4_mA | pad::pull_up | pad::hysteresis;
  bank.pin[send].control = function::uart;
  bank.pin[receive].control = function::uart;
}

}  // namespace axial::hal::rp2040
