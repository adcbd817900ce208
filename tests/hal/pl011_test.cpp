#include <hal/pl011/uart.hpp>

#include <deque>

#include <gtest/gtest.h>

#include "boards/stores.hpp"

namespace axial::hal::pl011 {
namespace {

/// A port whose receiver has what `waiting` has, each with its flags.
struct Played {
  struct Data {
    std::deque<std::uint32_t> waiting;
    std::uint32_t written = 0;
    void operator=(std::uint32_t value) { written = value; }
    operator std::uint32_t() {
      const std::uint32_t next = waiting.front();
      waiting.pop_front();
      return next;
    }
  } data;
  struct {
    const Data* data;
    bool stuck = false;
    operator std::uint32_t() const { return (data->waiting.empty() ? 1u << 4 : 0u) | (stuck ? 1u << 5 : 0u); }
  } flags{&data};
  Noted whole_divider{"whole"}, fraction_divider{"fraction"}, line{"line"}, control{"control"},
      interrupt_mask{"interrupts"};
};

template <int>
struct FakePort {
  static Played& registers() {
    static Played port{};
    return port;
  }
};

/// Arm DDI 0183, 3.3.6: clock / (16 * baud), in 64ths. RP2040 Datasheet, 4.2.7.1: 115 200 from 125 MHz is 67 and 52/64.
TEST(Pl011, TheDividerIsNearestAndBounded) {
  EXPECT_EQ(uart_rate(125'000'000, 1'000'000).divider, 7u * 64 + 52);
  EXPECT_EQ(uart_rate(125'000'000, 2'000'000).divider, 3u * 64 + 58);
  EXPECT_EQ(uart_rate(125'000'000, 2'000'000).baud, 2'000'000u);
  EXPECT_EQ(uart_rate(125'000'000, 115'200).divider, 67u * 64 + 52);
  EXPECT_EQ(uart_rate(12'000'000, 1'000'000).baud, 750'000u) << "a sixteenth of the clock is the most";
  EXPECT_EQ(uart_rate(6'500'000, 1'000'000).baud, 406'250u);
  EXPECT_EQ(uart_rate(4'000'000'000u, 1).divider, 65535u * 64);
  EXPECT_NEAR(uart_rate(12'000'000, 115'200).baud, 115'200, 115);
}

/// 3.3.7: the dividers count from the store to the line register on.
TEST(Pl011, StartsWithTheLineBehindTheDividers) {
  using Port = Uart<FakePort<0>, 4>;
  std::uint32_t baud = 0;
  const auto stores = stores_of([&] { baud = Port::start(125'000'000, 1'000'000); });
  const std::vector<Store> expected{
      {"whole", 7}, {"fraction", 52}, {"line", 0x70}, {"interrupts", 0x50}, {"control", 0x301}};
  EXPECT_EQ(stores, expected);
  EXPECT_EQ(baud, 1'000'000u);
}

TEST(Pl011, TakesAllThatWaitsAndCountsWhatWasLost) {
  using Port = Uart<FakePort<1>, 4>;
  auto& port = FakePort<1>::registers();
  port.data.waiting = {1, 2, 3};
  Port::interrupt();
  EXPECT_TRUE(port.data.waiting.empty());
  EXPECT_EQ(Port::overruns(), 0u);
  port.data.waiting = {4 | 1u << 11, 5};
  Port::interrupt();
  EXPECT_EQ(Port::overruns(), 2u) << "one in the queue of the part, one in the ring";
  for (std::uint8_t expected = 1; expected <= 4; ++expected) {
    std::uint8_t byte = 0;
    ASSERT_TRUE(Port::read(byte));
    EXPECT_EQ(byte, expected);
  }
  EXPECT_TRUE(Port::idle());
}

TEST(Pl011, GivesUpAPortThatIsStuck) {
  using Port = Uart<FakePort<2>, 4>;
  auto& port = FakePort<2>::registers();
  const std::uint8_t bytes[] = {7, 9};
  EXPECT_TRUE(Port::write(bytes, 2));
  EXPECT_EQ(port.data.written, 9u);
  port.flags.stuck = true;
  EXPECT_FALSE(Port::write(bytes, 1));
}

}  // namespace
}  // namespace axial::hal::pl011
