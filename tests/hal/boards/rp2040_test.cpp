#include <hal/boards/rp2040/board.hpp>

#include <deque>
#include <string>

#include "played_clock.hpp"
#include "played_rp.hpp"
#include "stores.hpp"

namespace axial::hal {
namespace {

constexpr std::uint32_t everything = 0x1FFFFFF, crystal_on = rp_crystal_on;

struct PlayedChip : PlayedClocks<everything> {
  Noted tick{"tick"};
};

ClockReport start(PlayedChip& chip) { return rp2040::clock::start(chip); }

/// RP2040 Datasheet, 2.16.3 (delay of the crystal), 2.18.3 (the order of the PLL), 2.15.3.2 (the multiplexers).
TEST(Rp2040Clock, StartsInTheOrderOfTheManual) {
  PlayedChip chip;
  const auto stores = stores_of([&] { expect_clock(start(chip), ClockSource::crystal, 125'000'000, 125'000'000); });
  const std::vector<Store> expected{{"system", 0},
                                    {"crystal", 0xAA0},
                                    {"start up", 47},
                                    {"crystal", crystal_on},
                                    {"reference", 2},
                                    {"reset", everything & ~(1u << 12)},
                                    {"pll", 1},
                                    {"feedback", 125},
                                    {"power", 0xC},
                                    {"post dividers", 0x62000},
                                    {"power", 0x4},
                                    {"system", 1},
                                    {"peripheral", 1u << 11},
                                    {"tick", 1u << 9 | 12}};
  EXPECT_EQ(stores, expected);
}

TEST(Rp2040Clock, WithoutThePllTheCrystalRunsTheCore) {
  PlayedChip chip;
  chip.pll_works = false;
  expect_clock(start(chip), ClockSource::crystal_alone, 12'000'000, 12'000'000);
  EXPECT_EQ(chip.clocks.system.control.written, 0u);
  EXPECT_EQ(chip.tick.written, 1u << 9 | 12);
}

TEST(Rp2040Clock, AMultiplexerThatDoesNotSwitchGoesBack) {
  PlayedChip chip;
  chip.clocks.system.works = false;
  expect_clock(start(chip), ClockSource::crystal_alone, 12'000'000, 12'000'000);
  EXPECT_EQ(chip.clocks.system.control.written, 0u);
}

TEST(Rp2040Clock, WithoutTheCrystalTheRingRunsTheCore) {
  PlayedChip broken, stuck;
  broken.crystal_works = false;
  expect_clock(start(broken), ClockSource::internal, 6'500'000, 6'500'000);
  EXPECT_EQ(broken.clocks.reference.control.written, 0u) << "nobody waits for a crystal that stands still";
  EXPECT_EQ(broken.tick.written, 1u << 9 | 7) << "no tick is shorter than 1 us";
  stuck.clocks.reference.works = false;
  expect_clock(start(stuck), ClockSource::internal, 6'500'000, 6'500'000);
}

/// Every wait has an end: a block that stays in reset does not stop the start.
TEST(Rp2040Resets, AreReleasedOneByOneAndNotWaitedForForever) {
  PlayedResets<everything> resets;
  rp2040::release(resets, rp2040::block::uart0);
  EXPECT_EQ(resets.reset.written, everything & ~(1u << 22));
  rp2040::release(resets, rp2040::block::timer);
  EXPECT_EQ(resets.reset.written, everything & ~(1u << 22 | 1u << 21));
  resets.works = false;
  rp2040::release(resets, rp2040::block::sysinfo);
}

struct PlayedPads {
  Noted pin[2]{{"pad 0"}, {"pad 1"}};
};
constexpr std::uint32_t gpio_2 = 1u << 2;

/// The bank may be used when it is out of reset, not before.
TEST(Rp2040DrivePin, IsLowBeforeItDrivesAndDrivesBeforeItIsConnected) {
  PlayedResets<everything> resets;
  PlayedPort port;
  PlayedBank bank;
  const auto stores = stores_of([&] { rp2040::drive_pin::start(resets, port, bank); });
  const std::vector<Store> expected{
      {"clear", gpio_2}, {"drive", gpio_2}, {"reset", everything & ~(1u << 5 | 1u << 8)}, {"pin 2", 5}};
  EXPECT_EQ(stores, expected);
}

TEST(Rp2040DrivePin, HighEnables) {
  PlayedPort port;
  EXPECT_EQ(stores_of([&] { rp2040::drive_pin::set(port, true); }), (std::vector<Store>{{"set", gpio_2}}));
  EXPECT_EQ(stores_of([&] { rp2040::drive_pin::set(port, false); }), (std::vector<Store>{{"clear", gpio_2}}));
}

TEST(Rp2040DrivePin, IsHighWhereThePortDrivesItAndIsConnected) {
  struct Port {
    std::uint32_t drive, output;
  } high{gpio_2, gpio_2}, open{0, gpio_2}, low{gpio_2, 0};
  PlayedBank bank;
  bank.pin[2].control = 5;
  EXPECT_TRUE(rp2040::drive_pin::level(high, bank));
  EXPECT_FALSE(rp2040::drive_pin::level(open, bank));
  EXPECT_FALSE(rp2040::drive_pin::level(low, bank));
  bank.pin[2].control = 31;
  EXPECT_FALSE(rp2040::drive_pin::level(high, bank));
}

/// RP2040 Datasheet, 2.3.1.7: SIO at 0xD000 0000, GPIO_OUT_CLR at 0x18.
TEST(Rp2040DrivePin, AFaultDisablesByOneStore) {
  EXPECT_EQ(RaspberryPiPico::DrivePin::off_register, 0xD0000018u);
  EXPECT_EQ(RaspberryPiPico::DrivePin::off_word, gpio_2);
}

/// The second core's boot ROM: every word comes back, `wrong` ones as another. `taken` words, of which 0, 0, 1 begin.
struct PlayedMailbox {
  int wrong = 0;
  bool silent = false;
  std::vector<std::uint32_t> told, answers{7, 8};  // what was left there
  Noted status{"status", 0, [this](std::uint32_t) { return 2u | (answers.empty() ? 0u : 1u); }};
  struct {
    PlayedMailbox* box;
    void operator=(std::uint32_t word) { box->tell(word); }
  } write{this};
  Noted read{"read", 0, [this](std::uint32_t) {
               const std::uint32_t first = answers.front();
               answers.erase(answers.begin());
               return first;
             }};

