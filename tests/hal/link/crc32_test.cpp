#include <hal/link/crc32.hpp>

#include <vector>

#include <gtest/gtest.h>

namespace axial::hal::link {
namespace {

constexpr std::uint8_t digits[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};

// The check value of CRC-32/ISO-HDLC in every catalogue of CRCs.
static_assert(crc32(digits, 9) == 0xCBF43926u);
static_assert(crc32(digits, 0) == 0u);

/// Straight from the definition: one bit at a time.
std::uint32_t bit_by_bit(const std::vector<std::uint8_t>& bytes) {
  std::uint32_t state = 0xFFFFFFFFu;
  for (const std::uint8_t byte : bytes) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      const bool odd = ((state ^ (byte >> bit)) & 1u) != 0;
      state = (state >> 1) ^ (odd ? 0xEDB88320u : 0u);
    }
  }
  return ~state;
}

TEST(Crc32, EqualsTheDefinitionOnEveryByte) {
  std::vector<std::uint8_t> bytes;
  for (unsigned value = 0; value < 256; ++value) {
    bytes.push_back(static_cast<std::uint8_t>(value));
    EXPECT_EQ(crc32(bytes.data(), bytes.size()), bit_by_bit(bytes));
  }
}

TEST(Crc32, NoticesEveryOneBitError) {
  std::vector<std::uint8_t> bytes(107, 0x5A);
  const std::uint32_t right = crc32(bytes.data(), bytes.size());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
    EXPECT_NE(crc32(bytes.data(), bytes.size()), right) << "bit " << bit;
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
  }
}

}  // namespace
}  // namespace axial::hal::link
