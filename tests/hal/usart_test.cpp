#include <hal/stm32/usart.hpp>

#include <deque>

#include <gtest/gtest.h>

namespace axial::hal::stm32 {
namespace {

/// A receiver that has another byte as soon as one is taken. Reading status, then data, clears the overrun flag.
struct Played {
  struct Data {
    std::deque<std::uint8_t> waiting;
    std::uint32_t flags = 0, written = 0;
    void operator=(std::uint32_t value) { written = value; }
    operator std::uint32_t() {
      flags &= ~usart_status::overrun;
      if (waiting.empty()) return 0;
      const std::uint8_t byte = waiting.front();
      waiting.pop_front();
      return byte;
    }
  };
  struct Status {
    const Data* data;
    operator std::uint32_t() const { return data->flags | (data->waiting.empty() ? 0u : usart_status::received); }
  };
  Data data;
  Status status{&data};
};

struct FakePort {
  static Played& registers() {
    static Played port{};
    return port;
  }
};

TEST(Usart, DividerFollowsTheClock) {
  const auto check = [](std::uint32_t clock_Hz, std::uint32_t baud, std::uint32_t value, bool by_8,
                        std::uint32_t result) {
    const UsartDivider divider = usart_divider(clock_Hz, baud);
    EXPECT_EQ(divider.baud_register, value);
    EXPECT_EQ(divider.oversample_8, by_8);
    EXPECT_EQ(divider.baud, result);
  };
  check(84'000'000, 2'000'000, 42, false, 2'000'000);
  check(16'000'000, 2'000'000, 0x10, true, 2'000'000);
  check(24'000'000, 2'000'000, 0x14, true, 2'000'000);  // 12 = 8 * (1 + 4/8)
  check(8'000'000, 2'000'000, 0x10, true, 1'000'000);   // out of reach
  check(84'000'000, 115'200, 729, false, 115'226);
}

TEST(Usart, ReceivesByInterruptAndCountsWhatItLoses) {
  using Port = Usart<FakePort, 4>;
  auto& data = FakePort::registers().data;
  const auto expect_bytes = [](std::uint8_t first, std::uint8_t last) {
    for (std::uint8_t expected = first; expected <= last; ++expected) {
      std::uint8_t byte = 0;
      ASSERT_TRUE(Port::read(byte));
      EXPECT_EQ(byte, expected);
    }
    EXPECT_TRUE(Port::idle());
  };
  data.waiting = {1, 2, 3, 4, 5};
  Port::interrupt();
  EXPECT_TRUE(data.waiting.empty());
  EXPECT_EQ(Port::overruns(), 1u) << "the ring was full";
  expect_bytes(1, 4);
  data.waiting = {6};
  data.flags = usart_status::overrun;
  Port::interrupt();
  EXPECT_EQ(Port::overruns(), 2u) << "a byte came while this one waited";
  expect_bytes(6, 6);
  data.flags = usart_status::overrun;
  Port::interrupt();
  EXPECT_EQ(Port::overruns(), 3u) << "the byte was taken just before";
  EXPECT_EQ(data.flags, 0u) << "the flag is left to interrupt for ever";
  EXPECT_TRUE(Port::idle()) << "an overrun is no byte";
}

TEST(Usart, APortThatNeverSendsDoesNotHang) {
  using Port = Usart<FakePort, 4>;
  const std::uint8_t bytes[2] = {1, 2};
  FakePort::registers().data.flags = 0;
  EXPECT_FALSE(Port::write(bytes, 2));
  FakePort::registers().data.flags = usart_status::sent;
  EXPECT_TRUE(Port::write(bytes, 2));
  EXPECT_EQ(FakePort::registers().data.written, 2u);
}

}  // namespace
}  // namespace axial::hal::stm32
