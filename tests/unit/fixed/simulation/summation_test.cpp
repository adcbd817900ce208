// Steps of time, and sums of words over them, against arithmetic of 128 bits.
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/integrators.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace axial;
__extension__ using Wide = __int128;
constexpr double fineness = 0x1p-29;  // of a step, of itself

double value(const FixedStep::Scale& x) { return std::ldexp(x.mantissa, -x.shift); }

void expect_in_proportion(const FixedStep::Scale& x, double wanted, double roundings) {
  EXPECT_NEAR(value(x), wanted, roundings * fineness * std::fabs(wanted)) << wanted;
  EXPECT_GE(std::abs(x.mantissa), 1 << 28) << wanted;
  EXPECT_LE(std::abs(x.mantissa), 1 << 29) << wanted;
}

}  // namespace

TEST(FixedStep, IsTheStepToAHalfOfItsLastPlace) {
  for (const double h : {1e-3, 1e-4, 0.25, 1.0, 1.0 / 3.0, 0x1p-30, -2e-3, 0.999999999}) {
    const FixedStep step = h;
    ASSERT_TRUE(step.is_step()) << h;
    expect_in_proportion(step.seconds(), h, 1.0);
    expect_in_proportion(step.turns(), h / 6.283185307179586, 3.0);
    expect_in_proportion(step.sixth().seconds(), h / 6.0, 3.0);
    expect_in_proportion(step.sixth().turns(), h / 6.0 / 6.283185307179586, 5.0);
    EXPECT_EQ(value(step.half().seconds()), value(step.seconds()) / 2.0);
    EXPECT_EQ(value(step.half().turns()), value(step.turns()) / 2.0);
  }
}

TEST(FixedStep, IsNoneOutOfItsRange) {
  for (const double h :
       {0.0, std::nan(""), 1.0000001, -1.5, 0x0.fffp-30, std::numeric_limits<double>::infinity(), 1e-310})
    EXPECT_FALSE(FixedStep(h).is_step()) << h;
}

TEST(Summation, MovesProductsToNearestAndSaysWhereTheyDoNotFit) {
  std::mt19937_64 random(1);
  int spills = 0;
  for (int k = 0; k < 200'000; ++k) {
    const auto product = static_cast<std::int64_t>(random() >> (random() % 62)) / 3 * (k % 2 == 0 ? 1 : -1);
    const int shift = static_cast<int>(random() % 90) - 30;
    bool spilt = false;
    const std::int64_t moved = detail::moved_product(product, shift, spilt);
    const int down = shift > 62 ? 62 : shift;
    const Wide wanted =
        down > 0 ? (Wide{product} + (Wide{1} << (down - 1))) >> down : Wide{product} * (Wide{1} << -down);
    const bool fits = wanted == static_cast<std::int64_t>(wanted);
    EXPECT_EQ(spilt, !fits) << product << " 2^" << -shift;
    if (fits) {
      ASSERT_EQ(moved, static_cast<std::int64_t>(wanted)) << product << " 2^" << -shift;
    }
    spills += spilt ? 1 : 0;
  }
  EXPECT_GT(spills, 1000) << "then nothing looks at what does not fit";
}

TEST(Summation, KeepsEveryBitOfASum) {
  std::mt19937_64 random(2);
  std::int32_t word = -5, rest = 1 << 30;
  Wide exact = Wide{word} * (Wide{1} << 32) + rest;
  for (int k = 0; k < 100'000; ++k) {
    const auto change = static_cast<std::int64_t>(random()) >> (10 + random() % 50);
    bool spilt = false;
    const detail::FineSum sum(word, rest, change, spilt);
    word = static_cast<std::int32_t>(sum.word), rest = sum.rest, exact += change;
    EXPECT_EQ(sum.word, word) << "a word holds it";
    ASSERT_FALSE(spilt);
    ASSERT_EQ(Wide{word} * (Wide{1} << 32) + rest, exact);
  }
}

TEST(Summation, SaysWhereASumLeavesSixtyFourBits) {
  bool up = false, down = false, inside = false;
  const std::int64_t large = std::int64_t{1} << 62;
  (void)detail::FineSum(1 << 30, 0, large, up);
  (void)detail::FineSum(-(1 << 30) - 1, 0, -large, down);
  (void)detail::FineSum(-(1 << 30), 0, large, inside);
  EXPECT_TRUE(up);
  EXPECT_TRUE(down);
  EXPECT_FALSE(inside);
}
