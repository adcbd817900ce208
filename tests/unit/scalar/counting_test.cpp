#include <gtest/gtest.h>
#include <axial/scalar/counting.hpp>

using namespace axial;

namespace {
template <class Formula>
Operations cost(const Formula& formula) {
  static Trace trace;
  trace = Trace{};
  formula(Counting(trace), Counting(trace), Counting::constant(0.3));
  return trace.operations();
}
}  // namespace

TEST(Counting, CountsEveryKind) {
  const auto total = cost([](Counting x, Counting y, Counting k) { (x * y + k * x - y / x).need(); });
  EXPECT_EQ(total, (Operations{2, 2, 1, 0}));
}

TEST(Counting, ConstantsAreOffLine) {
  const auto total = cost([](Counting x, Counting, Counting k) { (x * (k * k + k)).need(); });
  EXPECT_EQ(total, (Operations{1, 0, 0, 0}));
}

TEST(Counting, EqualExpressionsCountOnce) {
  const auto total = cost([](Counting x, Counting y, Counting) { (x * y).need(), (x * y + x).need(); });
  EXPECT_EQ(total, (Operations{1, 1, 0, 0}));
}

TEST(Counting, DifferentConstantsAreDifferent) {
  const auto total =
      cost([](Counting x, Counting, Counting k) { (x * k).need(), (x * Counting::constant(0.7)).need(); });
  EXPECT_EQ(total.mul, 2);
}

TEST(Counting, UnneededOperationsDoNotCount) {
  const auto total = cost([](Counting x, Counting y, Counting) {
    const Counting unused = x * y * y;
    static_cast<void>(unused);
    (x + y).need();
  });
  EXPECT_EQ(total, (Operations{0, 1, 0, 0}));
}

TEST(Counting, ASineCosinePairCountsOnce) {
  const auto total = cost([](Counting x, Counting y, Counting) {
    const auto p = sincos(x);
    const auto q = sincos(y);
    (p.sin * p.cos).need(), q.sin.need();
  });
  EXPECT_EQ(total, (Operations{1, 0, 0, 2}));
}

TEST(Counting, RunsInConstantExpressions) {
  constexpr auto total = [] {
    Trace trace;
    const Counting x(trace), y(trace);
    (x * y + x).need();
    return trace.operations();
  }();
  static_assert(total.mul == 1 && total.add == 1);
}
