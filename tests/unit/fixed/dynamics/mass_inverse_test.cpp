// The inverse of a matrix in words and its bounds, against solutions in double precision.
#include <gtest/gtest.h>
#include <axial/fixed/dynamics/mass_inverse.hpp>
#include <cmath>
#include <random>

using axial::detail::MassInverse;
using axial::detail::MassUnits;

namespace {

constexpr int N = 3;
struct System {
  MassUnits<N> units{};
  MassInverse<N> inverse{};
  double exact[N][N] = {}, inexact[N][N] = {};  // M, and what words have of it
};

// Solves M x = r by elimination with M as it is.
void solve(const double (&m)[N][N], const double (&r)[N], double (&x)[N]) {
  double a[N][N + 1];
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j)
      a[i][j] = m[i][j];
    a[i][N] = r[i];
  }
  for (int k = 0; k < N; ++k)
    for (int i = k + 1; i < N; ++i) {
      const double gain = a[i][k] / a[k][k];
      for (int j = k; j <= N; ++j)
        a[i][j] -= gain * a[k][j];
    }
  for (int i = N; i-- > 0;) {
    x[i] = a[i][N];
    for (int j = i + 1; j < N; ++j)
      x[i] -= a[i][j] * x[j];
    x[i] /= a[i][i];
  }
}

// Symmetric, its eigenvalues from a part of the largest to it; B is off by `off` of its largest entries. Rows have
// units of their own: the words of row i stand at 2^(28 - 2 i).
System drawn(std::mt19937_64& generator, double smallest, double off) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  System s;
  double root[N][N];
  for (auto& row : root)
    for (double& entry : row)
      entry = any(generator);
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) {
      s.inexact[i][j] = i == j ? smallest : 0.0;
      for (int k = 0; k < N; ++k)
        s.inexact[i][j] += root[i][k] * root[j][k] / 3.0;
    }
  for (int i = 0; i < N; ++i) {
    s.units.scale[i] = 28 - 2 * i;
    for (int j = 0; j < N; ++j) {
      const double unit = std::ldexp(1.0, -s.units.scale[i]), error = 8.0;
      s.units.error[i][j] = 9;
      s.inverse.mass[i][j] = static_cast<std::int32_t>(std::floor(s.inexact[i][j] / unit));
      s.exact[i][j] = s.inexact[i][j] + error * unit * any(generator);
    }
  }
  for (int j = 0; j < N; ++j) {
    double unit[N] = {}, column[N], most = 0.0;
    unit[j] = 1.0;
    solve(s.exact, unit, column);
    for (const double x : column)
      most = std::fmax(most, std::fabs(x));
    s.inverse.shift[j] = 29 - std::ilogb(most);
    for (int i = 0; i < N; ++i)
      s.inverse.inverse[i][j] = static_cast<std::int32_t>(
          std::floor(std::ldexp(column[i] + off * most * any(generator), s.inverse.shift[j])));
  }
  return s;
}
void refine(System& s) {
  s.inverse.find_defects(s.units);
  s.inverse.refine();
  s.inverse.find_defects(s.units);
  s.inverse.bound();
}

}  // namespace

namespace {
// Largest shares of the bounds, of solutions of right-hand sides whose rows are of `rows` and off by `errors` of that;
// by a B that was refined, or is off by a tenth of its largest entries.
double nearest_to_bounds(const double (&rows)[N], double errors, bool rough = false) {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  double nearest = 0.0;
  for (int k = 0; k < 5000; ++k) {
    System s = drawn(generator, rough ? 1.0 : std::ldexp(1.0, -k % 10), rough ? 0.1 : 1e-4);
    if (rough)
      s.inverse.find_defects(s.units), s.inverse.bound();
    else
      refine(s);
    EXPECT_TRUE(rough || s.inverse.proved);
    if (!s.inverse.proved) continue;
    std::int32_t words[N], error[N], lack[N];
    double r[N], x[N];
    for (int i = 0; i < N; ++i) {
      words[i] = static_cast<std::int32_t>(rows[i] * any(generator));
      error[i] = static_cast<std::int32_t>(rows[i] * errors * (k % 3));
      r[i] = words[i] + (i % 2 == 0 ? 1.0 : -1.0) * static_cast<double>(error[i]);
    }
    solve(s.exact, r, x);
    s.inverse.find_lack(words, error, lack);
    for (int i = 0; i < N; ++i) {
      const double off = std::fabs(static_cast<double>(s.inverse.solved(i, words)) - x[i]);
      const auto bound = static_cast<double>(s.inverse.off(i, lack));
      EXPECT_LE(off, bound) << i;
      nearest = std::fmax(nearest, off / bound);
    }
  }
  return nearest;
}
}  // namespace

TEST(MassInverse, SolvesWithinItsBounds) {
  constexpr double full = (1 << 29) - 1;
  EXPECT_GT(nearest_to_bounds({full, full, full}, 0.0), 0.3);
  EXPECT_GT(nearest_to_bounds({full, full, full}, 0.01), 0.9);
  EXPECT_GT(nearest_to_bounds({full, full, full}, 0.99), 0.3);
  EXPECT_GT(nearest_to_bounds({full, full / 1000, full / 1000000}, 0.01), 0.9) << "rows count as what they are";
  EXPECT_GT(nearest_to_bounds({full, full, full}, 0.0, true), 0.7);
}

