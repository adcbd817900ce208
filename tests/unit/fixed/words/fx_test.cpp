// Fixed point: formats, exact lazy products and sums, literals, angles; most of it by the compiler.
#include <gtest/gtest.h>
#include <axial/fixed/words/round.hpp>

#include <random>

namespace {

using namespace axial;
using Exact = Arithmetic<std::int32_t, true, false>;
using Checked = Arithmetic<std::int32_t, true, false, true>;
using Short = Arithmetic<std::int16_t, true, false>;
template <int E>
using X = Fx<E, Exact>;

constexpr std::uint64_t bits_of_third = detail::bits_of(1.0 / 3.0);
using Third = Literal<bits_of_third, Exact>;

}  // namespace

// What the types promise.
static_assert(sizeof(Fixed32) == 4 && sizeof(Fixed16) == 2 && sizeof(X<20>) == 4);
static_assert(!std::is_convertible_v<X<20>, X<21>> && !std::is_assignable_v<X<20>&, X<21>>);
static_assert(!std::is_convertible_v<X<20>, double> && !std::is_convertible_v<double, X<20>>);
static_assert(!std::is_convertible_v<Product<X<10>, X<10>>, X<20>>, "a product is rounded by name only");
static_assert(!std::is_convertible_v<Acc<20, Exact>, X<20>>);
static_assert(!std::is_convertible_v<Fixed32, Fixed16> && !std::is_convertible_v<Fixed16, Fixed32>);
static_assert(std::is_same_v<decltype(X<20>{} + X<20>{}), X<20>>);
static_assert(!std::is_same_v<decltype(X<20>{} + X<21>{}), X<20>>, "formats differ: the sum is lazy");

// Values, in constant expressions.
static_assert((X<4>{40} + X<4>{2}).raw == 42 && (X<4>{40} - X<4>{2}).raw == 38 && (-X<4>{40}).raw == -40);
static_assert(round_to<8>(X<4>{3} * X<4>{5}).raw == 15);
static_assert(round_to<4>(X<4>{3} * X<4>{5}).raw == 1, "15/256 = 0.9375/16, to nearest");
static_assert(round_to<8>(X<4>{3} * X<4>{5} + X<8>{7} - X<6>{1}).raw == 15 + 7 - 4);
static_assert(round_to<8>(-(X<4>{3} * X<4>{5})).raw == -15);
static_assert(round_to<10>(X<4>{3}).raw == 192 && twice(X<4>{3}).raw == 3 && decltype(twice(X<4>{}))::exponent == 3);
static_assert(NumberTraits<X<20>>::constant(-0.75).raw == -(3 << 18));
static_assert(select(true, X<3>{5}, X<3>{-7}).raw == 5 && select(false, X<3>{5}, X<3>{-7}).raw == -7);
static_assert(X<3>{5} > X<3>{4} && X<3>{-5} < X<3>{-4});
static_assert((-Third{}).value == -1.0 / 3.0 && (Third{} * Third{}).value == 1.0 / 9.0 &&
              (Third{} + Third{}).value == 2.0 / 3.0 && magnitude(-Third{}).value == 1.0 / 3.0);

TEST(Fixed, CapacityIsTheLargestWord) {
  EXPECT_EQ(Exact::capacity, 2147483647.0);
  EXPECT_EQ(Short::capacity, 32767.0);
}

TEST(Fixed, TheFittingExponentIsTheLargestAtWhichTheValueFits) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-30.0, 30.0);
  for (double capacity : {Exact::capacity, Short::capacity})
    for (int k = 0; k < 10000; ++k) {
      const double value = std::exp2(exponent(random)) * (k % 2 == 0 ? 1.0 : -1.0);
      const int e = detail::fitting_exponent(value, capacity);
      ASSERT_LE(std::fabs(std::nearbyint(std::ldexp(value, e))), capacity) << value;
      ASSERT_GT(std::ldexp(std::fabs(value), e + 1) + 0.5, capacity) << value;
    }
}

