#pragma once
/// STM32F100RB: Cortex-M3, 24 MHz, 128 KiB flash, 8 KiB SRAM. Wired as on an STM32VLDISCOVERY: 8 MHz crystal; USART1 on
/// PA9 (transmit) and PA10 (receive); the drives' pin is PA8, high for enabled, with a pull-down of 10 kOhm outside,
/// because it is an open input out of reset. Emulated by QEMU's `stm32vldiscovery`, without pins and watchdog.
/// Source: RM0041 (reset and clock control: chapter 6; GPIO: 7; USART: 23), datasheet DS5944.

#include <hal/cortex_m/board_base.hpp>
#include <hal/stm32/usart.hpp>
#include <hal/stm32/watchdog.hpp>

namespace axial::hal {

namespace stm32f100 {

using cortex_m::at;
using cortex_m::Register;

struct RccRegisters {
  Register control, configuration, interrupts, apb2_reset, apb1_reset, ahb_enable, apb2_enable, apb1_enable, backup,
      status;
};
static_assert(offsetof(RccRegisters, status) == 0x24);
struct GpioRegisters {
  Register configuration[2], input, output, set_reset, reset, lock;
};

inline RccRegisters& rcc() { return at<RccRegisters>(0x40021000); }
constexpr std::uintptr_t gpio_a_address = 0x40010800;
inline GpioRegisters& gpio_a() { return at<GpioRegisters>(gpio_a_address); }

namespace clock {
constexpr std::uint32_t crystal_Hz = 8'000'000, internal_Hz = 8'000'000;
constexpr std::uint32_t multiplier = 3, internal_multiplier = 6;
constexpr std::uint32_t core_Hz = crystal_Hz * multiplier;  // 8 MHz * 3 = 24 MHz; every bus runs at it
static_assert(core_Hz == 24'000'000, "the core runs at its maximum of 24 MHz");
static_assert(internal_Hz / 2 * internal_multiplier == core_Hz, "the PLL halves the internal oscillator first");

// RCC_CR, RCC_CFGR. The flash needs no wait state up to 24 MHz.
constexpr std::uint32_t internal_ready = 1u << 1, crystal_on = 1u << 16, crystal_ready = 1u << 17, pll_on = 1u << 24,
                        pll_ready = 1u << 25;
constexpr std::uint32_t from_crystal = 1u << 16 | (multiplier - 2) << 18, from_internal = (internal_multiplier - 2)
                                                                                          << 18;
constexpr std::uint32_t select_pll = 2u, running_pll = 2u << 2, running_mask = 3u << 2;

constexpr ClockReport by_crystal{ClockSource::crystal, core_Hz, core_Hz};
constexpr ClockReport by_internal_pll{ClockSource::internal, core_Hz, core_Hz};
constexpr ClockReport by_internal{ClockSource::internal, internal_Hz, internal_Hz};

/// Starts the PLL with `settings` and switches to it; false, and the PLL off again, when it is not ready in time.
template <class Rcc>
bool switch_to_pll(Rcc& rcc, std::uint32_t settings) {
  rcc.configuration = settings;
  rcc.control = rcc.control | pll_on;
  if (wait_until([&] { return (rcc.control & pll_ready) != 0; })) {
    rcc.configuration = settings | select_pll;
    if (wait_until([&] { return (rcc.configuration & running_mask) == running_pll; })) return true;
  }
  rcc.configuration = 0;
  rcc.control = rcc.control & ~pll_on;
  return false;
}

/// Crystal and PLL; else the internal oscillator and PLL; else the internal oscillator alone. Each wait is bounded. The
/// registers are an argument so that a host test can play a broken crystal.
template <class Rcc>
ClockReport start(Rcc& rcc, std::uint32_t emulator_Hz) {
  rcc.control = rcc.control | crystal_on;
  if (wait_until([&] { return (rcc.control & crystal_ready) != 0; }) && switch_to_pll(rcc, from_crystal))
    return by_crystal;
  rcc.control = rcc.control & ~crystal_on;
  if (switch_to_pll(rcc, from_internal)) return by_internal_pll;
  if ((rcc.control & internal_ready) != 0) return by_internal;
  return {ClockSource::emulator, emulator_Hz, emulator_Hz};
}
}  // namespace clock

/// PA8.
namespace drive_pin {
constexpr std::uint32_t on = 1u << 8, off = on << 16;  // GPIOA_BSRR

template <class Gpio>
void set(Gpio& pins, bool enabled) {
  pins.set_reset = enabled ? on : off;
}

/// Low first, then a push-pull output of 2 MHz. The registers are arguments so that a host test can play them.
template <class Rcc, class Gpio>
void start(Rcc& rcc, Gpio& pins) {
  rcc.apb2_enable = rcc.apb2_enable | 1u << 2;  // GPIOA
  set(pins, false);
  pins.configuration[1] = (pins.configuration[1] & ~0xFu) | 0x2u;
}

/// Whether the port drives the pin high.
template <class Gpio>
bool level(Gpio& pins) {
  return (pins.configuration[1] & 0xFu) == 2u && (pins.output & on) != 0;
}
}  // namespace drive_pin

struct WatchdogPort {
  static constexpr std::uint32_t clock_Hz = 40'000;  // 30 to 60 kHz (DS5944)
  static stm32::WatchdogRegisters& registers() { return at<stm32::WatchdogRegisters>(0x40003000); }
};

struct SerialPort {
  static stm32::UsartRegisters& registers() { return at<stm32::UsartRegisters>(0x40013800); }  // USART1
};

}  // namespace stm32f100

struct Stm32f100 : cortex_m::BoardBase<Stm32f100, 24'000'000> {
  static constexpr const char* name = "stm32f100";
  static constexpr std::uint32_t flash_bytes = 128 * 1024, ram_bytes = 8 * 1024;
  /// 24 MHz / 12, oversampled by 8: exact. Without the PLL 8 MHz / 8 = 1 Mbit/s is the most that remains.
  static constexpr std::uint32_t baud = 2'000'000;
  using Serial = stm32::Usart<stm32f100::SerialPort, 256>;
  using Watchdog = stm32::Watchdog<stm32f100::WatchdogPort>;
  struct DrivePin {
    static constexpr std::uintptr_t off_register =
        stm32f100::gpio_a_address + offsetof(stm32f100::GpioRegisters, set_reset);
    static constexpr std::uint32_t off_word = stm32f100::drive_pin::off;
    static void start() { stm32f100::drive_pin::start(stm32f100::rcc(), stm32f100::gpio_a()); }
    static void set(bool enabled) { stm32f100::drive_pin::set(stm32f100::gpio_a(), enabled); }
    static bool level() { return stm32f100::drive_pin::level(stm32f100::gpio_a()); }
  };

  static constexpr unsigned interrupt_lines = 61, serial_line = 37;
  static constexpr Interrupt interrupts[] = {{serial_line, Serial::interrupt}};

  static ResetCause take_reset_flags() { return stm32::take_reset_flags(stm32f100::rcc().status); }

  static ClockReport start_clock() { return stm32f100::clock::start(stm32f100::rcc(), emulator_Hz); }

  /// PA9: alternate push-pull, 50 MHz. PA10: input with pull-up, so that an open line reads idle.
  static void connect_pins() {
    auto& rcc = stm32f100::rcc();
    auto& pins = stm32f100::gpio_a();
    rcc.apb2_enable = rcc.apb2_enable | 1u << 2 | 1u << 14;  // GPIOA, USART1
    pins.set_reset = 1u << 10;
    pins.configuration[1] = (pins.configuration[1] & ~0xFF0u) | 0x8B0u;
  }
};

using Board = Stm32f100;

static_assert(stm32::usart_divider(stm32f100::clock::core_Hz, Stm32f100::baud).baud == Stm32f100::baud);

}  // namespace axial::hal
