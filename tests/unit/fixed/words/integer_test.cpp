#include <gtest/gtest.h>
#include <axial/fixed/words/integer.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

// Compiled twice, once for either kind of multiplication: AXIAL_LONG_MULTIPLY names the tests of each.
#if AXIAL_LONG_MULTIPLY
#define AXIAL_PATH(name) name
#else
#define AXIAL_PATH(name) name##ByHalves
#endif

using namespace axial::integer;

namespace {

constexpr std::int32_t lowest = std::numeric_limits<std::int32_t>::min(),
                       highest = std::numeric_limits<std::int32_t>::max();

// Corners of words and of halves, and seeded words of every length.
std::vector<std::int32_t> words() {
  std::vector<std::int32_t> all;
  for (std::int32_t corner :
       {0, 1, 2, 0x7FFF, 0x8000, 0x8001, 0xFFFF, 0x10000, 0x10001, 0x7FFF0000, 0x7FFF8000, highest})
    for (std::int32_t sign : {1, -1})
      all.push_back(sign * corner);
  all.insert(all.end(), {lowest, lowest + 1, lowest + 0x8000, lowest + 0xFFFF});
  std::mt19937 engine(20261122);
  for (int i = 0; i < 1000; ++i)
    all.push_back(static_cast<std::int32_t>(engine()) >> (i % 31));
  return all;
}

std::int64_t floor_of_quotient(__int128 a, __int128 b) {
  return static_cast<std::int64_t>(a / b - (a % b < 0 ? 1 : 0));
}

// Modulo 2^64.
std::int64_t wrapped(__int128 a) { return static_cast<std::int64_t>(static_cast<std::uint64_t>(a)); }

}  // namespace

TEST(Integer, AXIAL_PATH(ProductsAreExact)) {
  for (std::int32_t a : words())
    for (std::int32_t b : words()) {
      const __int128 product = static_cast<__int128>(a) * b;
      ASSERT_EQ(multiply(a, b), static_cast<std::int64_t>(product)) << a << " * " << b;
      ASSERT_EQ(multiply_high(a, b), floor_of_quotient(product, __int128{1} << 32)) << a << " * " << b;
      const auto ua = static_cast<std::uint32_t>(a), ub = static_cast<std::uint32_t>(b);
      ASSERT_EQ(multiply_high_unsigned(ua, ub),
                static_cast<std::uint32_t>((static_cast<unsigned __int128>(ua) * ub) >> 32))
          << ua << " * " << ub;
    }
}

TEST(Integer, AXIAL_PATH(SumsOfProductsWrap)) {
  std::mt19937_64 engine(20261123);
  for (std::int32_t a : words())
    for (std::int32_t b : {lowest, highest, -0x8000, static_cast<std::int32_t>(engine())})
      for (std::int64_t sum : {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max(),
                               std::int64_t{0xFFFFFFFF}, static_cast<std::int64_t>(engine())}) {
        const __int128 product = static_cast<__int128>(a) * b;
        ASSERT_EQ(accumulate(sum, a, b), wrapped(sum + product)) << sum << " + " << a << " * " << b;
        ASSERT_EQ(deduct(sum, a, b), wrapped(sum - product)) << sum << " - " << a << " * " << b;
      }
}

TEST(Integer, AXIAL_PATH(AllIsConstexpr)) {
  static_assert(multiply(lowest, lowest) == std::int64_t{1} << 62 && multiply_high(lowest, lowest) == 1 << 30);
  static_assert(multiply_high(-1, 1) == -1 && multiply(-1, 1) == -1 && accumulate(5, -2, 3) == -1 &&
                deduct(5, 2, 3) == -1);
  static_assert(multiply<Factors::narrow>(1 << 30, -(1 << 30)) == -(std::int64_t{1} << 60));
  static_assert(multiply_high_unsigned(0xFFFFFFFFU, 0xFFFFFFFFU) == 0xFFFFFFFEU);
  static_assert(sincos(1U << 30).sin == 1 << 30 && sincos(1U << 30).cos == 0);
  static_assert(reciprocal(3).mantissa == 0x55555555U && reciprocal(3).exponent == 32);
}

TEST(Integer, AXIAL_PATH(SineAndCosineAreExactAtQuarterTurns)) {
  constexpr std::int32_t sine[] = {0, 1 << 30, 0, -(1 << 30)}, cosine[] = {1 << 30, 0, -(1 << 30), 0};
  for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
    EXPECT_EQ(sincos(quarter << 30).sin, sine[quarter]) << quarter;
    EXPECT_EQ(sincos(quarter << 30).cos, cosine[quarter]) << quarter;
  }
}

TEST(Integer, AXIAL_PATH(SineAndCosineErrAtMostByTheirBound)) {
  constexpr long double turn = 6.28318530717958647692528676655900577L;
  constexpr std::uint32_t stride = 4093;
  double worst = 0.0;
  std::uint32_t bam = 0;
  for (std::uint64_t i = 0; i < (std::uint64_t{1} << 32); i += stride, bam += stride) {
    const auto pair = sincos(bam), mirrored = sincos(0U - bam);
    ASSERT_EQ(mirrored.sin, -pair.sin) << bam;
    ASSERT_EQ(mirrored.cos, pair.cos) << bam;
    ASSERT_TRUE(std::abs(pair.sin) <= 1 << 30 && std::abs(pair.cos) <= 1 << 30) << bam;
    const long double angle = std::ldexp(turn * bam, -32);
    worst = std::fmax(worst, std::fabs(static_cast<double>(std::ldexp(1.0L * pair.sin, -30) - std::sin(angle))));
    worst = std::fmax(worst, std::fabs(static_cast<double>(std::ldexp(1.0L * pair.cos, -30) - std::cos(angle))));
  }
  EXPECT_LE(worst, sincos_error);
  EXPECT_GT(worst, std::ldexp(0.5, -30)) << "no rounding is that good: the measurement itself is wrong";
}

TEST(Integer, AXIAL_PATH(ReciprocalErrsAtMostByOneUnit)) {
  double worst = 0.0;
  for (std::uint32_t d = 1; d <= static_cast<std::uint32_t>(highest); d += d < 70000 ? 1 : 4093) {
    const auto r = reciprocal(static_cast<std::int32_t>(d));
    ASSERT_EQ(r.mantissa >> 30, 1U) << d;
    worst = std::fmax(worst, std::fabs(static_cast<double>(r.mantissa - std::ldexp(1.0L, r.exponent) / d)));
  }
  EXPECT_LE(worst, 1.0);
  EXPECT_GT(worst, 0.5) << "no rounding is that good: the measurement itself is wrong";
  EXPECT_EQ(reciprocal(1).exponent, 31);
  EXPECT_EQ(reciprocal(highest).exponent, 61);
}
