// The operators of balls against what they bound: members of the operands, drawn inside them and at their ends, with
// the errors that they may have. None leaves the bound of the result, and some come near it.
#include <axial/axial.hpp>
#include <axial/fixed.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace {

using namespace axial;
using bounds::BoundedVector;
using bounds::ConstantInertia;
using bounds::ConstantVector;
using bounds::Number;

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

constexpr int draws = 20000;
constexpr double rounding_here = 1e-12;  // of these formulas in double, relative
constexpr double near = 0.97;            // of a bound that members reach: a looser one is a change

Vector operator+(const Vector& u, const Vector& v) { return {u[0] + v[0], u[1] + v[1], u[2] + v[2]}; }
Vector operator-(const Vector& u, const Vector& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }
Vector operator*(double c, const Vector& v) { return {c * v[0], c * v[1], c * v[2]}; }
double inner(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
Vector outer(const Vector& u, const Vector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
Vector times(const Matrix& m, const Vector& v) { return {inner(m[0], v), inner(m[1], v), inner(m[2], v)}; }
double norm(const Vector& v) { return std::sqrt(inner(v, v)); }
double across(const Vector& v) { return std::hypot(v[0], v[1]); }

class Draw {
 public:
  /// In [-1, 1], at an end every other time.
  double share() {
    const double x = std::uniform_real_distribution<double>(-2.0, 2.0)(random_);
    return std::fmax(-1.0, std::fmin(1.0, x));
  }
  double angle() { return std::uniform_real_distribution<double>(0.0, 6.283185307179586)(random_); }
  double size() { return std::exp2(std::uniform_real_distribution<double>(-3.0, 3.0)(random_)); }
  /// A vector of at most these parts, some along the axes.
  Vector vector(double across, double along, double whole) {
    const double a = random_() % 3 == 0 ? 1.5707963267948966 * static_cast<double>(random_() % 4) : angle();
    const double part = share() * across;
    const Vector v{part * std::cos(a), part * std::sin(a), share() * along};
    return norm(v) > whole ? (whole / norm(v)) * v : v;
  }
  Ball ball() { return {size(), 0.25 * size()}; }
  SplitBall split_ball() {
    SplitBall b{ball(), ball(), {}};
    b.whole = {size() + 1.0, 0.25 * size() + 0.25};
    return detail::tightened(b);
  }

 private:
  std::mt19937_64 random_{20261129};
};

/// An exact value and a computed one.
template <class Value>
struct Pair {
  Value exact{}, computed{};
};
Pair<double> member(Draw& draw, const Ball& b) {
  const double x = draw.share() * b.size;
  return {x, x + draw.share() * b.error};
}
Pair<Vector> member(Draw& draw, const SplitBall& b) {
  const Vector v = draw.vector(b.across.size, b.along.size, b.whole.size);
  return {v, v + draw.vector(b.across.error, b.along.error, b.whole.error)};
}

/// How near members come to a bound: 1 is at it.
struct Nearness {
  double size = 0.0, error = 0.0;

  void see(double of_size, double of_error, const Ball& bound) {
    size = std::max(size, bound.size > 0.0 ? of_size / bound.size : of_size > rounding_here ? 2.0 : 0.0);
    error = std::max(error, bound.error > 0.0 ? of_error / bound.error : of_error > rounding_here ? 2.0 : 0.0);
  }
};
struct Nearnesses {
  Nearness across, along, whole;

  void see(const Pair<Vector>& v, const SplitBall& bound) {
    const Vector error = v.computed - v.exact;
    across.see(::across(v.exact), ::across(error), bound.across);
    along.see(std::fabs(v.exact[2]), std::fabs(error[2]), bound.along);
    whole.see(norm(v.exact), norm(error), bound.whole);
  }
};
void expect_near(double nearness, double least) {
  EXPECT_LE(nearness, 1.0 + rounding_here);
  EXPECT_GE(nearness, least);
}
void expect_near(const Nearness& n, double least) {
  expect_near(n.size, least);
  expect_near(n.error, least);
}
void expect_near(const Nearnesses& n, double least) {
  expect_near(n.across, least);
  expect_near(n.along, least);
  expect_near(n.whole, least);
}

BoundedVector words(const SplitBall& b) { return {b, 20, false, nullptr}; }
Number word(const Ball& b) { return bounds::word_of(b, 20); }

TEST(Balls, HoldSumsAndProducts) {
  Draw draw;
  Nearness sum, product, multiple;
  for (int k = 0; k < draws; ++k) {
    const Ball a = draw.ball(), b = draw.ball();
    const auto x = member(draw, a), y = member(draw, b);
    const double c = draw.share() * 3.0;
    sum.see(std::fabs(x.exact + y.exact), std::fabs(x.computed + y.computed - x.exact - y.exact), a + b);
    product.see(std::fabs(x.exact * y.exact), std::fabs(x.computed * y.computed - x.exact * y.exact), a * b);
    multiple.see(std::fabs(c * x.exact), std::fabs(c * x.computed - c * x.exact), c * a);
    EXPECT_LE(std::fabs(x.computed), a.largest() * (1.0 + rounding_here));
  }
  expect_near(sum, near);
  expect_near(product, near);
  expect_near(multiple, near);
}

TEST(Balls, RootsAreFromAboveAndNear) {
  Draw draw;
  for (int k = 0; k < draws; ++k) {
    const double x = draw.size() * draw.size() * draw.size(), y = draw.size();
    EXPECT_GE(detail::root_bound(x), std::sqrt(x));
    EXPECT_LE(detail::root_bound(x), std::sqrt(x) * (1.0 + 2e-12));
    EXPECT_GE(detail::hypotenuse(x, -y), std::hypot(x, y));
    EXPECT_LE(detail::hypotenuse(-x, y), std::hypot(x, y) * (1.0 + 2e-12));
  }
  EXPECT_EQ(detail::hypotenuse(-3.0, 0.0), 3.0);
  EXPECT_EQ(detail::hypotenuse(0.0, -3.0), 3.0);
  EXPECT_EQ(detail::root_bound(0.0), 0.0);
}

// Words hold what reaches `size`, and what rounding adds to that; with one bit more they would not.
TEST(Balls, FormatsLeaveRoomForRoundings) {
  std::mt19937_64 random{20261129};
  for (const int bits : {16, 32})
    for (int k = 0; k < draws; ++k) {
      const WordRounding r{bits, true, false, 0.0};
      const double share = std::uniform_real_distribution<double>(-1.0, 1.0)(random);
      const double border = std::ldexp(r.capacity(), static_cast<int>(random() % 40) - 40);
      const double size = border * (1.0 + 600.0 * share / std::ldexp(1.0, bits - 1));  // near where formats change
      const int exponent = r.exponent(size);
      EXPECT_LE(std::ldexp(size, exponent) * (1.0 + 255.0 / std::ldexp(1.0, bits - 1)), r.capacity());
      EXPECT_GT(std::ldexp(size, exponent + 1) * (1.0 + 257.0 / std::ldexp(1.0, bits - 1)), r.capacity());
    }
}

TEST(Balls, TheLargestRowIsTheLargest) {
  Draw draw;
  for (int k = 0; k < draws; ++k) {
    std::array<double, 6> e{};
    for (double& x : e)
      x = 4.0 * draw.share();
    const Matrix m{{{e[0], e[3], e[4]}, {e[3], e[1], e[5]}, {e[4], e[5], e[2]}}};
    double most = 0.0;
    for (const Vector& row : m)
      most = std::max(most, std::fabs(row[0]) + std::fabs(row[1]) + std::fabs(row[2]));
    EXPECT_NEAR(detail::largest_row({e[0], e[1], e[2], e[3], e[4], e[5]}), most, 1e-14);
    const Vector v = draw.vector(1.0, 1.0, 1.0);
    EXPECT_LE(norm(times(m, v)), most * (1.0 + rounding_here));
  }
}

TEST(SplitBalls, BoundTheirPartsByEachOther) {
  const SplitBall v = detail::tightened({{3.0, 0.3}, {4.0, 0.4}, {9.0, 0.1}});
  EXPECT_NEAR(v.whole.size, 5.0, 1e-12);
  EXPECT_EQ(v.whole.error, 0.1);
  EXPECT_EQ(v.across.size, 3.0);
  EXPECT_EQ(v.across.error, 0.1);
  EXPECT_EQ(v.along.error, 0.1);
}

TEST(SplitBalls, HoldSumsAndMultiples) {
  Draw draw;
  Nearnesses sum, multiple, waiting;
  for (int k = 0; k < draws; ++k) {
    const SplitBall a = draw.split_ball(), b = draw.split_ball();
    const auto u = member(draw, a), v = member(draw, b);
    const double c = 3.0 * draw.share();
    sum.see({u.exact + v.exact, u.computed + v.computed}, a + b);
    multiple.see({c * u.exact, c * u.computed}, c * a);
    waiting.see({u.exact + v.exact, u.computed + v.computed},
                (bounds::vector_of(words(a)) + bounds::vector_of(words(b))).bound);
  }
  expect_near(sum, near);
  expect_near(multiple, near);
  expect_near(waiting, near);
}

TEST(SplitBalls, HoldRoundings) {
  Draw draw;
  Nearnesses alike, apart;
  for (int k = 0; k < draws; ++k) {
    const SplitBall a = draw.split_ball();
    const auto u = member(draw, a);
    const double step = 0.25 * draw.size(), other = 0.25 * draw.size();
    const Vector off{step * draw.share(), step * draw.share(), step * draw.share()};
    alike.see({u.exact, u.computed + off}, rounded(a, step));
    apart.see({u.exact, u.computed + draw.vector(step, other, 10.0)}, bounds::detail::with_rounding(a, step, other));
  }
  expect_near(alike, near);
  expect_near(apart, near);
}

TEST(SplitBalls, HoldWhatTurnsAboutX) {
  Draw draw;
  Nearnesses turned;
  for (int k = 0; k < draws; ++k) {
    const SplitBall a = draw.split_ball();
    const auto u = member(draw, a);
    const double q = draw.angle(), s = std::sin(q), c = std::cos(q);
    const auto turn = [s, c](const Vector& v) { return Vector{v[0], c * v[1] - s * v[2], s * v[1] + c * v[2]}; };
    turned.see({turn(u.exact), turn(u.computed)}, turned_about_x(a, s, c));
  }
  expect_near(turned, near);
}

TEST(BoundedVectors, HoldProductsOfVectors) {
  Draw draw;
  Nearnesses crossed, shifted, scaled, by_z;
  Nearness dotted, axial, part;
  for (int k = 0; k < draws; ++k) {
    const SplitBall a = draw.split_ball(), b = draw.split_ball();
    const Ball f = draw.ball();
    const auto u = member(draw, a), v = member(draw, b);
    const auto x = member(draw, f);
    const auto error = [](double exact, double computed) { return std::fabs(computed - exact); };
    crossed.see({outer(u.exact, v.exact), outer(u.computed, v.computed)}, bounds::cross(words(a), words(b)).bound);
    const auto along_x = [](double p, const Vector& w) { return outer({p, 0.0, 0.0}, w); };
    shifted.see({along_x(x.exact, u.exact), along_x(x.computed, u.computed)},
                bounds::detail::shifted(XAxis{}, word(f), words(a)).bound);
    scaled.see({x.exact * u.exact, x.computed * u.computed}, (word(f) * words(a)).bound);
    const auto times_z = [](const Vector& w, double s) { return outer(w, {0.0, 0.0, s}); };
    by_z.see({times_z(u.exact, x.exact), times_z(u.computed, x.computed)}, bounds::cross_z(words(a), word(f)).bound);
    dotted.see(std::fabs(inner(u.exact, v.exact)), error(inner(u.exact, v.exact), inner(u.computed, v.computed)),
               bounds::dot(words(a), words(b)).bound);
    const double exact = outer(v.exact, u.exact)[2], computed = outer(v.computed, u.computed)[2];
    axial.see(std::fabs(exact), error(exact, computed), bounds::axial_product(words(a), words(b)).bound);
    part.see(std::fabs(u.exact[2]), error(u.exact[2], u.computed[2]), bounds::axial_part(words(a)).bound);
  }
  expect_near(crossed, near);
  expect_near(shifted, near);
  expect_near(scaled, near);
  expect_near(by_z.across, near);
  EXPECT_EQ(by_z.along.size + by_z.along.error, 0.0);
  expect_near(dotted, near);
  expect_near(axial, near);
  expect_near(part, near);
}

/// U = dw~ + w~ w~ times r.
Vector accelerated(const Vector& w, const Vector& dw, const Vector& r) { return outer(dw, r) + outer(w, outer(w, r)); }

bounds::Spin spin_of(const SplitBall& w, const SplitBall& dw, double entry) {
  return {w, dw, entry, rounded(bounds::detail::axis_of(w, dw), entry), false, 20, nullptr};
}

TEST(Spins, AccelerateNoPointMore) {
  Draw draw;
  Nearnesses sideways, upwards, either;
  Nearness whole;
  for (int k = 0; k < draws; ++k) {
    SplitBall w = draw.split_ball(), dw = draw.split_ball();
    w.across.error = w.along.error = w.whole.error = 0.0;  // which the third column has from its words
    dw.across.error = dw.along.error = dw.whole.error = 0.0;
    const double entry = k % 2 == 0 ? 0.0 : 0.25 * draw.size(), side = draw.size(), height = draw.size();
    const bounds::Spin u = spin_of(w, dw, entry);
    const Vector rate = draw.vector(w.across.size, w.along.size, w.whole.size);
    const Vector growth = draw.vector(dw.across.size, dw.along.size, dw.whole.size);
    Matrix off{};
    for (Vector& row : off)
      for (double& x : row)
        x = entry * draw.share();
    const auto see = [&](Nearnesses& near, const Vector& r, double most_across, double most_along) {
      const Vector exact = accelerated(rate, growth, r);
      near.see({exact, exact + times(off, r)}, u.times(most_across, most_along));
    };
    const double a = draw.angle();
    const Vector flat{side * std::cos(a), side * std::sin(a), 0.0}, upright{0.0, 0.0, height};
    see(sideways, flat, side, 0.0);
    see(upwards, upright, 0.0, height);
    see(either, flat + upright, side, height);
    const Vector r = flat + upright, exact = accelerated(rate, growth, r);
    whole.see(norm(exact) / norm(r), norm(times(off, r)) / norm(r), u.strength());
  }
  expect_near(sideways, near);
  expect_near(upwards, near);
  expect_near(either, near);
  expect_near(whole, 0.9);
}

TEST(Spins, AreOffByWhatTheirRatesAre) {
  Draw draw;
  Nearness whole;
  Nearnesses sideways;
  for (int k = 0; k < draws; ++k) {
    const SplitBall w = draw.split_ball(), dw = draw.split_ball();
    const bounds::Spin u = spin_of(w, dw, 0.0);
    const auto rate = member(draw, w), growth = member(draw, dw);
    const double a = draw.angle();
    const Vector r{std::cos(a), std::sin(a), 0.0};
    const Vector exact = accelerated(rate.exact, growth.exact, r),
                 computed = accelerated(rate.computed, growth.computed, r);
    whole.see(norm(exact), norm(computed - exact), u.strength());
    sideways.see({exact, computed}, u.times(1.0, 0.0));
  }
  expect_near(whole, near);
  expect_near(sideways, near);
}

/// A link whose words of U have this exponent.
struct ExponentOfU {
  int of_u;
  constexpr int exponent(quantity::AngularAcceleration) const { return of_u; }
  template <class Quantity>
  constexpr void note(Quantity, const Ball&) const {}
};

// wy wz of words, rounded as U's words are, from the slowest motion to the fastest.
TEST(Spins, RoundTheirProductsHoweverSlow) {
  constexpr WordRounding r{32, true, false, 0.0};
  std::mt19937_64 random{20261129};
  for (int fastest = 8; fastest <= 28; fastest += 2) {
    const double most = std::ldexp(1.0, fastest - 20);
    const BoundedVector w{bounds::detail::split({most, 0.0}, {most, 0.0}), 20, false, &r};
    for (int of_u = 10; of_u <= 26; of_u += 4) {
      const ExponentOfU link{of_u};
      const bounds::Products p = bounds::products(w, link);
      double worst = 0.0;
      for (int k = 0; k < 2000; ++k) {
        std::uniform_int_distribution<std::int64_t> any(-(std::int64_t{1} << fastest), std::int64_t{1} << fastest);
        const std::int64_t product = any(random) * any(random);
        const double exact = std::ldexp(static_cast<double>(product), of_u - 40);
        worst = std::fmax(worst, std::fabs(std::nearbyint(exact) - exact));
      }
      EXPECT_LE(worst, p.rounding / r.ulp(of_u) + 1e-9);
      EXPECT_LE(p.rounding, r.ulp(of_u));
    }
  }
}

// About an axis that keeps its direction nothing is rounded; any that does not has the rounding of its entries.
TEST(Spins, RoundTheThirdColumnOfAnAxisThatMoves) {
  constexpr WordRounding r{32, true, false, 0.0};
  const ExponentOfU link{18};
  for (const double w_across : {0.0, 0.25, 4.0})
    for (const double dw_across : {0.0, 0.25, 4.0}) {
      const BoundedVector w{bounds::detail::split({w_across, 0.0}, {2.0, 0.0}), 20, false, &r};
      const BoundedVector dw{bounds::detail::split({dw_across, 0.0}, {2.0, 0.0}), 18, false, &r};
      const bounds::Spin u = bounds::rotation_acceleration(w, dw, bounds::products(w, link), link);
      EXPECT_GE(u.entry, r.store(18));
      EXPECT_EQ(u.axis.across.error > 0.0, w_across > 0.0 || dw_across > 0.0) << w_across << ' ' << dw_across;
    }
}

TEST(ConstantBodies, AreAsLargeAsTheirEntries) {
  const auto off = [](double value, double error) {
    Number x = bounds::literal_of(value);
    x.bound.error = error;
    return x;
  };
  const ConstantVector h{off(3.0, 0.3), off(-4.0, 0.4), off(12.0, 1.2), {2.0, 0.5}};
  EXPECT_NEAR(h.side(), 5.0, 1e-12);
  EXPECT_EQ(h.height(), 12.0);
  EXPECT_EQ(h.unknown().size, 2.0);
  EXPECT_NEAR(h.unknown().error, 1.8, 1e-12);
  const ConstantInertia j{{off(1.0, 0.1), off(2.0, 0.2), off(3.0, 0.4), off(-0.5, 0.8), off(0.25, 1.6), off(-4.0, 3.2)},
                          {7.0, 6.4}};
  EXPECT_EQ(j.norm(), 7.25);
  EXPECT_NEAR(j.error(), 6.4 + 0.7 + 2.0 * 5.6, 1e-12);
}

TEST(ConstantBodies, HoldTheirCrossProducts) {
  Draw draw;
  Nearnesses crossed;
  for (int k = 0; k < draws; ++k) {
    const Vector h = draw.vector(draw.size(), draw.size(), 20.0);
    const SplitBall a = draw.split_ball();
    const auto v = member(draw, a);
    const Ball loose = k % 2 == 0 ? Ball{} : draw.ball();
    const auto rest = draw.vector(loose.size, loose.size, loose.size);
    const auto error = draw.vector(loose.error, loose.error, loose.error);
    const ConstantVector known{bounds::literal_of(h[0]), bounds::literal_of(h[1]), bounds::literal_of(h[2]), loose};
    crossed.see({outer(h + rest, v.exact), outer(h + rest + error, v.computed)}, bounds::cross(known, words(a)).bound);
  }
  expect_near(crossed, near);
}

TEST(ConstantBodies, HoldTheMomentsThatTurnThem) {
  Draw draw;
  Nearnesses moment;
  for (int k = 0; k < draws; ++k) {
    std::array<double, 6> e{};
    for (double& x : e)
      x = 2.0 * draw.share() * (draw.share() > 0.5 ? 0.0 : 1.0);
    const Matrix m{{{e[0], e[3], e[4]}, {e[3], e[1], e[5]}, {e[4], e[5], e[2]}}};
    const auto literal = [](double x) { return bounds::literal_of(x); };
    const ConstantInertia j{{literal(e[0]), literal(e[1]), literal(e[2]), literal(e[3]), literal(e[4]), literal(e[5])},
                            {}};
    const Vec3<Number> differences{literal(e[2] - e[1]), literal(e[0] - e[2]), literal(e[1] - e[0])};
    const SplitBall w = draw.split_ball(), dw = draw.split_ball();
    const auto rate = member(draw, w), growth = member(draw, dw);
    const auto turned = [&m](const Vector& w, const Vector& dw) { return times(m, dw) + outer(w, times(m, w)); };
    moment.see({turned(rate.exact, growth.exact), turned(rate.computed, growth.computed)},
               bounds::rotational_moment(j, differences, words(w), {}, spin_of(w, dw, 0.0)).bound);
  }
  expect_near(moment, near);
}

TEST(Numbers, OfTheModelStayLiterals) {
  const Number a = bounds::literal_of(-0.75), b = bounds::literal_of(2.0), w = bounds::word_of({3.0, 0.5}, 20);
  EXPECT_EQ((a * b).constant, -1.5);
  EXPECT_EQ((a * b).bound.size, 1.5);
  EXPECT_EQ((a + b).constant, 1.25);
  EXPECT_EQ((a - b).constant, -2.75);
  EXPECT_TRUE((a * b).is_literal && (a - b).is_literal);
  EXPECT_FALSE((a * w).is_literal || (w + a).is_literal || (w - b).is_literal);
  EXPECT_EQ((a * w).bound.size, 2.25);
  EXPECT_EQ((a * w).bound.error, 0.375);
  EXPECT_EQ((w - b).bound.size, 5.0);
  EXPECT_EQ((w - b).bound.error, 0.5);
  EXPECT_EQ(bounds::twice(w).exponent, 19);
  EXPECT_EQ(bounds::twice(w).bound.error, 1.0);
  EXPECT_EQ(bounds::half(a).constant, -0.375);
  EXPECT_EQ(bounds::half(w).exponent, 21);
  EXPECT_FALSE(w.vanishes() || a.vanishes() || bounds::word_of({0.0, 1e-9}, 20).vanishes());
  EXPECT_TRUE(bounds::literal_of(0.0).vanishes());
}

TEST(Numbers, OfAnAngleHaveItsErrors) {
  const WordRounding rounding{32, true, false, 0.25};
  const auto turn = bounds::sincos({&rounding, 0.5});
  EXPECT_EQ(turn.sin.bound.size, 1.0);
  EXPECT_EQ(turn.cos.bound.error, 0.75);
  EXPECT_EQ(turn.sin.exponent, 30);
}

}  // namespace
