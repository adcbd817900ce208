#pragma once
/// STM32F405RG: Cortex-M4F, 168 MHz, 1 MiB flash, 128 KiB SRAM (and 64 KiB CCM, unused). Wired as on a Netduino Plus 2:
/// 25 MHz crystal; USART1 on PA9 (transmit) and PA10 (receive); the drives' pin is PA8, high for enabled, with a
/// pull-down of 10 kOhm outside, because it is an open input out of reset. Emulated by QEMU's `netduinoplus2`, without
/// pins and watchdog. Source: RM0090 (reset and clock control: chapter 7; flash: 3; GPIO: 8), datasheet DS8626.

#include <hal/cortex_m/board_base.hpp>
#include <hal/stm32/usart.hpp>
#include <hal/stm32/watchdog.hpp>

namespace axial::hal {

namespace stm32f405 {

using cortex_m::at;
using cortex_m::Register;

struct RccRegisters {
  Register control, pll, configuration, interrupts;
  Register ahb_reset[3], reserved0, apb_reset[2], reserved1[2];
  Register ahb_enable[3], reserved2, apb1_enable, apb2_enable;
  Register reserved3[11];
  Register status;
};
static_assert(offsetof(RccRegisters, apb2_enable) == 0x44 && offsetof(RccRegisters, status) == 0x74);
struct FlashRegisters {
  Register access_control;
};
struct GpioRegisters {
  Register mode, output_type, speed, pull, input, output, set_reset, lock, alternate[2];
};

inline RccRegisters& rcc() { return at<RccRegisters>(0x40023800); }
inline FlashRegisters& flash() { return at<FlashRegisters>(0x40023C00); }
constexpr std::uintptr_t gpio_a_address = 0x40020000;
inline GpioRegisters& gpio_a() { return at<GpioRegisters>(gpio_a_address); }

namespace clock {
constexpr std::uint32_t crystal_Hz = 25'000'000, internal_Hz = 16'000'000;
constexpr std::uint32_t m = 25, n = 336, p = 2, q = 7;
constexpr std::uint32_t input_Hz = crystal_Hz / m;  // 25 MHz / 25 = 1 MHz
constexpr std::uint32_t vco_Hz = input_Hz * n;      // 1 MHz * 336 = 336 MHz
constexpr std::uint32_t core_Hz = vco_Hz / p;       // 336 MHz / 2 = 168 MHz
constexpr std::uint32_t apb2_Hz = core_Hz / 2;      // 84 MHz, feeds USART1
static_assert(input_Hz >= 1'000'000 && input_Hz <= 2'000'000, "PLL input: 1 to 2 MHz (RM0090 7.3.2)");
static_assert(vco_Hz >= 100'000'000 && vco_Hz <= 432'000'000, "VCO: 100 to 432 MHz (RM0090 7.3.2)");
static_assert(core_Hz == 168'000'000, "the core runs at its maximum of 168 MHz");
static_assert(vco_Hz / q == 48'000'000, "USB and the like need 48 MHz");

// RCC_CR, RCC_PLLCFGR, RCC_CFGR
constexpr std::uint32_t internal_ready = 1u << 1, crystal_on = 1u << 16, crystal_ready = 1u << 17, pll_on = 1u << 24,
                        pll_ready = 1u << 25;
constexpr std::uint32_t pll_settings = m | n << 6 | (p / 2 - 1) << 16 | 1u << 22 /* from the crystal */ | q << 24;
constexpr std::uint32_t apb1_by_4 = 5u << 10, apb2_by_2 = 4u << 13, select_pll = 2u, running_pll = 2u << 2,
                        running_mask = 3u << 2;
// FLASH_ACR: five wait states above 150 MHz at 3.3 V (RM0090 table 10); prefetch and both caches
constexpr std::uint32_t flash_settings = 5u | 7u << 8;

constexpr ClockReport by_crystal{ClockSource::crystal, core_Hz, apb2_Hz};
constexpr ClockReport by_internal{ClockSource::internal, internal_Hz, internal_Hz};

/// Crystal, PLL, switch-over; each wait is bounded. Whatever does not become ready, the internal oscillator that runs
/// since reset stays in charge. The registers are arguments so that a host test can play a broken crystal.
template <class Rcc, class Flash>
ClockReport start(Rcc& rcc, Flash& flash, std::uint32_t emulator_Hz) {
  const auto fall_back = [&]() -> ClockReport {
    rcc.configuration = 0;
    rcc.control = rcc.control & ~(crystal_on | pll_on);
    if ((rcc.control & internal_ready) != 0) return by_internal;
    return {ClockSource::emulator, emulator_Hz, emulator_Hz / 2};
  };
  rcc.control = rcc.control | crystal_on;
  if (!wait_until([&] { return (rcc.control & crystal_ready) != 0; })) return fall_back();
  rcc.pll = pll_settings;
  rcc.control = rcc.control | pll_on;
  if (!wait_until([&] { return (rcc.control & pll_ready) != 0; })) return fall_back();
  flash.access_control = flash_settings;
  rcc.configuration = apb1_by_4 | apb2_by_2 | select_pll;
  if (!wait_until([&] { return (rcc.configuration & running_mask) == running_pll; })) return fall_back();
  return by_crystal;
}
}  // namespace clock

/// PA8.
namespace drive_pin {
constexpr std::uint32_t on = 1u << 8, off = on << 16;  // GPIO_BSRR

template <class Gpio>
void set(Gpio& pins, bool enabled) {
  pins.set_reset = enabled ? on : off;
}

/// Low first, then an output. The registers are arguments so that a host test can play them.
template <class Rcc, class Gpio>
void start(Rcc& rcc, Gpio& pins) {
  rcc.ahb_enable[0] = rcc.ahb_enable[0] | 1u << 0;  // GPIOA
  set(pins, false);
  pins.mode = (pins.mode & ~(3u << 16)) | 1u << 16;
}

/// Whether the port drives the pin high.
template <class Gpio>
bool level(Gpio& pins) {
  return (pins.mode >> 16 & 3u) == 1u && (pins.output & on) != 0;
}
}  // namespace drive_pin

struct WatchdogPort {
  static constexpr std::uint32_t clock_Hz = 32'000;  // 17 to 47 kHz (DS8626)
  static stm32::WatchdogRegisters& registers() { return at<stm32::WatchdogRegisters>(0x40003000); }
};

struct SerialPort {
  static stm32::UsartRegisters& registers() { return at<stm32::UsartRegisters>(0x40011000); }  // USART1
};

}  // namespace stm32f405

struct Stm32f405 : cortex_m::BoardBase<Stm32f405, 168'000'000> {
  static constexpr const char* name = "stm32f405";
  static constexpr std::uint32_t flash_bytes = 1024 * 1024, ram_bytes = 128 * 1024;
  /// 84 MHz / 42; from the internal oscillator 16 MHz / 8. Both exact.
  static constexpr std::uint32_t baud = 2'000'000;
  using Serial = stm32::Usart<stm32f405::SerialPort, 1024>;
  using Watchdog = stm32::Watchdog<stm32f405::WatchdogPort>;
  struct DrivePin {
    static constexpr std::uintptr_t off_register =
        stm32f405::gpio_a_address + offsetof(stm32f405::GpioRegisters, set_reset);
    static constexpr std::uint32_t off_word = stm32f405::drive_pin::off;
    static void start() { stm32f405::drive_pin::start(stm32f405::rcc(), stm32f405::gpio_a()); }
    static void set(bool enabled) { stm32f405::drive_pin::set(stm32f405::gpio_a(), enabled); }
    static bool level() { return stm32f405::drive_pin::level(stm32f405::gpio_a()); }
  };

