#include <hal/stm32/usart.hpp>

#include <gtest/gtest.h>

namespace axial::hal::stm32 {
namespace {

struct FakePort {
  static UsartRegisters& registers() {
    static UsartRegisters port{};
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
  auto& port = FakePort::registers();
  for (std::uint32_t byte = 1; byte <= 5; ++byte) {
    port.status = usart_status::received;
    port.data = byte;
    Port::interrupt();
  }
  EXPECT_EQ(Port::overruns(), 1u);
  for (std::uint8_t expected = 1; expected <= 4; ++expected) {
    std::uint8_t byte = 0;
    ASSERT_TRUE(Port::read(byte));
    EXPECT_EQ(byte, expected);
  }
  EXPECT_TRUE(Port::idle());
  port.status = usart_status::received | usart_status::overrun;
  Port::interrupt();
  EXPECT_EQ(Port::overruns(), 2u);
  EXPECT_FALSE(Port::idle());
}

TEST(Usart, APortThatNeverSendsDoesNotHang) {
  using Port = Usart<FakePort, 4>;
  const std::uint8_t bytes[2] = {1, 2};
  FakePort::registers().status = 0;
  EXPECT_FALSE(Port::write(bytes, 2));
  FakePort::registers().status = usart_status::sent;
  EXPECT_TRUE(Port::write(bytes, 2));
}

}  // namespace
}  // namespace axial::hal::stm32
