#include <gtest/gtest.h>
#include <axial/scalar/counting.hpp>
#include <axial/scalar/structural.hpp>

using namespace axial;

namespace {
template <class Expected, class T>
constexpr bool has_type(const T&) {
  return std::is_same_v<Expected, T>;
}
}  // namespace

TEST(Structural, ZeroAbsorbsAndDisappears) {
  static_assert(has_type<Zero>(Zero{} * 3.0F) && has_type<Zero>(3.0F * Zero{}));
  static_assert(has_type<float>(Zero{} + 3.0F) && (Zero{} + 3.0F) == 3.0F);
  static_assert((3.0F - Zero{}) == 3.0F && (Zero{} - 3.0F) == -3.0F);
  static_assert(has_type<Zero>(Zero{} * One{}) && has_type<Zero>(One{} - One{}));
}

TEST(Structural, OneAndMinusOneCostNoMultiplication) {
  static_assert((One{} * 3.0) == 3.0 && (MinusOne{} * 3.0) == -3.0);
  static_assert(has_type<MinusOne>(MinusOne{} * One{}) && has_type<One>(MinusOne{} * MinusOne{}));
  static Trace trace;
  (One{} * Counting(trace)).need(), (MinusOne{} * Counting(trace)).need(), (Zero{} + Counting(trace)).need();
  EXPECT_EQ(trace.operations(), (Operations{0, 0, 0, 0}));
}

TEST(Structural, IntegersBeyondOneBecomeConstants) {
  static_assert(has_type<Int<2>>(One{} + One{}) && (Int<2>{} * 1.5) == 3.0 && (Int<3>{} * 1.5) == 4.5);
  static_assert((One{} + 0.5) == 1.5 && (One{} - 0.25) == 0.75 && (0.5 - One{}) == -0.5);
}

TEST(Structural, LiteralsFindTheirType) {
  static_assert(has_type<Zero>(literal<float>([] { return 0.0; })) &&
                has_type<Zero>(literal<float>([] { return -0.0; })));
  static_assert(has_type<One>(literal<float>([] { return 1.0; })) &&
                has_type<MinusOne>(literal<float>([] { return -1.0; })));
  static_assert(has_type<float>(literal<float>([] { return 0.5; })));
}
