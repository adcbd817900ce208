// Words of 64 bits against what the compiler makes of them.
#include <gtest/gtest.h>
#include <axial/fixed.hpp>
#include <axial/fixed/words/wide_words.hpp>
#include <host_sim/figures/exhaustive/fixed_states.hpp>

using namespace axial;

TEST(WideWords, AreDividedByPowersOf2RoundedDown) {
  for (const std::int64_t x : {INT64_MAX, INT64_MIN, std::int64_t{-1}, std::int64_t{0},
                               std::int64_t{0x123456789abcdef0}, -std::int64_t{0x123456789abcdef0}})
    for (int shift = 0; shift < 64; ++shift)
      EXPECT_EQ(detail::wide_shifted_by(x, shift), x >> shift) << x << " by " << shift;
}

TEST(WideWords, AreComparedAndChosenByTheirSigns) {
  constexpr std::int64_t numbers[] = {-(std::int64_t{1} << 62), -(std::int64_t{1} << 32),   -1, 0, 1, 0xffffffff,
                                      std::int64_t{1} << 32,    (std::int64_t{1} << 62) - 1};
  for (const std::int64_t a : numbers)
    for (const std::int64_t b : numbers) {
      EXPECT_EQ(detail::is_less_wide(a, b), a < b) << a << ' ' << b;
      EXPECT_EQ(detail::select_wide(a < b, a, b), a < b ? a : b) << a << ' ' << b;
    }
}

TEST(WideWords, AreRaisedAndMoved) {
  exhaustive::Random random(7);
  for (int k = 0; k < 20000; ++k) {
    const std::int64_t x = random.between(-(std::int64_t{1} << 61), std::int64_t{1} << 61) >> random.between(0, 62);
    const int shift = static_cast<int>(random.between(0, 31));
    const auto raised = static_cast<std::int64_t>(static_cast<std::uint64_t>(x) << shift);
    ASSERT_EQ(detail::wide_raised(x, shift), raised) << x << " << " << shift;
    bool down = true, up = true;
    const int far = static_cast<int>(random.between(0, 80));
    ASSERT_EQ(detail::moved_wide(x, far, down), x >> (far < 63 ? far : 63)) << x << " >> " << far;
    EXPECT_TRUE(down);
    const std::int64_t left = detail::moved_wide(x, -far, up);
    const bool word = x < (std::int64_t{1} << 31) && x > -(std::int64_t{1} << 31);
    ASSERT_EQ(up, far == 0 || (far < 32 && word)) << x << " << " << far;
    if (up) {
      ASSERT_EQ(left, static_cast<std::int64_t>(static_cast<std::uint64_t>(x) << far)) << x << " << " << far;
    }
  }
}
TEST(WideWords, ArePowersOf2) {
  for (int shift = 0; shift < 63; ++shift)
    EXPECT_EQ(detail::wide_power(shift), std::int64_t{1} << shift);
}
TEST(WideWords, AreRoundedAndCounted) {
  for (int bits = 0; bits < 62; ++bits)
    for (const std::int64_t off : {-1, 0, 1})
      for (const int sign : {-1, 1}) {
        const std::int64_t x = sign * ((std::int64_t{1} << bits) + off);
        int wanted = 1;
        for (std::int64_t left = x < 0 ? -x : x; left > 1; left >>= 1)
          ++wanted;
        ASSERT_EQ(detail::wide_bits(x), wanted) << x;
        ASSERT_EQ(detail::wide_rounded(x, 3), (x + 4) >> 3) << x;
      }
}
