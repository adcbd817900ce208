// Division by a reciprocal of fixed length, over all magnitudes of both operands.
#include <gtest/gtest.h>
#include <axial/fixed/words/divide.hpp>

#include <cmath>
#include <random>

namespace {

using namespace axial;
template <bool nearest>
using S = Arithmetic<std::int32_t, nearest, false>;

template <bool nearest>
void expect_quotients() {
  std::mt19937_64 random(1);
  constexpr int E = 20, F = 22, G = 12;
  int tried = 0;
  double worst = 0.0;
  for (int k = 0; k < 400000; ++k) {
    const auto y = static_cast<std::int32_t>((random() >> 33) >> (random() % 31));
    const auto x = static_cast<std::int32_t>(static_cast<std::int32_t>(random()) >> (random() % 31));
    if (y == 0) continue;
    const long double exact = static_cast<long double>(x) / y * std::ldexp(1.0L, G + E - F);
    if (std::fabs(exact) > 2147483000.0L) continue;
    const auto inverse = inverse_of(Fx<E, S<nearest>>{y});
    const auto found = quotient<G>(inverse, Fx<F, S<nearest>>{x}).raw;
    // The mantissa is within one unit of 2^30 to 2^31.
    const auto room = static_cast<double>(0x1p-30L * std::fabs(exact));
    const auto error = static_cast<double>(found - exact);
    ASSERT_LE(error, (nearest ? 0.5 : 0.0) + room) << x << " / " << y;
    ASSERT_GE(error, (nearest ? -0.5 : -1.0) - room) << x << " / " << y;
    worst = std::fmax(worst, std::fabs(error)), ++tried;
  }
  EXPECT_GT(tried, 100000);
  EXPECT_GT(worst, nearest ? 0.499 : 0.99);
}

}  // namespace

TEST(FixedDivide, ToNearest) { expect_quotients<true>(); }
TEST(FixedDivide, Down) { expect_quotients<false>(); }

TEST(FixedDivide, ShiftsByEveryAmountWithoutABranch) {
  for (const std::int64_t x : {std::int64_t{0x123456789abcdef}, std::int64_t{-0x123456789abcdef}, std::int64_t{-1}})
    for (int shift = 0; shift < 64; ++shift)
      EXPECT_EQ(detail::shifted_by(x, shift), static_cast<std::int32_t>(x >> shift)) << shift;
}

static_assert(quotient<8>(inverse_of(Fx<10, S<true>>{3 << 10}), Fx<10, S<true>>{6 << 10}).raw == 2 << 8);
static_assert(quotient<8>(inverse_of(Fx<10, S<true>>{3 << 10}), Fx<10, S<true>>{-(6 << 10)}).raw == -(2 << 8));
static_assert(quotient<8>(inverse_of(Fx<10, S<true>>{3 << 10}), Literal<detail::bits_of(6.0), S<true>>{}).raw ==
              2 << 8);
