// The enclosure of a linear system against its exact solution: whatever approximate inverse it is given, an answer of
// true is a proof.
#include <gtest/gtest.h>
#include <axial/fixed.hpp>
#include <axial/fixed/dynamics/enclosure.hpp>
#include <cmath>
#include <host_sim/figures/exhaustive/fixed_states.hpp>
#include <limits>

using namespace axial;

namespace {

constexpr int n = 3;
using System = detail::Enclosure<n>;

double uniform(exhaustive::Random& random) { return static_cast<double>(random.between(-1000000, 1000000)) * 1e-6; }

/// x of M x = b by Cramer's rule.
void solve(const double (&m)[n][n], const double (&b)[n], double (&x)[n]) {
  const auto det = [](const double(&a)[n][n]) {
    return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
           a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
  };
  for (int k = 0; k < n; ++k) {
    double with[n][n];
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        with[i][j] = j == k ? b[i] : m[i][j];
    x[k] = det(with) / det(m);
  }
}

/// A system whose inverse is off by `off`, whose products are off by `slack` and whose residual by `doubt`, one way or
/// the other, as much as they may be; `error` is the exact solution.
System drawn(exhaustive::Random& random, double off, std::int32_t slack, std::int32_t doubt, double (&error)[n]) {
  constexpr int shift = 28;
  double m[n][n], b[n];
  System system;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      m[i][j] = (i == j ? 1.0 : 0.0) + 0.3 * uniform(random);
  for (int j = 0; j < n; ++j) {
    double unit[n] = {}, column[n];
    unit[j] = 1.0;
    solve(m, unit, column);
    system.shift[j] = shift;
    std::int64_t made[n];
    std::int32_t made_error[n];
    for (int i = 0; i < n; ++i)
      system.inverse[i][j] =
          static_cast<std::int32_t>(std::ldexp(column[i] * (1.0 + off * uniform(random)), shift - 1));
    system.shift[j] = shift - 1;
    for (int i = 0; i < n; ++i) {
      double sum = 0.0;
      for (int k = 0; k < n; ++k)
        sum += m[i][k] * system.inverse[k][j];
      made_error[i] = slack + 1;
      made[i] = std::llround(sum) + random.between(-slack, slack);
    }
    system.set_defects(j, made, made_error);
  }
  for (int i = 0; i < n; ++i) {
    b[i] = 1e6 * uniform(random);
    system.residual_error[i] = doubt + 1;
    system.residual[i] = std::llround(b[i]) + (random.between(0, 1) == 0 ? doubt : -doubt);
  }
  solve(m, b, error);
  return system;
}

}  // namespace

TEST(Enclosure, HoldsTheExactSolution) {
  exhaustive::Random random(5);
  int proved = 0;
  double nearest = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const double off = k % 4 == 0 ? 0.0 : std::pow(0.1, k % 4);
    const auto slack = static_cast<std::int32_t>(k % 3) * 500;
    double error[n];
    System system = drawn(random, off, slack, k % 5 == 0 ? 400000 : slack, error);
    if (!system.enclose()) continue;
    ++proved;
    for (int i = 0; i < n; ++i) {
      const double apart = std::fabs(error[i] - static_cast<double>(system.correction[i]));
      EXPECT_LE(apart, static_cast<double>(system.bound[i]) + 1e-3) << k;
      nearest = std::fmax(nearest, apart / static_cast<double>(system.bound[i]));
    }
  }
  EXPECT_GT(proved, 15000);
  EXPECT_GT(nearest, 0.8) << "bounds as loose as this leave room for a missing term";
}

// The inverse of one unknown is off by so much that the residual does not shrink to a half.
TEST(Enclosure, ProvesNothingByAPoorInverse) {
  for (const int percent : {-60, -45, 45, 60, 300}) {
    detail::Enclosure<1> one;
    one.inverse[0][0] = (1 << 20) / 100 * (100 + percent), one.shift[0] = 20;
    const std::int64_t made[] = {one.inverse[0][0]};
    const std::int32_t error[] = {0};
    one.set_defects(0, made, error);
    one.residual[0] = 1000000;
    EXPECT_EQ(one.enclose(), std::abs(percent) < 50) << percent;
  }
}