  void tell(std::uint32_t word) {
    told.push_back(word);
    if (silent) return;
    answers.push_back(word + (word > 1 && wrong > 0 ? 1 : 0));
    if (word > 1) --wrong;
  }
};
using Words = std::vector<std::uint32_t>;
constexpr rp2040::Launch launched{0x10000100, 0x20008000, 0x10000401};
const Words sequence{0, 0, 1, 0x10000100, 0x20008000, 0x10000401};

bool launch(PlayedMailbox& mailbox) {
  return rp2040::launch(mailbox, launched, [] {});
}

/// Datasheet 2.8.2: what stands in the mailbox is thrown away, each word is answered.
TEST(Rp2040SecondCore, IsLaunchedBySixWords) {
  PlayedMailbox mailbox;
  EXPECT_TRUE(launch(mailbox));
  EXPECT_EQ(mailbox.told, sequence);
  EXPECT_TRUE(mailbox.answers.empty());
}

TEST(Rp2040SecondCore, IsAskedAnewAfterAWrongAnswer) {
  PlayedMailbox mailbox;
  mailbox.wrong = 1;
  Words told{0, 0, 1, 0x10000100};
  told.insert(told.end(), sequence.begin(), sequence.end());
  EXPECT_TRUE(launch(mailbox));
  EXPECT_EQ(mailbox.told, told);
}

/// Two cores' mailboxes, eight words each, and who does what between them.
struct Cores {
  inline static std::deque<std::uint32_t> boxes[2];
  inline static Words done;  // by the second core
  inline static std::string order;
};
template <int own>
struct End {
  struct Box {
    struct {
      operator std::uint32_t() const {
        return (Cores::boxes[1 - own].size() < 8 ? 2U : 0U) | (Cores::boxes[own].empty() ? 0U : 1U);
      }
    } status;
    struct {
      void operator=(std::uint32_t word) const {
        Cores::order += own == 0 ? "w" : "d";
        Cores::boxes[1 - own].push_back(word);
      }
    } write;
    struct {
      operator std::uint32_t() const {
        const std::uint32_t word = Cores::boxes[own].front();
        Cores::boxes[own].pop_front();
        return word;
      }
    } read;
  };
  static Box mailbox() { return {}; }
  static void signal() { Cores::order += "s"; }
  static void wait() { FAIL() << "there is a job"; }
  static void fence() { Cores::order += "f"; }
};

TEST(Rp2040Jobs, AreDoneByTheOtherCoreAndWaitedFor) {
  Cores::order.clear();
  rp2040::Jobs<End<0>>::post(0x10000401, 0x20000100);
  EXPECT_EQ(Cores::order, "fwws") << "what is stored comes before, and the other is woken";
  rp2040::Jobs<End<1>>::serve([](std::uint32_t what, std::uint32_t with) {
    Cores::order += "j";
    Cores::done = {what, with};
  });
  EXPECT_EQ(Cores::order, "fwwsfjfd") << "what the job stores comes before its end is told";
  EXPECT_EQ(Cores::done, (Words{0x10000401, 0x20000100}));
  rp2040::Jobs<End<0>>::join();
  EXPECT_EQ(Cores::order, "fwwsfjfdf");
  EXPECT_TRUE(Cores::boxes[0].empty() && Cores::boxes[1].empty());
}

TEST(Rp2040SecondCore, IsNotWaitedForForever) {
  PlayedMailbox silent, wrong;
  silent.silent = true;
  wrong.wrong = 1000;
  EXPECT_FALSE(launch(silent));
  EXPECT_FALSE(launch(wrong));
  EXPECT_EQ(wrong.told.size(), 16u) << "four attempts";
}

/// Datasheet 2.3.1.7: FIFO_ST, FIFO_WR, FIFO_RD at 0x50, 0x54, 0x58.
TEST(Rp2040SecondCore, MailboxesAreWhereTheManualHasThem) {
  EXPECT_EQ(rp2040::mailbox_offset, 0x50u);
  EXPECT_EQ(offsetof(rp2040::MailboxRegisters, write), 4u);
  EXPECT_EQ(offsetof(rp2040::MailboxRegisters, read), 8u);
}

/// Datasheet 2.19.6.3: input, 4 mA, pull-up, hysteresis; function 2 of pins 0 and 1.
TEST(Rp2040Pins, TheSerialPortIsReleasedBeforeItIsConnected) {
  PlayedResets<everything> resets;
  PlayedBank bank;
  PlayedPads pads;
  const auto stores = stores_of([&] { rp2040::connect_uart0(resets, bank, pads); });
  const std::vector<Store> expected{{"reset", everything & ~(1u << 22)}, {"pad 1", 0x5A}, {"pin 0", 2}, {"pin 1", 2}};
  EXPECT_EQ(stores, expected);
}

}  // namespace
}  // namespace axial::hal
