#include <hal/link/cobs.hpp>

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace axial::hal::link {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes stuff(const Bytes& data) {
  Bytes out(cobs_size(data.size()));
  CobsWriter writer(out.data());
  writer.start();
  for (const std::uint8_t byte : data)
    writer.put(byte);
  out.resize(writer.size());
  return out;
}

Bytes unstuff(const Bytes& coded) {
  Bytes out;
  CobsReader reader;
  for (const std::uint8_t byte : coded) {
    std::uint8_t value = 0xEE;  // whatever was there before
    if (reader.take(byte, value)) out.push_back(value);
  }
  EXPECT_TRUE(reader.complete());
  return out;
}

Bytes counting(unsigned first, unsigned count) {
  Bytes out;
  for (unsigned i = 0; i < count; ++i)
    out.push_back(static_cast<std::uint8_t>(first + i));
  return out;
}

Bytes join(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Examples worked by hand from the paper's rules.
TEST(Cobs, StuffsTheWorkedExamples) {
  EXPECT_EQ(stuff({}), (Bytes{1}));
  EXPECT_EQ(stuff({0}), (Bytes{1, 1}));
  EXPECT_EQ(stuff({0, 0}), (Bytes{1, 1, 1}));
  EXPECT_EQ(stuff({0x11, 0x22, 0, 0x33}), (Bytes{3, 0x11, 0x22, 2, 0x33}));
  EXPECT_EQ(stuff({0x11, 0, 0, 0}), (Bytes{2, 0x11, 1, 1, 1}));
}

TEST(Cobs, StuffsBlocksOf254) {
  EXPECT_EQ(stuff(counting(1, 254)), join({255}, counting(1, 254)));
  EXPECT_EQ(stuff(join({0}, counting(1, 254))), join({1, 255}, counting(1, 254)));
  EXPECT_EQ(stuff(counting(1, 255)), join(join({255}, counting(1, 254)), {2, 255}));
  EXPECT_EQ(stuff(join(counting(1, 254), {0})), join(join({255}, counting(1, 254)), {1, 1}));
}

TEST(Cobs, GivesBackAnyDataAndNeverSendsAZero) {
  std::mt19937 random(20240917);
  for (int round = 0; round < 4000; ++round) {
    Bytes data(random() % 600);
    const unsigned zeros_in_256 = round % 4 == 0 ? 0 : 1u << (round % 9);
    for (auto& byte : data)
      byte = random() % 256 < zeros_in_256 ? 0 : static_cast<std::uint8_t>(random() % 255 + 1);
    const Bytes coded = stuff(data);
    EXPECT_LE(coded.size(), cobs_size(data.size()));
    EXPECT_EQ(std::count(coded.begin(), coded.end(), 0), 0);
    ASSERT_EQ(unstuff(coded), data) << "round " << round;
  }
}

}  // namespace
}  // namespace axial::hal::link
