// The functions that a compiler may call, as images of RISC-V have them, against the definition, byte by byte.
#include <gtest/gtest.h>

#include <array>
#include <random>

// Under names of their own: the host has the usual ones.
#define memcpy riscv_memcpy
#define memmove riscv_memmove
#define memset riscv_memset
#define memcmp riscv_memcmp
#include <hal/riscv/memory_functions.cpp>
#undef memcpy
#undef memmove
#undef memset
#undef memcmp

namespace {

using Bytes = std::array<unsigned char, 48>;

struct Places {
  std::size_t to, from, length;
};

/// Every alignment of both, words and rests of words; overlaps in either direction.
template <class Expect>
void at_all_places(const Expect& expect) {
  for (std::size_t to = 0; to < 24; ++to)
    for (std::size_t from = 0; from < 24; ++from)
      for (std::size_t length = 0; length <= 24; ++length)
        expect(Places{to, from, length});
}

Bytes any_bytes(std::mt19937& random) {
  Bytes bytes{};
  for (auto& byte : bytes)
    byte = static_cast<unsigned char>(random());
  return bytes;
}

}  // namespace

TEST(RiscvMemory, MovesWhatOverlaps) {
  std::mt19937 random(1);
  at_all_places([&](const Places& p) {
    alignas(8) Bytes bytes = any_bytes(random);
    Bytes expected = bytes;
    for (std::size_t i = 0; i < p.length; ++i)
      expected[p.to + i] = bytes[p.from + i];
    EXPECT_EQ(riscv_memmove(&bytes[p.to], &bytes[p.from], p.length), &bytes[p.to]);
    ASSERT_EQ(bytes, expected) << p.length << " bytes from " << p.from << " to " << p.to;
  });
}

TEST(RiscvMemory, CopiesFromElsewhere) {
  std::mt19937 random(2);
  at_all_places([&](const Places& p) {
    alignas(8) const Bytes from = any_bytes(random);
    alignas(8) Bytes to = any_bytes(random);
    Bytes expected = to;
    for (std::size_t i = 0; i < p.length; ++i)
      expected[p.to + i] = from[p.from + i];
    EXPECT_EQ(riscv_memcpy(&to[p.to], &from[p.from], p.length), &to[p.to]);
    ASSERT_EQ(to, expected) << p.length << " bytes from " << p.from << " to " << p.to;
  });
}

TEST(RiscvMemory, FillsWithTheByteOfAnInt) {
  std::mt19937 random(3);
  for (const int value : {0, 0x5A, 0xFF, -1, 0x1234})
    at_all_places([&](const Places& p) {
      alignas(8) Bytes bytes = any_bytes(random);
      Bytes expected = bytes;
      for (std::size_t i = 0; i < p.length; ++i)
        expected[p.to + i] = static_cast<unsigned char>(value);
      EXPECT_EQ(riscv_memset(&bytes[p.to], value, p.length), &bytes[p.to]);
      ASSERT_EQ(bytes, expected) << p.length << " bytes of " << value << " to " << p.to;
    });
}

TEST(RiscvMemory, ComparesUpToTheFirstThatDiffers) {
  std::mt19937 random(4);
  at_all_places([&](const Places& p) {
    const Bytes one = any_bytes(random);
    Bytes other = any_bytes(random);
    for (std::size_t i = 0; i < p.length; ++i)
      other[p.from + i] = one[p.to + i];
    ASSERT_EQ(riscv_memcmp(&one[p.to], &other[p.from], p.length), 0);
    for (std::size_t i = p.length; i-- > 0;) {
      other[p.from + i] = static_cast<unsigned char>(one[p.to + i] ^ 0x80U);
      const bool less = one[p.to + i] < other[p.from + i];
      ASSERT_EQ(riscv_memcmp(&one[p.to], &other[p.from], p.length) < 0, less) << "at byte " << i << " of " << p.length;
    }
  });
}
