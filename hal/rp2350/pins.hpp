#pragma once
/// Pins of the RP2350: bank 0, its pads, which are isolated until they are let go, and the processors' own port (SIO).
/// Source: RP2350 Datasheet, 3.1 (SIO), 9 (GPIO; isolation: 9.7).

#include <cstddef>
#include <cstdint>

#include <hal/rp2040/pins.hpp>
#include <hal/rp2350/clock.hpp>

namespace axial::hal::rp2350 {

struct BankRegisters {
  struct {
    Register status, control;
  } pin[48];
};
struct PadRegisters {
  Register voltage, pin[48];
};
/// Of pins 0 to 31; the words between them are of the others.
struct PortRegisters {
  Register processor, input, input_high, reserved;
  Register output, output_high, output_set, output_set_high, output_clear, output_clear_high, toggle, toggle_high;
  Register drive, drive_high, drive_set;
};
static_assert(offsetof(PortRegisters, output_clear) == 0x20 && offsetof(PortRegisters, drive_set) == 0x38);

namespace function = rp2040::function;
/// Words of a pad without `isolated` (bit 8), which it has out of reset: they let the pin follow.
namespace pad {
using namespace rp2040::pad;
constexpr std::uint32_t pull_down = 1u << 2;
}  // namespace pad

/// GPIO 2, the Pico 2's pin 4: high for enabled.
namespace drive_pin {
using rp2040::drive_pin::level;
using rp2040::drive_pin::number;
using rp2040::drive_pin::on;
using rp2040::drive_pin::set;

/// Low first, then an output, then let through to the pad, then the pad to the pin. The registers are arguments so that
/// a host test can play them.
template <class Resets, class Port, class Bank, class Pads>
void start(Resets& resets, Port& port, Bank& bank, Pads& pads) {
  set(port, false);
  port.drive_set = on;
  release(resets, block::io_bank0 | block::pads_bank0);
  bank.pin[number].control = function::port;
  pads.pin[number] = pad::drive_4_mA | pad::pull_down | pad::hysteresis;
}
}  // namespace drive_pin

/// GPIO 0 sends and GPIO 1 receives; a pull-up lets an open line read idle. The port is released before its pins.
template <class Resets, class Bank, class Pads>
void connect_uart0(Resets& resets, Bank& bank, Pads& pads) {
  constexpr unsigned send = 0, receive = 1;
  release(resets, block::uart0);
  bank.pin[send].control = function::uart;
  bank.pin[receive].control = function::uart;
  pads.pin[send] = pad::drive_4_mA | pad::hysteresis;
  pads.pin[receive] = pad::input | pad::drive_4_mA | pad::pull_up | pad::hysteresis;
}

}  // namespace axial::hal::rp2350
