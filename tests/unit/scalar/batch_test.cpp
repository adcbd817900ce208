// Batches as numbers: every lane by itself, whatever the registers' width; arrays of states and back.
#include <gtest/gtest.h>
#include <axial/batch.hpp>
#include <robots/panda.hpp>
#include <robots/scara.hpp>
#include <vector>

namespace {

using namespace axial;

template <class T, int N>
struct Kind {
  using Number = Batch<T, N>;
  using Element = T;
};

template <class K>
class BatchOf : public testing::Test {
 protected:
  using B = typename K::Number;
  using T = typename K::Element;
  // Different in each lane, and none is zero.
  static B numbers(T first) {
    return B::of([&](int k) { return first + T(k) * T(0.375); });
  }
  template <class Check>
  static void each_lane(const Check& check) {
    for (int k = 0; k < B::size; ++k)
      check(k);
  }
};
using Kinds = testing::Types<Kind<double, 2>, Kind<double, 4>, Kind<double, 8>, Kind<float, 4>, Kind<float, 16>>;
TYPED_TEST_SUITE(BatchOf, Kinds);

TYPED_TEST(BatchOf, CountsLanesInOrder) {
  using T = typename TypeParam::Element;
  const auto x = this->numbers(T(2));
  this->each_lane([&](int k) { EXPECT_EQ(x[k], T(2) + T(k) * T(0.375)); });
}

TYPED_TEST(BatchOf, ComputesLaneByLane) {
  using T = typename TypeParam::Element;
  const auto a = this->numbers(T(-1.5)), b = this->numbers(T(0.25));
  const auto sum = a + b, difference = a - b, product = a * b, quotient = a / b, minus = -a;
  const auto twice = a * Int<2>{}, inverse = reciprocal(b);
  this->each_lane([&](int k) {
    EXPECT_EQ(sum[k], a[k] + b[k]);
    EXPECT_EQ(difference[k], a[k] - b[k]);
    EXPECT_EQ(product[k], a[k] * b[k]);
    EXPECT_EQ(quotient[k], a[k] / b[k]);
    EXPECT_EQ(minus[k], -a[k]);
    EXPECT_EQ(twice[k], a[k] + a[k]);
    EXPECT_EQ(inverse[k], T(1) / b[k]);
  });
}

TYPED_TEST(BatchOf, DecidesLaneByLane) {
  using T = typename TypeParam::Element;
  const auto x = this->numbers(T(-0.75));  // negative in two lanes, 0 in one, positive in the rest
  const auto y = -x, zero = typename TypeParam::Number(T(0));
  const auto least = select(x < y, x, y);
  const auto below = x<zero, above = x> zero, neither = !(below | above), both = below & above;
  this->each_lane([&](int k) {
    EXPECT_EQ(least[k], x[k] < y[k] ? x[k] : y[k]) << k;
    EXPECT_EQ(below[k], k < 2) << k;
    EXPECT_EQ(above[k], k > 2) << k;
    EXPECT_EQ(neither[k], k == 2) << k;
    EXPECT_FALSE(both[k]) << k;
  });
}

TYPED_TEST(BatchOf, FindsTheFirstOfEachLane) {
  using T = typename TypeParam::Element;
  const auto x = this->numbers(T(0));
  Ordinal<typename TypeParam::Number> found = -1;
  for (int i = 0; i < 4; ++i)
    found = first_found(found, x < typename TypeParam::Number(T(i)), i);
  this->each_lane([&](int k) {
    const int wanted = static_cast<int>(x[k]) + 1;  // the least whole number above x
    EXPECT_EQ(found[k], wanted < 4 ? wanted : -1) << k;
  });
}

TYPED_TEST(BatchOf, HasTheSinesOfOneNumber) {
  using T = typename TypeParam::Element;
  for (T first : {T(-7), T(-0.5), T(0.8), T(123.25)}) {
    const auto x = this->numbers(first);
    const auto pair = sincos(x);
    this->each_lane([&](int k) {
      const SinCos<T> one = sincos(x[k]);
      const double last_bit = static_cast<double>(std::numeric_limits<T>::epsilon());
      EXPECT_NEAR(static_cast<double>(pair.sin[k]), static_cast<double>(one.sin), last_bit) << x[k];
      EXPECT_NEAR(static_cast<double>(pair.cos[k]), static_cast<double>(one.cos), last_bit) << x[k];
    });
  }
}

TYPED_TEST(BatchOf, TellsNumbersFromOthers) {
  using T = typename TypeParam::Element;
  const T others[] = {T(1), std::numeric_limits<T>::infinity(), std::numeric_limits<T>::quiet_NaN(),
                      std::numeric_limits<T>::max()};
  const auto finite = is_finite(TypeParam::Number::of([&](int k) { return others[k % 4]; }));
  this->each_lane([&](int k) { EXPECT_EQ(finite[k], k % 4 == 0 || k % 4 == 3) << k; });
}

// Fewer joints than lanes, as many, more; one array between two numbers that must stay as they are.
template <class Robot, class T, int N>
void expect_round_trip() {
  using State = Joints<Robot, T>;
  std::vector<State> states(N), back(N + 2);
  T next = T(0.5);
  for (State& state : states)
    for (T& x : state.values)
      x = next, next = next + T(1);
  back.front()[0] = back.back()[0] = T(-1);
  const auto batches = load<N>(states.data());
  store(batches, back.data() + 1);
  for (int k = 0; k < N; ++k) {
    const auto one = lane(batches, k);
    for (int i = 0; i < State::size; ++i) {
      const T wanted = states[std::size_t(k)][i];
      EXPECT_EQ(batches[i][k], wanted) << k << ' ' << i;
      EXPECT_EQ(back[std::size_t(k) + 1][i], wanted) << k << ' ' << i;
      EXPECT_EQ(one[i], wanted) << k << ' ' << i;
    }
  }
  EXPECT_EQ(back.front()[0], T(-1));
  EXPECT_EQ(back.back()[0], T(-1));
}
template <class Robot>
void expect_round_trips() {
  expect_round_trip<Robot, double, 2>();
  expect_round_trip<Robot, double, 4>();
  expect_round_trip<Robot, double, 8>();
  expect_round_trip<Robot, float, 4>();
  expect_round_trip<Robot, float, 8>();
  expect_round_trip<Robot, float, 16>();
}
struct FourJoints {
  static constexpr auto chain = axial::chain(gravity(0, 0, 0), revolute(), revolute(), revolute(), revolute());
};
TEST(BatchJoints, ComeBackAsTheyWere) {
  expect_round_trips<robots::Scara>();
  expect_round_trips<FourJoints>();
  expect_round_trips<robots::Panda>();
}

}  // namespace