  static constexpr unsigned interrupt_lines = 82, serial_line = 37;
  static constexpr Interrupt interrupts[] = {{serial_line, Serial::interrupt}};

  static ResetCause take_reset_flags() { return stm32::take_reset_flags(stm32f405::rcc().status); }

  static ClockReport start_clock() {
    return stm32f405::clock::start(stm32f405::rcc(), stm32f405::flash(), emulator_Hz);
  }

  /// PA9 and PA10 to alternate function 7, fast, pull-up on the receiver so that an open line reads idle.
  static void connect_pins() {
    auto& rcc = stm32f405::rcc();
    auto& pins = stm32f405::gpio_a();
    rcc.ahb_enable[0] = rcc.ahb_enable[0] | 1u << 0;  // GPIOA
    rcc.apb2_enable = rcc.apb2_enable | 1u << 4;      // USART1
    pins.alternate[1] = (pins.alternate[1] & ~0xFF0u) | 0x770u;
    pins.speed = (pins.speed & ~(0xFu << 18)) | 0xAu << 18;
    pins.pull = (pins.pull & ~(0xFu << 18)) | 1u << 20;
    pins.mode = (pins.mode & ~(0xFu << 18)) | 0xAu << 18;
  }
};

using Board = Stm32f405;

static_assert(stm32::usart_divider(stm32f405::clock::apb2_Hz, Stm32f405::baud).baud == Stm32f405::baud);
static_assert(stm32::usart_divider(stm32f405::clock::internal_Hz, Stm32f405::baud).baud == Stm32f405::baud);

}  // namespace axial::hal
