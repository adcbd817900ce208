#pragma once
/// RP2040 on a Raspberry Pi Pico: two Cortex-M0+ at 125 MHz, 2 MiB of flash read through a cache, 264 KiB of SRAM,
/// 12 MHz crystal; UART0 on GPIO 0 (sends) and GPIO 1 (receives); the drives' pin is GPIO 2, high for enabled, pulled
/// down by the part out of reset and by 10 kOhm outside. The second core is left where the boot ROM has it,
/// asleep, does jobs beside the first (Worker), or with AXIAL_SECOND_CORE runs the program.
/// hal/boards has it with code in flash and in RAM. Emulated by rp2040js. Source: RP2040 Datasheet (clocks: 2.15;
/// GPIO: 2.19; UART: 4.2; timer: 4.6; watchdog: 4.7).

#include <hal/cortex_m/board_base.hpp>
#include <hal/cortex_m/cycle_counter.hpp>
#include <hal/pl011/uart.hpp>
#include <hal/rp2040/boot2.hpp>
#include <hal/rp2040/clock.hpp>
#include <hal/rp2040/pins.hpp>
#include <hal/rp2040/second_core.hpp>
#include <hal/rp2040/timer_tick.hpp>
#include <hal/rp2040/watchdog.hpp>
#include <hal/rp2040/worker.hpp>