namespace {
// The same where the right-hand side is moved by up to `moved` of its rows besides, of what find_lack() says and of
// what is lowered.
struct Nearest {
  double found = 0.0, lowered = 0.0;
};
Nearest nearest_where_moved(const double (&rows)[N], double errors, double moved, bool rough) {
  std::mt19937_64 generator(9);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  Nearest nearest;
  for (int k = 0; k < 5000; ++k) {
    System s = drawn(generator, rough ? 1.0 : std::ldexp(1.0, -k % 10), rough ? 0.1 : 1e-4);
    if (rough)
      s.inverse.find_defects(s.units), s.inverse.bound();
    else
      refine(s);
    if (!s.inverse.proved) continue;
    std::int32_t words[N], added[N], both[N], error[N], lack[N], lower[N], most = 0;
    double r[N], x[N];
    std::int64_t shifted[N];
    for (int i = 0; i < N; ++i) {
      words[i] = static_cast<std::int32_t>(rows[i] * any(generator));
      added[i] = static_cast<std::int32_t>(rows[i] * moved * any(generator));
      both[i] = words[i] + added[i];
      most = std::max(most, std::abs(added[i]));
      error[i] = static_cast<std::int32_t>(rows[i] * errors * (k % 3));
      r[i] = both[i] + (i % 2 == 0 ? 1.0 : -1.0) * static_cast<double>(error[i]);
    }
    solve(s.exact, r, x);
    for (int i = 0; i < N; ++i)
      shifted[i] = std::abs(s.inverse.solved(i, added)) + N;
    s.inverse.find_lack(both, error, lack);
    std::copy(lack, lack + N, lower);
    s.inverse.lower_lack(s.units, words, error, most, shifted, lower);
    for (int i = 0; i < N; ++i) {
      EXPECT_LE(lower[i], lack[i]);
      const auto solved = static_cast<double>(s.inverse.solved(i, words) + s.inverse.solved(i, added));
      const double off = std::fmax(0.0, std::fabs(solved - x[i]) - N);
      nearest.found = std::fmax(nearest.found, off / static_cast<double>(s.inverse.off(i, lack)));
      nearest.lowered = std::fmax(nearest.lowered, off / static_cast<double>(s.inverse.off(i, lower)));
    }
  }
  EXPECT_LE(nearest.lowered, 1.0);
  return nearest;
}
}  // namespace

TEST(MassInverse, LowersItsBoundsByItsUnknowns) {
  constexpr double full = (1 << 28) - 1;
  for (const bool rough : {false, true})
    for (const double moved : {0.0, 0.5})
      for (const double errors : {0.0, 1e-3, 0.3}) {
        const Nearest nearest = nearest_where_moved({full, full, full}, errors, moved, rough);
        EXPECT_GE(nearest.lowered, nearest.found);
        EXPECT_GT(nearest.lowered, rough || errors > 0.0 ? 0.9 : 0.7);
      }
  const Nearest still = nearest_where_moved({full, full, full}, 0.0, 0.0, false);
  EXPECT_GT(still.lowered, still.found + 0.1) << "unknowns are less than columns add up to";
}

TEST(MassInverse, IsRefined) {
  std::mt19937_64 generator(6);
  System s = drawn(generator, 0.5, 1e-4);
  s.inverse.find_defects(s.units);
  const auto before = s.inverse.spread[0];
  EXPECT_GT(before, 1 << 10);
  s.inverse.refine();
  s.inverse.find_defects(s.units);
  EXPECT_LT(s.inverse.spread[0], 200);
}

// Columns of M^-1 are its solutions of units.
TEST(MassInverse, HasColumnsWithinItsLoss) {
  std::mt19937_64 generator(7);
  double nearest = 0.0;
  for (int k = 0; k < 2000; ++k) {
    System s = drawn(generator, 0.01, 1e-4);
    refine(s);
    ASSERT_TRUE(s.inverse.proved);
    for (int j = 0; j < N; ++j) {
      double unit[N] = {}, column[N];
      unit[j] = 1.0;
      solve(s.exact, unit, column);
      for (int i = 0; i < N; ++i) {
        const double bound = std::ldexp(static_cast<double>(s.inverse.loss(i, j)), -MassInverse<N>::loss_bits);
        const double off = std::fabs(std::ldexp(s.inverse.inverse[i][j], -s.inverse.shift[j]) - column[i]);
        EXPECT_LE(off, bound);
        nearest = std::fmax(nearest, off / bound);
      }
    }
  }
  EXPECT_GT(nearest, 0.02);
}

// Nothing is proved of what is no inverse.
TEST(MassInverse, ProvesNothingOfAnotherMatrix) {
  std::mt19937_64 generator(8);
  for (int k = 0; k < 200; ++k) {
    System s = drawn(generator, 0.5, 0.0);
    for (auto& row : s.inverse.inverse)
      row[k % N] = -row[k % N];
    s.inverse.find_defects(s.units);
    s.inverse.bound();
    EXPECT_FALSE(s.inverse.proved);
  }
}
