#include <hal/boards/rp2350_riscv/board.hpp>
#include <hal/rp2350/boot_block.hpp>

#include "boards/played_clock.hpp"
#include "boards/played_rp.hpp"
#include "boards/stores.hpp"

namespace axial::hal {
namespace {

constexpr std::uint32_t everything = 0x1FFFFFFF, crystal_on = rp_crystal_on;

struct PlayedTick {
  Noted control, cycles;
};
struct PlayedChip : PlayedClocks<everything> {
  struct {
    PlayedTick watchdog{{"watch"}, {"watch cycles"}}, riscv{{"timer"}, {"timer cycles"}};
  } ticks;
};

/// RP2350 Datasheet, 8.6.3 (the order of the PLL), 7.5 (PLL_SYS is block 14), 8.5 (length before start).
TEST(Rp2350Clock, StartsInTheOrderOfTheManual) {
  PlayedChip chip;
  const auto stores = stores_of(
      [&] { expect_clock(rp2040::clock::start<rp2350::Plan>(chip), ClockSource::crystal, 150'000'000, 150'000'000); });
  const std::vector<Store> expected{{"system", 0},
                                    {"crystal", 0xAA0},
                                    {"start up", 47},
                                    {"crystal", crystal_on},
                                    {"reference", 2},
                                    {"reset", everything & ~(1u << 14)},
                                    {"pll", 1},
                                    {"feedback", 125},
                                    {"power", 0xC},
                                    {"post dividers", 0x52000},
                                    {"power", 0x4},
                                    {"system", 1},
                                    {"peripheral", 1u << 11},
                                    {"watch cycles", 12},
                                    {"watch", 1},
                                    {"timer cycles", 12},
                                    {"timer", 1}};
  EXPECT_EQ(stores, expected);
}

struct PlayedPads {
  Noted pin[3]{{"pad 0"}, {"pad 1"}, {"pad 2"}};
};
constexpr std::uint32_t gpio_2 = 1u << 2;

/// An isolated pad keeps its last level: it is let go last. Blocks 6 and 9 of 7.5; pad: 4 mA, hysteresis, pull-down.
TEST(Rp2350DrivePin, IsLowBeforeItDrivesAndConnectedBeforeItsPadIsLetGo) {
  PlayedResets<everything> resets;
  PlayedPort port;
  PlayedBank bank;
  PlayedPads pads;
  const auto stores = stores_of([&] { rp2350::drive_pin::start(resets, port, bank, pads); });
  const std::vector<Store> expected{{"clear", gpio_2},
                                    {"drive", gpio_2},
                                    {"reset", everything & ~(1u << 6 | 1u << 9)},
                                    {"pin 2", 5},
                                    {"pad 2", 0x16}};
  EXPECT_EQ(stores, expected);
}

/// RP2350 Datasheet, 3.1.11: SIO at 0xD000 0000, GPIO_OUT_CLR at 0x20.
TEST(Rp2350DrivePin, AFaultDisablesByOneStore) {
  EXPECT_EQ(Rp2350Riscv::DrivePin::off_register, 0xD0000020u);
  EXPECT_EQ(Rp2350Riscv::DrivePin::off_word, gpio_2);
}

TEST(Rp2350Pins, TheSerialPortIsReleasedAndConnectedBeforeItsPadsAreLetGo) {
  PlayedResets<everything> resets;
  PlayedBank bank;
  PlayedPads pads;
  const auto stores = stores_of([&] { rp2350::connect_uart0(resets, bank, pads); });
  const std::vector<Store> expected{
      {"reset", everything & ~(1u << 26)}, {"pin 0", 2}, {"pin 1", 2}, {"pad 0", 0x12}, {"pad 1", 0x5A}};
  EXPECT_EQ(stores, expected);
}

struct PlayedDog {
  Noted control{"control"}, load{"load"};
};
struct PlayedPower {
  Noted watchdog_select{"select"};
};
struct DogPort {
  inline static PlayedDog dog{};
  inline static PlayedPower machine{};
  static PlayedDog& registers() { return dog; }
  static PlayedPower& power() { return machine; }
};

/// RP2350 Datasheet, 7.3: bits 2 and 3 are the oscillators; 12.9: one count a microsecond.
TEST(Rp2350Watchdog, StartsWithItsTimeAndResetsAllButTheOscillators) {
  EXPECT_EQ(stores_of([] { rp2350::Watchdog<DogPort>::start(100); }),
            (std::vector<Store>{{"select", 0x1FFFFF3}, {"load", 100'000}, {"control", 1u << 30}}));
}

/// RP2350 Datasheet, 5.9.5: the smallest block of a RISC-V image, with the item of its entry.
TEST(Rp2350BootBlock, SaysExecutableForRiscVAndWhereItBegins) {
  EXPECT_EQ(rp2350::boot_block(0x10000020, 0x20082000),
            (rp2350::BootBlock{0xFFFFDED3, 0x11010142, 0x344, 0x10000020, 0x20082000, 0x4FF, 0, 0xAB123579}));
}

/// The controller with lines that wait; a handler withdraws its own.
struct PlayedLines {
  inline static std::vector<std::uint32_t> windows, waiting;
  static bool present() { return true; }
  static void set_enables(std::uint32_t window) { windows.push_back(window); }
  static void enable_all() {}
  static std::uint32_t next() { return waiting.empty() ? rp_top_bit : waiting.front() << 2; }
};
void withdraw() { PlayedLines::waiting.erase(PlayedLines::waiting.begin()); }
using Lines = riscv::Hazard3Interrupts<PlayedLines>;

TEST(Hazard3Interrupts, ALineIsABitOfAWindowOfSixteen) {
  Lines::enable(33);
  EXPECT_EQ(PlayedLines::windows.back(), 1u << 17 | 2u);
}

TEST(Hazard3Interrupts, EveryLineThatWaitsIsServedAndAnUnknownOneRefused) {
  constexpr Interrupt known[] = {{33, withdraw}, {5, withdraw}};
  PlayedLines::waiting = {33, 5, 33};
  EXPECT_TRUE(Lines::serve(known));
  EXPECT_TRUE(PlayedLines::waiting.empty());
  PlayedLines::waiting = {33, 6};
  EXPECT_FALSE(Lines::serve(known));
}

}  // namespace
}  // namespace axial::hal
