// Rounding: to nearest, down, upper words; in 32 and 16 bits; held within a format.
#include <gtest/gtest.h>
#include <axial/fixed/words/round.hpp>

#include <cmath>
#include <random>

namespace {

using namespace axial;
template <class Word, bool nearest, bool high>
using A = Arithmetic<Word, nearest, high>;

// One product into a format: what it may be off, in units of the result.
template <class S, int E, int F, int G>
void expect_product_between(double low, double high) {
  std::mt19937_64 random(1);
  using Word = typename S::Word;
  double least = 1.0, most = -1.0;
  for (int k = 0; k < 20000; ++k) {
    const auto a = static_cast<Word>(random()), b = static_cast<Word>(random());
    const long double exact = std::ldexp(static_cast<long double>(a) * static_cast<long double>(b), G - E - F);
    const auto error = static_cast<double>(round_to<G>(Fx<E, S>{a} * Fx<F, S>{b}).raw - exact);
    least = std::fmin(least, error), most = std::fmax(most, error);
  }
  EXPECT_GE(least, low);
  EXPECT_LE(most, high);
  EXPECT_LT(least, low + 0.01 * (high - low)) << "the limit is reached";
  EXPECT_GT(most, high - 0.01 * (high - low)) << "the limit is reached";
}

}  // namespace

TEST(FixedRound, ToNearestIsWithinHalfAUnit) {
  expect_product_between<A<std::int32_t, true, false>, 30, 30, 28>(-0.5, 0.5);
  expect_product_between<A<std::int16_t, true, false>, 14, 14, 12>(-0.5, 0.5);
}
TEST(FixedRound, DownIsWithinAUnitBelow) {
  expect_product_between<A<std::int32_t, false, false>, 30, 30, 28>(-1.0, 0.0);
  expect_product_between<A<std::int16_t, false, false>, 14, 14, 12>(-1.0, 0.0);
}
TEST(FixedRound, TheUpperWordIsWithinAUnitBelow) {
  expect_product_between<A<std::int32_t, false, true>, 30, 30, 28>(-1.0, 0.0);
  expect_product_between<A<std::int16_t, false, true>, 14, 14, 12>(-1.0, 0.0);
}

// Halves go up, exactly; down is floor, also of negative numbers.
static_assert(round_to<0>(Fx<1, A<std::int32_t, true, false>>{3}).raw == 2);
static_assert(round_to<0>(Fx<1, A<std::int32_t, true, false>>{-3}).raw == -1);
static_assert(round_to<0>(Fx<1, A<std::int32_t, false, false>>{3}).raw == 1);
static_assert(round_to<0>(Fx<1, A<std::int32_t, false, false>>{-3}).raw == -2);
static_assert(round_to<0>(Acc<1, A<std::int32_t, true, false>>{3}).raw == 2);
static_assert(round_to<0>(Acc<1, A<std::int32_t, false, false>>{static_cast<std::uint64_t>(-3)}).raw == -2);
static_assert(round_to<4>(Acc<1, A<std::int32_t, true, false>>{3}).raw == 24, "to the left nothing is lost");

// What kernels call: terms given one by one, a zero by type among them, are rounded as their lazy sum is.
TEST(FixedRound, ASumOfTermsIsRoundedOnce) {
  using S = A<std::int32_t, true, false>;
  std::mt19937_64 random(4);
  double most = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const auto word = [&random] { return static_cast<std::int32_t>(random()) >> 2; };
    const Fx<30, S> a{word()}, b{word()}, c{word()}, d{word()};
    const Fx<34, S> e{word()};
    const auto sum = detail::rounded_sum<28, S>(a * b, -(c * d), Zero{}, e);
    EXPECT_EQ(sum.raw, (round_to<28>(a * b - c * d + e).raw));
    const long double exact = std::ldexp(static_cast<long double>(a.raw) * b.raw, -32) -
                              std::ldexp(static_cast<long double>(c.raw) * d.raw, -32) +
                              std::ldexp(static_cast<long double>(e.raw), -6);
    most = std::fmax(most, std::fabs(static_cast<double>(sum.raw - exact)));
    const Fx<28, S> f{word()};
    EXPECT_EQ((detail::rounded_sum<28, S>(Zero{}, f, f).raw), 2 * f.raw);
  }
  EXPECT_LE(most, 0.5);
  EXPECT_GT(most, 0.49);
}

TEST(FixedRound, AnAccumulatorMayWrapOnTheWay) {
  using S = A<std::int32_t, true, false>;
  const Fx<30, S> most{INT32_MAX}, one{1};
  const auto big = most * most;  // three of them wrap 64 bits
  EXPECT_EQ(round_to<30>(big + big + big - big - big - big + one).raw, 1);
}

TEST(FixedRound, UpperWordsOfSumsAreWithinAUnitATerm) {
  using S = A<std::int32_t, true, true>;
  std::mt19937_64 random(2);
  std::uniform_int_distribution<std::int32_t> any(-(1 << 29), 1 << 29);
  for (int k = 0; k < 20000; ++k) {
    const std::int32_t a = any(random), b = any(random), c = any(random), d = any(random);
    const long double exact = (static_cast<long double>(a) * b - static_cast<long double>(c) * d) * 0x1p-32L;
    const auto error =
        static_cast<double>(round_to<28>(Fx<30, S>{a} * Fx<30, S>{b} - Fx<30, S>{c} * Fx<30, S>{d}).raw - exact);
    ASSERT_LE(std::fabs(error), 1.0);
  }
}

TEST(FixedRound, WhatIsTurnedKeepsItsFormat) {
  using S = A<std::int32_t, true, false>;
  const Fx<30, S> cosine{1 << 29};
  const auto half = turned(cosine * Fx<17, S>{1001});
  static_assert(std::is_same_v<decltype(half), const Fx<17, S>>);
  EXPECT_EQ(half.raw, 501);
}

template <class S>
void expect_held() {
  using Word = typename S::Word;
  constexpr auto most = static_cast<Word>(S::capacity);
  const Fx<10, S> x{most};
  bool lost = false;
  EXPECT_EQ(saturated<10>(lost, x - Fx<10, S>{1}).raw, most - 1);
  EXPECT_FALSE(lost);
  EXPECT_EQ((saturated<10>(lost, Sum<Fx<10, S>, Fx<10, S>>{x, x}).raw), most);
  EXPECT_TRUE(lost);
  lost = false;
  EXPECT_EQ((saturated<10>(lost, Sum<Fx<10, S>, Fx<10, S>>{-x, -x}).raw), -most);
  EXPECT_TRUE(lost);
  lost = true;
  EXPECT_EQ(saturated<9>(lost, Fx<10, S>{6}).raw, 3);
  EXPECT_TRUE(lost) << "the flag is sticky";
}
TEST(FixedRound, SaturationHoldsAndTells) {
  expect_held<A<std::int32_t, true, false>>();
  expect_held<A<std::int32_t, false, true>>();
  expect_held<A<std::int16_t, true, false>>();
}
