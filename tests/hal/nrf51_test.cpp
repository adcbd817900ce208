#include <hal/nrf51/timer_tick.hpp>
#include <hal/nrf51/uart.hpp>

#include <gtest/gtest.h>

namespace axial::hal::nrf51 {
namespace {

struct FakePort {
  static constexpr std::uint32_t transmit_pin = 24, receive_pin = 25;
  static UartRegisters& registers() {
    static UartRegisters port{};
    return port;
  }
};

/// The values of the reference manual's table of rates (29.10.13), which rounds the slower ones; 1 Mbit/s is the most.
TEST(Nrf51Uart, RateIsNearestAndBounded) {
  EXPECT_EQ(uart_rate(1'000'000).baud_register, 0x10000000u);
  EXPECT_EQ(uart_rate(250'000).baud_register, 0x04000000u);
  EXPECT_EQ(uart_rate(115'200).baud_register, 0x01D7E000u);
  EXPECT_EQ(uart_rate(9'600).baud_register, 0x00275000u);
  EXPECT_EQ(uart_rate(2'000'000).baud, 1'000'000u);
  EXPECT_NEAR(uart_rate(115'200).baud, 115'200, 16);
}

TEST(Nrf51Uart, StartNamesPinsAndRate) {
  using Port = Uart<FakePort, 4>;
  EXPECT_EQ(Port::start(16'000'000, 1'000'000), 1'000'000u);
  const auto& port = FakePort::registers();
  EXPECT_EQ(port.pin_transmit, 24u);
  EXPECT_EQ(port.pin_receive, 25u);
  EXPECT_EQ(port.baud, 0x10000000u);
  EXPECT_EQ(port.enable, 4u);
}

/// The played event does not come back by itself: each interrupt takes one byte.
TEST(Nrf51Uart, ReceivesByInterruptAndCountsWhatItLoses) {
  using Port = Uart<FakePort, 4>;
  auto& port = FakePort::registers();
  port.error = 0;
  for (std::uint32_t byte = 1; byte <= 5; ++byte) {
    port.received = 1;
    port.receive = byte;
    Port::interrupt();
    EXPECT_EQ(port.received, 0u);
  }
  EXPECT_EQ(Port::overruns(), 1u) << "the ring was full";
  for (std::uint8_t expected = 1; expected <= 4; ++expected) {
    std::uint8_t byte = 0;
    ASSERT_TRUE(Port::read(byte));
    EXPECT_EQ(byte, expected);
  }
  EXPECT_TRUE(Port::idle());
  for (const std::uint32_t source : {uart_overrun, 1u << 2 /* framing */}) {
    port.error = 1;
    port.error_source = source;
    Port::interrupt();
    EXPECT_EQ(port.error, 0u);
  }
  EXPECT_EQ(Port::overruns(), 2u) << "an overrun loses a byte, a framing error does not";
}

TEST(Nrf51Uart, APortThatNeverSendsDoesNotHang) {
  using Port = Uart<FakePort, 4>;
  const std::uint8_t bytes[2] = {1, 2};
  EXPECT_FALSE(Port::write(bytes, 2));
  EXPECT_EQ(FakePort::registers().transmit, 1u) << "the rest is dropped";
}

struct FakeTimer {
  static inline int enabled = 0;
  static TimerRegisters& registers() {
    static TimerRegisters timer{};
    return timer;
  }
  static void enable_line() { ++enabled; }
};

TEST(Nrf51Tick, PeriodIsWholeClocksAndOnlyAnEventCounts) {
  using Tick = TimerTick<FakeTimer>;
  auto& timer = FakeTimer::registers();
  Tick::start(16'000'000, 500);
  EXPECT_EQ(timer.compare[0], 32'000u);
  EXPECT_EQ(timer.width, 3u) << "32 bits";
  EXPECT_EQ(timer.start, 1u);
  EXPECT_EQ(FakeTimer::enabled, 1);
  timer.compared[0] = 1;
  Tick::interrupt();
  EXPECT_EQ(timer.compared[0], 0u);
  Tick::interrupt();
  EXPECT_EQ(Tick::count(), 1u);
  timer.compared[0] = 1;
  Tick::stop();
  Tick::interrupt();
  EXPECT_EQ(Tick::count(), 1u) << "what was pending when the tick stopped";
}

}  // namespace
}  // namespace axial::hal::nrf51
