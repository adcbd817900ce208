// Numbers with an exponent each, against double; sums in 96 bits, against 128.
#include <gtest/gtest.h>
#include <axial/fixed/words/scaled.hpp>

#include <cmath>
#include <random>

namespace {

using axial::Scaled;
using axial::integer::WideSum;
__extension__ using Wide = __int128;

double real(const Scaled& x) { return axial::to_real<double>(x); }
Scaled number(double x) { return axial::NumberTraits<Scaled>::constant(x); }
Wide wide(const WideSum& x) { return Wide{x.high} * (Wide{1} << 32) + x.low; }
WideSum sum(Wide x) { return {static_cast<std::int64_t>(x >> 32), static_cast<std::uint32_t>(x)}; }

constexpr double unit = 1.0 / (1 << 29);

}  // namespace

TEST(Scaled, ComputesToItsUnit) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-1.0, 1.0), power(-80.0, 80.0), near(-34.0, 34.0);
  for (int k = 0; k < 20000; ++k) {
    const double e = power(random);
    const double a = value(random) * std::exp2(e), b = value(random) * std::exp2(e + near(random));
    const Scaled x = number(a), y = number(b);
    const double p = real(x), q = real(y);
    EXPECT_NEAR(p, a, unit * std::fabs(a));
    EXPECT_NEAR(real(x * y), p * q, unit * std::fabs(p * q));
    EXPECT_NEAR(real(x + y), p + q, unit * std::fmax(std::fabs(p), std::fabs(q)));
    EXPECT_NEAR(real(x - y), p - q, unit * std::fmax(std::fabs(p), std::fabs(q)));
    EXPECT_NEAR(real(reciprocal(x)), 1.0 / p, unit / std::fabs(p));
    EXPECT_EQ(x < y, p < q);
  }
}
TEST(Scaled, KnowsZeroAndExtremes) {
  const Scaled zero(axial::Zero{}), one(axial::One{});
  EXPECT_EQ(real(zero), 0.0);
  EXPECT_EQ(real(one), 1.0);
  EXPECT_EQ(real(zero * one), 0.0);
  EXPECT_EQ(real(one + zero), 1.0);
  EXPECT_EQ(real(one - one), 0.0);
  EXPECT_TRUE(zero < one && !(one < zero) && !(zero < zero) && zero <= zero);
  for (const std::int64_t x : {INT64_MIN, INT64_MAX, INT64_C(-1), INT64_C(1), INT64_C(0), INT64_C(1) << 32})
    EXPECT_NEAR(real(Scaled::normal(x, 3)), 8.0 * double(x), unit * 8.0 * std::fabs(double(x))) << x;
}
TEST(Scaled, BecomesAWordOrSaysThatItIsLost) {
  bool lost = false;
  EXPECT_EQ(number(3.0).as_word(29, lost), 3 << 29);
  EXPECT_EQ(number(-0.75).as_word(2, lost), -3);
  EXPECT_EQ(number(1e-30).as_word(20, lost), 0);
  EXPECT_EQ(Scaled{}.as_word(31, lost), 0);
  EXPECT_FALSE(lost);
  EXPECT_EQ(number(4.0).as_word(29, lost), INT32_MAX);
  EXPECT_TRUE(lost);
  lost = false;
  EXPECT_EQ(number(-1e30).as_word(29, lost), -INT32_MAX);
  EXPECT_TRUE(lost);
}
TEST(WideSum, IsExactUpToItsBound) {
  std::mt19937_64 random(4);
  const Wide most = Wide{1} << 94;
  for (const Wide start : {Wide{0}, most, -most, Wide{-1}, (Wide{1} << 32) - 1}) {
    WideSum ours = sum(start);
    Wide truth = start;
    for (int k = 0; k < 20000; ++k) {
      const auto x = static_cast<std::int64_t>(random());
      ours.forget<7>(), truth -= truth >> 7;
      ours.add(x), truth += x;
      ASSERT_TRUE(wide(ours) == truth) << k;
    }
    EXPECT_NEAR(real(Scaled::of(ours, -60)), std::ldexp(double(truth), -60),
                2.0 * unit * std::fabs(std::ldexp(double(truth), -60)));
  }
  WideSum slow = sum(-most);
  slow.forget<28>();
  EXPECT_TRUE(wide(slow) == -most + (most >> 28));
}
