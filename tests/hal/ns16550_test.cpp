#include <hal/ns16550/uart.hpp>

#include <deque>

#include <gtest/gtest.h>

namespace axial::hal::ns16550 {
namespace {

/// A receiver's queue that empties as it is read.
struct Played {
  struct Data {
    std::deque<std::uint8_t> waiting;
    std::uint8_t written = 0;
    void operator=(std::uint8_t value) { written = value; }
    operator std::uint8_t() {
      const std::uint8_t byte = waiting.front();
      waiting.pop_front();
      return byte;
    }
  };
  struct Status {
    Data* data;
    std::uint8_t flags = 0;
    /// Reading clears the overrun flag.
    operator unsigned() {
      const unsigned now = flags | (data->waiting.empty() ? 0u : line_status::received);
      flags = static_cast<std::uint8_t>(flags & ~line_status::overrun);
      return now;
    }
  };
  Data data;
  std::uint8_t interrupt_enable = 0, fifo_control = 0, line_control = 0;
  Status line_status{&data};
};

struct FakePort {
  static Played& registers() {
    static Played port{};
    return port;
  }
};

TEST(Ns16550, DivisorFollowsTheClock) {
  EXPECT_EQ(uart_divisor(3'686'400, 230'400), 1u);
  EXPECT_EQ(uart_divisor(3'686'400, 115'200), 2u);
  EXPECT_EQ(uart_divisor(1'843'200, 9'600), 12u);
  EXPECT_EQ(uart_baud(3'686'400, 1'000'000), 230'400u) << "out of reach: the most there is";
}

TEST(Ns16550, StartLeavesTheDivisorLatchClosed) {
  using Port = Uart<FakePort, 4>;
  EXPECT_EQ(Port::start(3'686'400, 9'600), 9'600u);
  const auto& port = FakePort::registers();
  EXPECT_EQ(port.data.written, 24u);
  EXPECT_EQ(port.line_control, eight_bits);
  EXPECT_EQ(port.fifo_control, clear_queues);
  EXPECT_EQ(port.interrupt_enable, 5u) << "bytes and errors of the receiver";
}

TEST(Ns16550, ReceivesByInterruptAndCountsWhatItLoses) {
  using Port = Uart<FakePort, 4>;
  auto& port = FakePort::registers();
  port.data.waiting = {1, 2, 3, 4, 5};
  Port::interrupt();
  EXPECT_TRUE(port.data.waiting.empty());
  EXPECT_EQ(Port::overruns(), 1u) << "the ring was full";
  for (std::uint8_t expected = 1; expected <= 4; ++expected) {
    std::uint8_t byte = 0;
    ASSERT_TRUE(Port::read(byte));
    EXPECT_EQ(byte, expected);
  }
  EXPECT_TRUE(Port::idle());
  port.line_status.flags = line_status::overrun;
  Port::interrupt();
  EXPECT_EQ(Port::overruns(), 2u);
  EXPECT_TRUE(Port::idle());
}

TEST(Ns16550, APortThatNeverSendsDoesNotHang) {
  using Port = Uart<FakePort, 4>;
  const std::uint8_t bytes[2] = {1, 2};
  FakePort::registers().line_status.flags = 0;
  EXPECT_FALSE(Port::write(bytes, 2));
  FakePort::registers().line_status.flags = line_status::room_to_send;
  EXPECT_TRUE(Port::write(bytes, 2));
  EXPECT_EQ(FakePort::registers().data.written, 2u);
}

}  // namespace
}  // namespace axial::hal::ns16550