namespace axial::hal {

namespace rp2040 {

using cortex_m::at;

inline ResetRegisters& resets() { return at<ResetRegisters>(0x4000C000); }
inline BankRegisters& bank() { return at<BankRegisters>(0x40014000); }
inline PadRegisters& pads() { return at<PadRegisters>(0x4001C000); }
constexpr std::uintptr_t port_address = 0xD0000000;
inline PortRegisters& port() { return at<PortRegisters>(port_address); }

/// SYSINFO_PLATFORM: what the image runs on.
inline Register& platform() { return at<Register>(0x40000004); }
constexpr std::uint32_t silicon = 1u << 1;

struct WatchdogPort {
  static WatchdogRegisters& registers() { return at<WatchdogRegisters>(0x40058000); }
  static PowerRegisters& power() { return at<PowerRegisters>(0x40010000); }
};
struct Uart0 {
  static pl011::UartRegisters& registers() { return at<pl011::UartRegisters>(0x40034000); }
};
struct Timer {
  static constexpr unsigned line = 0;
  static TimerRegisters& registers() { return at<TimerRegisters>(0x40054000); }
  static void enable_line() { cortex_m::enable_interrupt(line); }
};

inline MailboxRegisters& mailbox() { return at<MailboxRegisters>(port_address + mailbox_offset); }

#ifdef AXIAL_SECOND_CORE
constexpr bool program_on_second_core = true;
#else
constexpr bool program_on_second_core = false;
#endif

#ifdef __arm__
/// This core and the second.
struct Between {
  static MailboxRegisters& mailbox() { return rp2040::mailbox(); }
  static void signal() { asm volatile("dsb\n\tsev" ::: "memory"); }
  static void wait() { asm volatile("wfe" ::: "memory"); }
  static void fence() { asm volatile("dsb" ::: "memory"); }
  static constexpr std::uint32_t vectors = vectors_address;
  static constexpr bool other_is_free = !program_on_second_core;
};
#endif

/// What clock::start asks for.
struct Chip {
  CrystalRegisters& crystal = at<CrystalRegisters>(0x40024000);
  PllRegisters& pll = at<PllRegisters>(0x40028000);
  ClockRegisters& clocks = at<ClockRegisters>(0x40008000);
  ResetRegisters& resets = rp2040::resets();
  volatile std::uint32_t& tick = WatchdogPort::registers().tick;
};

}  // namespace rp2040

/// What the boards of a Pico share, wherever their code runs.
struct RaspberryPiPico
    : cortex_m::BoardBase<RaspberryPiPico, rp2040::clock::core_Hz,
                          cortex_m::CycleCounter<rp2040::clock::core_Hz, cortex_m::KnownCyclesM0Plus>> {
  static constexpr std::uint32_t flash_bytes = 2048 * 1024, ram_bytes = 264 * 1024;
  /// 125 MHz / (16 * 3.90625); from the crystal alone 750 kbit/s, from the ring some 400 kbit/s. At 1 Mbit/s request
  /// and answer of six joints would take longer than 1 ms.
  static constexpr std::uint32_t baud = 2'000'000;
  using Serial = pl011::Uart<rp2040::Uart0, 1024>;
  using Tick = rp2040::TimerTick<rp2040::Timer>;
  using Watchdog = rp2040::Watchdog<rp2040::WatchdogPort>;
  using EmulatedWatchdog = cortex_m::NoEmulatedWatchdog;
#ifdef __arm__
  using Worker = rp2040::SecondCoreWorker<rp2040::Between>;
#endif
  struct DrivePin {
    static constexpr std::uintptr_t off_register = rp2040::port_address + offsetof(rp2040::PortRegisters, output_clear);
    static constexpr std::uint32_t off_word = rp2040::drive_pin::on;
    static void start() { rp2040::drive_pin::start(rp2040::resets(), rp2040::port(), rp2040::bank()); }
    static void set(bool enabled) { rp2040::drive_pin::set(rp2040::port(), enabled); }
    static bool level() { return rp2040::drive_pin::level(rp2040::port(), rp2040::bank()); }
  };

  static constexpr unsigned interrupt_lines = 26, serial_line = 20;
  static constexpr Interrupt interrupts[] = {{serial_line, Serial::interrupt}, {rp2040::Timer::line, Tick::interrupt}};
  /// SysTick counts, and never interrupts.
  static void sys_tick_interrupt() {}

  static constexpr ClockSource emulated_clock = ClockSource::crystal;
  static constexpr CounterKind emulated_counter = CounterKind::cycles;
  static bool emulated() { return AXIAL_SEMIHOSTING != 0 && emulated_; }

  static ResetCause take_reset_flags() { return rp2040::reset_cause(rp2040::WatchdogPort::registers().reason); }

  static ClockReport start_clock() {
    rp2040::release(rp2040::resets(), rp2040::block::sysinfo | rp2040::block::timer);
    emulated_ = (rp2040::platform() & rp2040::silicon) == 0;
    return rp2040::clock::start(rp2040::Chip{});
  }
#ifdef __arm__
  /// The program on this core, or on the other one: below this core's part of the stack, with interrupts and SysTick of
  /// that core's own. This one sleeps for good then; where the other does not answer it runs the program itself.
  template <class Program>
  static void run(Program program) {
    if constexpr (rp2040::program_on_second_core) {
      constexpr std::uintptr_t own_bytes = 128;
      const auto stack =
          (reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0)) - own_bytes) & ~std::uintptr_t{7};
      void (*const entry)() = program;
      const rp2040::Launch launch{rp2040::vectors_address, stack, reinterpret_cast<std::uintptr_t>(entry)};
      if (rp2040::launch(rp2040::mailbox(), launch, [] { asm volatile("dsb\n\tsev" ::: "memory"); })) sleep_for_good();
    }
    program();
  }
#endif
  static void connect_pins() { rp2040::connect_uart0(rp2040::resets(), rp2040::bank(), rp2040::pads()); }

  /// Restarts by the watchdog, which resets all but the oscillators; a request of the core resets the cores alone.
  [[noreturn]] static void restart() {
    Watchdog::trigger();
    for (;;)
      asm volatile("" ::: "memory");
  }

 private:
#ifdef __arm__
  [[noreturn]] static void sleep_for_good() {
    asm volatile("cpsid i" ::: "memory");
    for (;;)
      asm volatile("wfi");
  }
#endif
  inline static bool emulated_ = false;
};

static_assert(pl011::uart_rate(rp2040::clock::core_Hz, RaspberryPiPico::baud).baud == RaspberryPiPico::baud);

}  // namespace axial::hal
