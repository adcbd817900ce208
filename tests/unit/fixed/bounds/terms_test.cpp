// What a sum's rounding costs against the sums that fixed point really makes: no words exceed the bound of Terms, and
// some come near it, in every arithmetic.
#include <axial/axial.hpp>
#include <axial/fixed/bounds/number.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace {

using namespace axial;

template <class S>
using Word = typename S::Word;

template <class S>
constexpr Rounding rounding{S::bits, S::nearest, S::high_word, 0.0};

// A word's value, beyond any rounding of the sums below.
template <int E, class S>
long double value(const Fx<E, S>& x) {
  return std::ldexp(static_cast<long double>(x.raw), -E);
}

// A word of at most 2^(bits - 1 - spare), half of the time at an end.
template <int E, class S>
Fx<E, S> word(std::mt19937_64& random, int spare) {
  const double most = std::ldexp(1.0, S::bits - 1 - spare) - 1.0;
  const double x = std::uniform_real_distribution<double>(-1.6, 1.6)(random);
  return {static_cast<Word<S>>(std::lrint(std::fmax(-1.0, std::fmin(1.0, x)) * most))};
}
template <int E, class S>
double reach(int spare) {
  return std::ldexp(1.0, S::bits - 1 - spare - E);
}

constexpr double third = 1.0 / 3.0, below = 0.2613, coarse = 0.70000001, small = 3.1e-5;
template <class S>
using Third = Literal<detail::bits_of(third), S>;
template <class S>
using Below = Literal<detail::bits_of(below), S>;  // rounded down, too
template <class S>
using Coarse = Literal<detail::bits_of(coarse), S>;
template <class S>
using Small = Literal<detail::bits_of(small), S>;

// The largest error of `draw(random) -> {computed, exact}`, in units of the bound.
template <class Draw>
double nearest(double bound, const Draw& draw) {
  std::mt19937_64 random(20261123);
  long double worst = 0.0L;
  for (int k = 0; k < 40000; ++k) {
    const auto [computed, exact] = draw(random);
    worst = std::fmax(worst, std::fabs(computed - exact));
  }
  EXPECT_GT(bound, 0.0);
  return static_cast<double>(worst / bound);
}
struct Drawn {
  long double computed, exact;
};
void expect_near(double nearness, double least) {
  EXPECT_LE(nearness, 1.0 + 1e-9);
  EXPECT_GE(nearness, least);
}

template <class S>
class Sums : public testing::Test {};
using Arithmetics = testing::Types<Arithmetic<std::int32_t, true, false>, Arithmetic<std::int32_t, false, false>,
                                   Arithmetic<std::int32_t, true, true>, Arithmetic<std::int32_t, false, true>,
                                   Arithmetic<std::int16_t, true, false>, Arithmetic<std::int16_t, false, false>,
                                   Arithmetic<std::int16_t, true, true>, Arithmetic<std::int16_t, false, true>>;
TYPED_TEST_SUITE(Sums, Arithmetics);

}  // namespace

