#include <gtest/gtest.h>
#include <quadmath.h>
#include <axial/scalar/math.hpp>
#include <axial/scalar/sincos.hpp>
#include <cmath>
#include <random>

using namespace axial;

namespace {

double last_bit(double x) { return std::nextafter(std::fabs(x), HUGE_VAL) - std::fabs(x); }

struct Worst {
  double sine = 0.0, cosine = 0.0;
};

// Largest error over seeded random and regular arguments in [-range, range], measured by `unit(reference)`.
template <class T, class Unit>
Worst worst_error(double range, int count, Unit unit) {
  std::mt19937_64 engine(20261121);
  std::uniform_real_distribution<double> any(-range, range);
  Worst worst;
  for (int i = 0; i < count; ++i) {
    const T x = static_cast<T>(i % 2 == 0 ? any(engine) : range * (2.0 * i / count - 1.0));
    const auto pair = sincos(x);
    const __float128 s = sinq(static_cast<__float128>(x)), c = cosq(static_cast<__float128>(x));
    worst.sine = std::fmax(worst.sine, static_cast<double>(fabsq(pair.sin - s)) / unit(static_cast<double>(s)));
    worst.cosine = std::fmax(worst.cosine, static_cast<double>(fabsq(pair.cos - c)) / unit(static_cast<double>(c)));
  }
  return worst;
}

}  // namespace

TEST(SinCos, DoubleIsWithinOneUlp) {
  for (double range : {0.8, 7.0, 1e6}) {
    const Worst worst = worst_error<double>(range, 200000, last_bit);
    EXPECT_LE(worst.sine, 1.0) << range;
    EXPECT_LE(worst.cosine, 1.0) << range;
    EXPECT_GT(worst.sine, 0.4) << "the measurement itself is wrong";
  }
}

TEST(SinCos, FloatErrorIsBelowThreeHalvesOfTwoToMinus24) {
  const auto half_bit_of_one = [](double) { return std::ldexp(1.0, -24); };
  for (double range : {0.8, 7.0, 1e4}) {
    const Worst worst = worst_error<float>(range, 200000, half_bit_of_one);
    EXPECT_LE(worst.sine, 1.5) << range;
    EXPECT_LE(worst.cosine, 1.5) << range;
    EXPECT_GT(worst.sine, 0.4) << "the measurement itself is wrong";
  }
}

TEST(SinCos, SmallArgumentsAreExact) {
  for (float x : {0.0F, 1e-30F, -1e-8F, 1e-5F}) {
    EXPECT_EQ(sincos(x).sin, x);
    EXPECT_EQ(sincos(x).cos, 1.0F);
  }
}

TEST(SinCos, NotFiniteGivesNan) {
  for (float x : {NAN, INFINITY, -INFINITY}) {
    EXPECT_TRUE(std::isnan(sincos(x).sin));
    EXPECT_TRUE(std::isnan(sincos(x).cos));
  }
}

TEST(SinCos, IsConstexpr) {
  static_assert(sincos(0.0).cos == 1.0 && sincos(0.0).sin == 0.0);
  static_assert(sincos(1.5707963267948966).sin == 1.0);
}

TEST(SquareRoot, IsWithinOneUlp) {
  double worst = 0.0;
  for (double x = 1e-300; x < 1e300; x *= 1.37)
    worst = std::fmax(worst, std::fabs(square_root(x) - std::sqrt(x)) / last_bit(std::sqrt(x)));
  EXPECT_LE(worst, 1.0);
  static_assert(square_root(4.0) == 2.0 && square_root(0.0) == 0.0 && square_root(2.0F) > 1.41421F);
  EXPECT_TRUE(std::isnan(square_root(-1.0)));
  EXPECT_EQ(square_root(static_cast<double>(INFINITY)), static_cast<double>(INFINITY));
}
