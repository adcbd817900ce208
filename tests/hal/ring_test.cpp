#include <hal/ring.hpp>

#include <thread>

#include <gtest/gtest.h>

namespace axial::hal {
namespace {

TEST(Ring, HoldsItsCapacityAndRefusesMore) {
  ByteRing<8> ring;
  std::uint8_t byte = 0;
  EXPECT_TRUE(ring.empty());
  EXPECT_FALSE(ring.pop(byte));
  for (std::uint8_t i = 0; i < 8; ++i)
    EXPECT_TRUE(ring.push(i));
  EXPECT_FALSE(ring.push(99));
  for (std::uint8_t i = 0; i < 8; ++i) {
    ASSERT_TRUE(ring.pop(byte));
    EXPECT_EQ(byte, i);
  }
  EXPECT_FALSE(ring.pop(byte));
}

/// 200 000 bytes also carry the 16-bit counters around three times.
TEST(Ring, KeepsTheOrderBetweenTwoThreads) {
  constexpr unsigned bytes = 200000;
  ByteRing<64> ring;
  std::thread producer([&] {
    for (unsigned i = 0; i < bytes; ++i) {
      while (!ring.push(static_cast<std::uint8_t>(i * 7)))
        std::this_thread::yield();
    }
  });
  unsigned wrong = 0;
  for (unsigned i = 0; i < bytes; ++i) {
    std::uint8_t byte = 0;
    while (!ring.pop(byte))
      std::this_thread::yield();
    wrong += byte != static_cast<std::uint8_t>(i * 7);
  }
  producer.join();
  EXPECT_EQ(wrong, 0u);
}

}  // namespace
}  // namespace axial::hal
