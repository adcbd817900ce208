#include <gtest/gtest.h>

#include <axial/scalar/sincos.hpp>
#include <cmath>
#include <random>

using namespace axial;

namespace {

// The same operations in the same order, and these tests are compiled without contraction: the same bits.
template <class T, int N>
void expect_the_same_bits(T range) {
  std::mt19937_64 engine(20261121);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int trial = 0; trial < 20000; ++trial) {
    T x[N];
    SinCos<T> pairs[N];
    for (T& angle : x)
      angle = range * static_cast<T>(any(engine));
    sincos(x, pairs);
    for (int i = 0; i < N; ++i) {
      ASSERT_EQ(pairs[i].sin, sincos(x[i]).sin) << x[i];
      ASSERT_EQ(pairs[i].cos, sincos(x[i]).cos) << x[i];
    }
  }
}

template <class T>
void expect_the_same_bits_for_every_remainder() {
  for (const T range : {T(1), T(7), T(1e4)}) {
    expect_the_same_bits<T, 1>(range);
    expect_the_same_bits<T, 4>(range);
    expect_the_same_bits<T, 6>(range);
    expect_the_same_bits<T, 7>(range);
  }
}

}  // namespace

TEST(PackedSinCos, GivesTheBitsOfOneAfterTheOtherInDouble) { expect_the_same_bits_for_every_remainder<double>(); }
TEST(PackedSinCos, GivesTheBitsOfOneAfterTheOtherInFloat) { expect_the_same_bits_for_every_remainder<float>(); }

TEST(PackedSinCos, NotFiniteStaysInItsLane) {
  const double x[] = {0.5, HUGE_VAL, -0.25, NAN};
  SinCos<double> pairs[4];
  sincos(x, pairs);
  EXPECT_TRUE(std::isnan(pairs[1].sin) && std::isnan(pairs[3].cos));
  EXPECT_EQ(pairs[0].sin, sincos(0.5).sin);
  EXPECT_EQ(pairs[2].cos, sincos(-0.25).cos);
}

TEST(PackedSinCos, IsConstexpr) {
  constexpr auto sine_of_zero = [] {
    const float x[] = {0.0F, 1.0F, 2.0F, 3.0F};
    SinCos<float> pairs[4] = {};
    sincos(x, pairs);
    return pairs[0].sin;
  };
  static_assert(sine_of_zero() == 0.0F);
}
