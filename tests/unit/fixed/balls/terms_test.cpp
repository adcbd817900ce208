// What a sum's rounding costs against the sums that fixed point really makes: no words exceed the bound of Terms, and
// some come near it, in every arithmetic.
#include <axial/axial.hpp>
#include <axial/fixed.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace {

using namespace axial;

template <class S>
using Word = typename S::Word;

template <class S>
constexpr WordRounding rounding{S::bits, S::nearest, S::high_word, 0.0};

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
// Constants that a word of their own holds 0.45 of a unit short, whatever the sum's exponent; to the second the word
// gives an exponent less than its top bit has room for, or it would round up to one bit more.
template <class S>
constexpr double awkward = (detail::power_of_two(S::bits - 2) + 12345.45) * detail::power_of_two(-S::bits - 10);
template <class S>
constexpr double almost_a_bit_more = (detail::power_of_two(S::bits - 2) - 0.45) * detail::power_of_two(-S::bits - 10);
template <class S, std::uint64_t bits, int e>
void expect_near_a_short_literal(double constant, double least) {
  constexpr int f = 1;
  bounds::Terms terms;
  terms.add_scaled(constant, f, reach<f, S>(0));
  const auto draw = [constant](std::mt19937_64& random) {
    const auto raw = static_cast<Word<S>>(S::capacity - static_cast<double>(random() % 400));  // near the end of words
    const Fx<f, S> a{random() % 2 == 0 ? raw : static_cast<Word<S>>(-raw)};
    return Drawn{value(round_to<e>(Literal<bits, S>{} * a)), static_cast<long double>(constant) * value(a)};
  };
  expect_near(nearest(terms.rounding(e, rounding<S>), draw), least);
}
TYPED_TEST(Sums, OfALiteralThatItsWordHoldsShort) {
  using S = TypeParam;
  expect_near_a_short_literal<S, detail::bits_of(awkward<S>), 11>(awkward<S>, 0.9);
  expect_near_a_short_literal<S, detail::bits_of(almost_a_bit_more<S>), 12>(almost_a_bit_more<S>, 0.6);
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
  bounds::Terms turned = second, fine;
  first.add(second), fill(fine, 0), turned.add(fine);
  for (const int exponent : {2, 8, 14, 20, 30})
    for (const bounds::Terms* sum : {&first, &turned})
      EXPECT_NEAR(sum->rounding(exponent, rounding<TypeParam>), whole.rounding(exponent, rounding<TypeParam>),
                  1e-12 * whole.rounding(exponent, rounding<TypeParam>));
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

namespace {

// A link of words, which rounds every sum into exponent e, and what that costs on bounds.
template <int e>
struct WordLink {
  template <class Q, class... X>
  auto sum(Q, const X&... x) const {
    return round_to<e>(detail::lazy_sum(x...));
  }
};
template <class S, int e>
struct RoundingLink {
  template <class Q>
  bounds::BoundedVector sum(Q, const bounds::VectorSum& v) const {
    const Ball across{0.0, v.across.rounding(e, rounding<S>)}, along{0.0, v.along.rounding(e, rounding<S>)};
    return {{across, along, {}}, e, false, nullptr};
  }
  template <class Q>
  void leave_room(Q, double) const {}
};
template <class S>
bounds::BoundedVector reaching(int exponent, int spare) {
  const Ball any{std::ldexp(1.0, S::bits - 1 - spare - exponent), 0.0};
  return {{any, any, any}, exponent, false, nullptr};
}
template <int E, class S>
Vec3<Fx<E, S>> vector(std::mt19937_64& random, int spare) {
  return {word<E, S>(random, spare), word<E, S>(random, spare), word<E, S>(random, spare)};
}
template <int E, class S>
Vec3<double> values(const Vec3<Fx<E, S>>& v) {
  return {static_cast<double>(value(v.x)), static_cast<double>(value(v.y)), static_cast<double>(value(v.z))};
}

// The forces that two rates give a body of words, at the exponent of upper words of their products. `pick` takes the
// component that is looked at.
template <class S, class Kind>
constexpr int force_exponent = S::bits / 2 - (std::is_same_v<Kind, Revolute> ? 2 : 3);
template <class S, class Kind, class Pick>
double nearest_force(double bound, Pick pick) {
  constexpr int unit = S::bits - 2, j = S::bits / 2, e = force_exponent<S, Kind>, spare = 6;
  return nearest(bound, [&pick](std::mt19937_64& random) {
    const auto w = vector<unit, S>(random, 2);
    const auto h = vector<j, S>(random, spare), a = vector<j, S>(random, spare), b = vector<j, S>(random, spare);
    const RigidInertia body{word<j, S>(random, spare), h, Sym3{a.x, a.y, a.z, b.x, b.y, b.z}};
    const auto to = [](const auto& x) { return static_cast<double>(value(x)); };
    const RigidInertia plain{to(body.mass), values(h),
                             Sym3<double>{to(a.x), to(a.y), to(a.z), to(b.x), to(b.y), to(b.z)}};
    const auto exact = separation::product_force(Kind{}, Plain{}, plain, values(w));
    const auto words = separation::product_force(Kind{}, WordLink<e>{}, body, w);
    return Drawn{value(pick(words)), static_cast<long double>(pick(exact))};
  });
}

}  // namespace

TYPED_TEST(Sums, OfTheForcesOfTwoRates) {
  using S = TypeParam;
  constexpr int unit = S::bits - 2, j = S::bits / 2;
  const bounds::CompositeBody body{bounds::word_of(reaching<S>(j, 6).bound.whole, j),
                                   reaching<S>(j, 6),
                                   bounds::word_of(reaching<S>(j, 6).bound.whole, j),
                                   {}};
  const auto turning =
      product_force(Revolute{}, RoundingLink<S, force_exponent<S, Revolute>>{}, body, reaching<S>(unit, 2));
  const auto moment_x = [](const auto& f) { return f.moment.x; };
  const auto moment_z = [](const auto& f) { return f.moment.z; };
  const auto force_x = [](const auto& f) { return f.force.x; };
  const auto force_z = [](const auto& f) { return f.force.z; };
  expect_near(nearest_force<S, Revolute>(turning.moment.bound.across.error, moment_x), 0.6);  // two of one sign
  expect_near(nearest_force<S, Revolute>(turning.force.bound.across.error, force_x), 0.7);
  expect_near(nearest_force<S, Revolute>(turning.force.bound.along.error, force_z), 0.7);
  bounds::BoundedVector axis = reaching<S>(unit, 2);
  axis.bound.across = {};
  EXPECT_GT(product_force(Revolute{}, RoundingLink<S, 0>{}, body, axis).moment.bound.across.error, 0.0);
  const auto sliding =
      product_force(Prismatic{}, RoundingLink<S, force_exponent<S, Prismatic>>{}, body, reaching<S>(unit, 2));
  expect_near(nearest_force<S, Prismatic>(sliding.moment.bound.across.error, moment_x), 0.7);
  expect_near(nearest_force<S, Prismatic>(sliding.moment.bound.along.error, moment_z), 0.7);
  expect_near(nearest_force<S, Prismatic>(sliding.force.bound.across.error, force_x), 0.7);
}
TYPED_TEST(Sums, OfTheProductOfTwoVectors) {
  using S = TypeParam;
  constexpr int unit = S::bits - 2, j = S::bits / 2, e = j - 2;
  const auto terms = dot(reaching<S>(unit, 3), reaching<S>(j, 3)).terms;
  expect_near(nearest(terms.rounding(e, rounding<S>),
                      [](std::mt19937_64& random) {
                        const auto u = vector<unit, S>(random, 3);
                        const auto v = vector<j, S>(random, 3);
                        const auto a = values(u), b = values(v);
                        const long double exact = 1.0L * a.x * b.x + 1.0L * a.y * b.y + 1.0L * a.z * b.z;
                        return Drawn{value(round_to<e>(dot(u, v))), exact};
                      }),
              0.7);
}
// A direction of the model is the literal factor of each product.
TYPED_TEST(Sums, OfAConstantVectorAndAVector) {
  using S = TypeParam;
  constexpr int e = S::bits / 2;
  bounds::BoundedVector constant{{{0.75, 0.0}, {0.75, 0.0}, {0.8, 0.0}}, S::bits - 2, true, nullptr};
  const auto v = reaching<S>(e, 3);
  const double bound = dot(constant, v).terms.rounding(e, rounding<S>);
  EXPECT_EQ(bound, dot(v, constant).terms.rounding(e, rounding<S>));
  expect_near(nearest(bound,
                      [](std::mt19937_64& random) {
                        const auto x = vector<e, S>(random, 3);
                        const Vec3 literal{Coarse<S>{}, Third<S>{}, Below<S>{}};
                        const long double exact = static_cast<long double>(coarse) * value(x.x) +
                                                  static_cast<long double>(third) * value(x.y) +
                                                  static_cast<long double>(below) * value(x.z);
                        return Drawn{value(round_to<e>(dot(literal, x))), exact};
                      }),
              0.3);
}