// round(a b + c d + e) in one rounding, against 128 bits.
template <int E, int F, int G, int H>
void expect_exact_sums(unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<std::int32_t> any(-(1 << 30), 1 << 30);
  for (int k = 0; k < 20000; ++k) {
    const std::int32_t a = any(random), b = any(random), c = any(random), d = any(random), e = any(random) >> 4;
    constexpr int common = E + F, drop = common - H;
    static_assert(drop > 0 && common >= G);
    __extension__ using Int128 = __int128;
    const Int128 exact = Int128{a} * b + Int128{c} * d + Int128{e} * (Int128{1} << (common - G));
    const auto wanted = static_cast<std::int64_t>((exact + (Int128{1} << (drop - 1))) >> drop);
    const auto sum = X<E>{a} * X<F>{b} + X<E>{c} * X<F>{d} + X<G>{e};
    ASSERT_EQ(round_to<H>(sum).raw, static_cast<std::int32_t>(wanted)) << a << " " << b << " " << c << " " << d;
  }
}
TEST(Fixed, SumsOfProductsAreRoundedOnce) {
  expect_exact_sums<20, 25, 30, 14>(2);
  expect_exact_sums<30, 30, 30, 29>(3);
  expect_exact_sums<10, 12, 14, -9>(4);
}

TEST(Fixed, ALiteralTakesTheExponentThatSuits) {
  std::mt19937_64 random(5);
  std::uniform_int_distribution<std::int32_t> any(INT32_MIN, INT32_MAX);
  for (int k = 0; k < 20000; ++k) {
    const X<24> x{any(random)};
    const double exact = std::ldexp(static_cast<double>(x.raw), -24) / 3.0;
    // The literal has 30 significant bits or more: of x its rounding costs less than 2^-31 of the value.
    EXPECT_NEAR(std::ldexp(static_cast<double>(round_to<24>(Third{} * x).raw), -24), exact,
                std::ldexp(0.5, -24) + std::ldexp(std::fabs(exact), -30));
  }
}

TEST(Fixed, AnglesWrapExactly) {
  constexpr Bam<Exact> most{INT32_MAX}, one{1};
  static_assert((most + one).raw == INT32_MIN);
  constexpr auto quarter = turned_by(Bam<Exact>{1 << 30}, [] { return 1.5707963267948966; });
  static_assert(quarter.raw == INT32_MIN, "half a turn");
  EXPECT_EQ((Bam<Exact>{INT32_MIN} + Bam<Exact>{-1}).raw, INT32_MAX);
}

TEST(Fixed, SineAndCosineKeepTheirPromiseInEitherWord) {
  for (std::int64_t k = 0; k < 1 << 16; ++k) {
    const auto raw = static_cast<std::int32_t>(k * 65536 + k - (std::int64_t{1} << 31));
    const double angle = raw * (6.283185307179586476925 / 4294967296.0);
    const auto pair = sincos(Bam<Exact>{raw});
    ASSERT_NEAR(pair.sin.raw * 0x1p-30, std::sin(angle), integer::sincos_error + 1e-16);
    ASSERT_NEAR(pair.cos.raw * 0x1p-30, std::cos(angle), integer::sincos_error + 1e-16);
    const auto narrow = sincos(Bam<Short>{raw});
    ASSERT_NEAR(narrow.sin.raw * 0x1p-14, std::sin(angle), 0x1p-15 + integer::sincos_error + 1e-16);
    ASSERT_NEAR(narrow.cos.raw * 0x1p-14, std::cos(angle), 0x1p-15 + integer::sincos_error + 1e-16);
  }
}

// Checked arithmetic counts what does not fit, and nothing else.
TEST(Fixed, CheckedArithmeticCountsEveryOverflow) {
  using C = Fx<20, Checked>;
  const auto counted = [](auto code) {
    const std::uint64_t before = range_overflows;
    code();
    return range_overflows - before;
  };
  volatile std::int32_t most = INT32_MAX, least = INT32_MIN;
  const C high{most}, low{least}, one{1};
  EXPECT_EQ(counted([&] { EXPECT_EQ((high + one).raw, INT32_MIN); }), 1U) << "counted, and wrapped";
  EXPECT_EQ(counted([&] { static_cast<void>(low - one); }), 1U);
  EXPECT_EQ(counted([&] { static_cast<void>(-low); }), 1U);
  EXPECT_EQ(counted([&] { static_cast<void>(round_to<21>(high)); }), 1U);
  EXPECT_EQ(counted([&] { static_cast<void>(round_to<12>(high * high)); }), 1U);
  EXPECT_EQ(counted([&] { static_cast<void>(high - one), static_cast<void>(-high); }), 0U);
  EXPECT_EQ(counted([&] { static_cast<void>(round_to<9>(high * high)); }), 0U) << "2^62 2^-40 at exponent 9: 2^31 - 1";
  EXPECT_EQ(counted([&] { EXPECT_EQ(round_to<20>(high * high - high * high + one).raw, 1); }), 0U)
      << "only what is stored has to fit";
}