TYPED_TEST(Sums, OfWordsRoundEachThatIsFiner) {
  using S = TypeParam;
  bounds::Terms terms;
  terms.add_word(9), terms.add_word(12), terms.add_word(5);
  expect_near(nearest(terms.rounding(6, rounding<S>),
                      [](std::mt19937_64& random) {
                        const auto a = word<9, S>(random, 3);
                        const auto b = word<12, S>(random, 3);
                        const auto c = word<5, S>(random, 6);
                        return Drawn{value(round_to<6>(a + b + c)), value(a) + value(b) + value(c)};
                      }),
              0.9);
}
TYPED_TEST(Sums, OfAWordOfTheSameFormatRoundNothing) {
  bounds::Terms terms;
  terms.add_word(9);
  EXPECT_EQ(terms.rounding(9, rounding<TypeParam>), 0.0);
  EXPECT_EQ(terms.rounding(11, rounding<TypeParam>), 0.0);
}
TYPED_TEST(Sums, OfALiteralAndAWord) {
  using S = TypeParam;
  bounds::Terms terms;
  terms.add_literal(), terms.add_word(10);
  expect_near(nearest(terms.rounding(7, rounding<S>),
                      [](std::mt19937_64& random) {
                        const auto a = word<10, S>(random, 2);
                        return Drawn{value(round_to<7>(Below<S>{} + a)), below + value(a)};
                      }),
              0.7);
}
TYPED_TEST(Sums, OfProductsOfWords) {
  using S = TypeParam;
  constexpr int unit = S::bits - 2, e = S::bits / 2;
  bounds::Terms terms;
  terms.add_product(unit + e), terms.add_product(unit + e - 1);
  expect_near(nearest(terms.rounding(e, rounding<S>),
                      [](std::mt19937_64& random) {
                        const auto a = word<unit, S>(random, 2), c = word<unit, S>(random, 2);
                        const auto b = word<e, S>(random, 2);
                        const auto d = word<e - 1, S>(random, 3);
                        return Drawn{value(round_to<e>(a * b + c * d)), value(a) * value(b) + value(c) * value(d)};
                      }),
              0.45);
}
TYPED_TEST(Sums, OfProductsFinerThanADoubleWord) {
  using S = TypeParam;
  constexpr int unit = S::bits - 2;
  bounds::Terms terms;
  terms.add_product(2 * unit), terms.add_product(2 * unit), terms.add_word(3);
  const double bound = terms.rounding(1, rounding<S>);
  expect_near(nearest(bound,
                      [](std::mt19937_64& random) {
                        const auto a = word<unit, S>(random, 0), b = word<unit, S>(random, 0);
                        const auto c = word<3, S>(random, 3);
                        return Drawn{value(round_to<1>(a * b + a * b + c)), 2.0L * value(a) * value(b) + value(c)};
                      }),
              S::high_word ? 0.2 : 0.9);
}
TYPED_TEST(Sums, OfLiteralsTimesWordsThatFillTheDoubleWord) {
  using S = TypeParam;
  constexpr int e = S::bits / 2;
  bounds::Terms terms;
  terms.add_scaled(third, e, reach<e, S>(1)), terms.add_scaled(coarse, e, reach<e, S>(1));
  expect_near(nearest(terms.rounding(e, rounding<S>),
                      [](std::mt19937_64& random) {
                        const auto a = word<e, S>(random, 1), b = word<e, S>(random, 1);
                        return Drawn{
                            value(round_to<e>(Third<S>{} * a + Coarse<S>{} * b)),
                            static_cast<long double>(third) * value(a) + static_cast<long double>(coarse) * value(b)};
                      }),
              0.45);
}
// Behind a coarse result a literal has a word's bits of its own and no more: its rounding is what counts.
TYPED_TEST(Sums, OfALiteralWhoseOwnRoundingCounts) {
  using S = TypeParam;
  constexpr int e = 2;
  bounds::Terms terms;
  terms.add_scaled(small, e, reach<e, S>(0)), terms.add_word(e + 12);
  expect_near(nearest(terms.rounding(e + 10, rounding<S>),
                      [](std::mt19937_64& random) {
                        const auto a = word<e, S>(random, 0);
                        const auto b = word<e + 12, S>(random, 0);
                        return Drawn{value(round_to<e + 10>(Small<S>{} * a + b)),
                                     static_cast<long double>(small) * value(a) + value(b)};
                      }),
              0.2);
}
// A constant that a word of its own holds 0.45 of a unit short, whatever the sum's exponent.
template <class S>
constexpr double awkward = (detail::power_of_two(S::bits - 2) + 12345.45) * detail::power_of_two(-S::bits - 10);
template <class S>
using Awkward = Literal<detail::bits_of(awkward<S>), S>;
TYPED_TEST(Sums, OfALiteralThatItsWordHoldsShort) {
  using S = TypeParam;
  constexpr int f = 1, e = f + 10;
  bounds::Terms terms;
  terms.add_scaled(awkward<S>, f, reach<f, S>(0));
  const auto draw = [](std::mt19937_64& random) {
    const auto raw = static_cast<Word<S>>(S::capacity - static_cast<double>(random() % 400));  // near the end of words
    const Fx<f, S> a{random() % 2 == 0 ? raw : static_cast<Word<S>>(-raw)};
    return Drawn{value(round_to<e>(Awkward<S>{} * a)), static_cast<long double>(awkward<S>) * value(a)};
  };
  expect_near(nearest(terms.rounding(e, rounding<S>), draw), 0.9);
}
TYPED_TEST(Sums, OfProductsOfOneExponent) {
  using S = TypeParam;
  constexpr int unit = S::bits - 2, e = S::bits / 2;
  bounds::Terms terms;
  terms.add_product(unit + e), terms.add_product(unit + e);
  expect_near(nearest(terms.rounding(e, rounding<S>),
                      [](std::mt19937_64& random) {
                        const auto a = word<unit, S>(random, 2), c = word<unit, S>(random, 2);
                        const auto b = word<e, S>(random, 2), d = word<e, S>(random, 2);
                        return Drawn{value(round_to<e>(a * b + c * d)), value(a) * value(b) + value(c) * value(d)};
                      }),
              0.9);
}
// Products and words meet at the coarsest product's exponent, which may be coarser than the result's.
TYPED_TEST(Sums, OfFineTermsBesideACoarseProduct) {
  using S = TypeParam;
  if (S::high_word) return;
  constexpr int half = S::bits / 2;
  bounds::Terms products, words;
  products.add_product(3), products.add_product(12);
  words.add_product(3), words.add_word(9);
  expect_near(nearest(products.rounding(6, rounding<S>),
                      [](std::mt19937_64& random) {
                        const auto a = word<1, S>(random, half + 3), b = word<2, S>(random, half + 3);
                        const auto c = word<6, S>(random, half), d = word<6, S>(random, half);
                        return Drawn{value(round_to<6>(a * b + c * d)), value(a) * value(b) + value(c) * value(d)};
                      }),
              0.45);
  expect_near(nearest(words.rounding(6, rounding<S>),
                      [](std::mt19937_64& random) {
                        const auto a = word<1, S>(random, half + 3), b = word<2, S>(random, half + 3);
                        const auto c = word<9, S>(random, 2);
                        return Drawn{value(round_to<6>(a * b + c)), value(a) * value(b) + value(c)};
                      }),
              0.9);
}
// However its terms come together, a sum rounds the same.
TYPED_TEST(Sums, RoundWhatTheirHalvesHave) {
  bounds::Terms whole, first, second;
  const auto fill = [](bounds::Terms& terms, int k) {
    terms.add_word(9 + k), terms.add_literal(), terms.add_product(40 - k),
        terms.add_scaled(third / (1.0 + 7.0 * k), 6 + k, 3.0 + k);
  };
  fill(whole, 0), fill(whole, 3), fill(first, 0), fill(second, 3);
  first.add(second);
  for (const int exponent : {2, 8, 14, 20, 30})
    EXPECT_EQ(first.rounding(exponent, rounding<TypeParam>), whole.rounding(exponent, rounding<TypeParam>));
}
TYPED_TEST(Sums, ThatVanishRoundNothing) {
  const bounds::Number zero = bounds::word_of({0.0, 0.0}, 9);
  bounds::Terms terms;
  bounds::add_product(terms, zero, 5, 1.0), bounds::add_product(terms, bounds::literal_of(0.0), 5, 1.0);
  bounds::add_product(terms, bounds::literal_of(0.3), 5, 0.0);
  EXPECT_EQ(terms.rounding(2, rounding<TypeParam>), 0.0);
}
TYPED_TEST(Sums, OfALiteralOneAndAWordAreWords) {
  bounds::Terms terms;
  bounds::add_product(terms, bounds::literal_of(-1.0), 9, 1.0);
  EXPECT_EQ(terms.rounding(9, rounding<TypeParam>), 0.0);
  EXPECT_GT(terms.rounding(8, rounding<TypeParam>), 0.0);
}