// What M makes of the inverse is known within `slack` only: M may be 1 +- slack, and x its quotient.
TEST(Enclosure, HoldsWhatItsProductsAreOff) {
  for (const int eighths : {-2, -1, 1, 2}) {
    detail::Enclosure<1> one;
    one.inverse[0][0] = 1 << 20, one.shift[0] = 20;
    const std::int64_t made[] = {1 << 20};
    const std::int32_t slack[] = {2 << 17};
    one.set_defects(0, made, slack);
    one.residual[0] = 1000000;
    ASSERT_TRUE(one.enclose());
    const double exact = 1e6 / (1.0 + eighths / 8.0);
    EXPECT_LE(std::fabs(exact - static_cast<double>(one.correction[0])), static_cast<double>(one.bound[0]) + 1.0);
  }
}

TEST(Enclosure, ProvesNothingOfWordsThatDoNotFit) {
  detail::Enclosure<1> one;
  one.inverse[0][0] = 1 << 20, one.shift[0] = 20;
  const std::int64_t made[] = {1 << 20};
  const std::int32_t error[] = {0};
  one.set_defects(0, made, error);
  detail::Enclosure<1> large = one, steep = one;
  EXPECT_TRUE(one.enclose());
  large.residual[0] = std::int64_t{1} << 31;
  EXPECT_FALSE(large.enclose());
  steep.shift[0] = detail::Enclosure<1>::least_shift - 1;
  steep.set_defects(0, made, error);
  EXPECT_FALSE(steep.enclose());
}

namespace {

struct Words {
  std::int32_t raw = 0;
};
struct PublishedAnswer {
  Words values[1];
  struct {
    Words values[1];
  } bound;
};
struct Corrected {
  std::int64_t correction[1], bound[1];
};

}  // namespace

// Words of an answer as fine as the system's, coarser, and finer ones: what was found plus its correction, and a bound
// that holds what moving them rounds. What its words do not hold is unknown, and the answer stays.
TEST(Enclosure, IsPublishedInWordsOfTheAnswer) {
  constexpr std::int64_t loose[] = {std::int64_t{1} << 40};
  exhaustive::Random random(9);
  for (int k = 0; k < 20000; ++k) {
    const int down = static_cast<int>(random.between(-40, 40));
    const std::int64_t x = random.between(-1000000, 1000000) * (std::int64_t{1} << random.between(0, 10));
    const Corrected system{{random.between(-1000, 1000)}, {random.between(1, 100000)}};
    PublishedAnswer answer{};
    answer.values[0].raw = 77;
    const bool known = k % 7 != 0;
    const bool tight = detail::publish_in_words<1>(
        answer, system, loose, known, [&](int) { return x; }, [&](int) { return down; });
    const double exact = std::ldexp(static_cast<double>(x + system.correction[0]), -down);
    const double bound = std::ldexp(static_cast<double>(system.bound[0]), -down);
    constexpr double most = 2147483647.0;
    if (!known || std::fabs(exact) > most || bound > most) {
      EXPECT_FALSE(tight) << down;
      EXPECT_EQ(answer.values[0].raw, 77) << down;
      EXPECT_EQ(answer.bound.values[0].raw, std::numeric_limits<std::int32_t>::max()) << down;
      continue;
    }
    if (std::fabs(exact) > most - 4.0 || bound > most - 4.0) continue;  // either
    EXPECT_TRUE(tight) << down;
    const double off = std::fabs(exact - answer.values[0].raw);
    EXPECT_LE(off, 1.0) << down;
    EXPECT_GE(answer.bound.values[0].raw, bound + off - 1e-9) << down;
    EXPECT_LE(answer.bound.values[0].raw, bound + (down > 0 ? 2.0 : 0.0)) << down;
  }
}
