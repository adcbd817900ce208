#include <gtest/gtest.h>
#include <algorithm>
#include <axial/dynamics/elimination_error.hpp>
#include <cmath>
#include <random>
#include <vector>

using namespace axial;

namespace {

constexpr int most_joints = 16;
using Rows = std::vector<std::vector<double>>;

struct Entries {
  const Rows& rows;
  double operator()(int i, int j) const { return rows[std::size_t(i)][std::size_t(j)]; }
};

Rows square(int n) { return Rows(std::size_t(n), std::vector<double>(std::size_t(n))); }

// Gauss-Jordan, which knows no tree.
Rows inverse_of(Rows c) {
  const std::size_t n = c.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double pivot = 1.0 / c[k][k];
    c[k][k] = 1.0;
    for (auto& entry : c[k])
      entry *= pivot;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = c[i][k];
      c[i][k] = 0.0;
      for (std::size_t j = 0; j < n; ++j)
        c[i][j] -= factor * c[k][j];
    }
  }
  return c;
}

// |M^-1| |dM| |M^-1 e|, entry by entry, for every effort on one joint.
double error_of_all_entries(const Rows& m, const Rows& rounded) {
  const std::size_t n = m.size();
  const auto root = [&](std::size_t i) { return std::sqrt(m[i][i]); };
  Rows c = m, change = m;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      c[i][j] /= root(i) * root(j);
      change[i][j] = std::max(0.25, std::abs(rounded[i][j] - m[i][j]) / (root(i) * root(j) * 0x1p-24));
    }
  c = inverse_of(c);
  double worst = 0.0;
  for (std::size_t l = 0; l < n; ++l) {
    double largest = 0.0, error = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t k = 0; k < n; ++k)
          sum += std::abs(c[i][j]) * change[j][k] * std::abs(c[k][l]);
      largest = std::max(largest, std::abs(c[i][l]) / root(i)), error = std::max(error, sum / root(i));
    }
    worst = std::max(worst, error / largest);
  }
  return worst;
}

// M = L^T D L of a tree, of which float sees each entry some roundings off.
struct Drawn {
  detail::Parents<most_joints> parents;
  Rows m, rounded;
  Drawn(std::mt19937& random, int n, bool chain) : m(square(n)), rounded(square(n)) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < n && !chain; ++i)
      parents.of[i] = std::uniform_int_distribution<int>(std::max(-1, i - 4), i - 1)(random);
    for (int k = 0; k < n; ++k) {
      std::vector<double> row(std::size_t(n), 0.0);
      for (int j = k; j >= 0; j = parents.of[j])
        row[std::size_t(j)] = j == k ? 1.0 : 2.0 * unit(random);
      const double d = std::exp(3.0 * unit(random));
      for (std::size_t i = 0; i < row.size(); ++i)
        for (std::size_t j = 0; j < row.size(); ++j)
          m[i][j] += row[i] * d * row[j];
    }
    for (std::size_t i = 0; i < m.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const double off = m[i][j] == 0.0 ? 0.0 : 4.0 * unit(random) * unit(random);
        rounded[i][j] = rounded[j][i] = m[i][j] + off * 0x1p-24 * std::sqrt(m[i][i] * m[j][j]);
      }
  }
};

}  // namespace

TEST(ScaledInverse, IsThatOfThreeByThree) {
  // 2 -1 0; -1 2 -1; 0 -1 2 has the inverse (3 2 1; 2 4 2; 1 2 3) / 4, its scaled form twice that.
  const Rows m{{2, -1, 0}, {-1, 2, -1}, {0, -1, 2}};
  const detail::ScaledInverse<3> inverse(Entries{m}, {}, 3);
  EXPECT_TRUE(inverse.invertible());
  const double expected[3][3] = {{3, 2, 1}, {2, 4, 2}, {1, 2, 3}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(inverse(i, j), expected[i][j] / 2, 1e-14);
}

TEST(ScaledInverse, TellsWhatIsNotPositiveDefinite) {
  const auto of = [](double coupling) {
    const Rows m{{1, coupling}, {coupling, 1}};
    return detail::ScaledInverse<2>(Entries{m}, {}, 2).invertible();
  };
  EXPECT_FALSE(of(1.0));
  EXPECT_FALSE(of(1.5));
  EXPECT_FALSE(of(-1.0));
  EXPECT_TRUE(of(0.999999));
  const Rows massless{{1, 0}, {0, 0}};
  EXPECT_FALSE(detail::ScaledInverse<2>(Entries{massless}, {}, 2).invertible());
}

// M = (2 1; 1 1), so C^-1 = (2 -r; -r 2) with r = sqrt(2), and S = (r, 1).
TEST(EliminationError, IsWhatRoundingMakesOfTheWeakestEffort) {
  const auto m = [](int i, int j) { return i == 0 && j == 0 ? 2.0 : 1.0; };
  const double r = std::sqrt(2.0);
  EXPECT_NEAR(detail::elimination_error<2>(m, m, 2), 0.25 * (2 + r) * (2 + r) / r, 1e-12) << "a quarter at least";
  const auto rounded = [&](int i, int j) { return i == j ? m(i, j) : 1.0 + 8 * r * 0x1p-24; };
  const double near = 0.25 * 2 + 8 * r, far = 8 * 2 + 0.25 * r;
  EXPECT_NEAR(detail::elimination_error<2>(m, rounded, 2), (r * near + 2 * far) / r, 1e-6) << "eight where it is more";
  const auto singular = [](int, int) { return 1.0; };
  EXPECT_EQ(detail::elimination_error<2>(singular, singular, 2), detail::infinite_loss);
}

TEST(EliminationError, OfATreeIsThatOfAllEntries) {
  std::mt19937 random(20264);
  for (int draw = 0; draw < 400; ++draw) {
    const Drawn drawn(random, 2 + draw % (most_joints - 1), draw % 4 == 0);
    const int n = static_cast<int>(drawn.m.size());
    const double expected = error_of_all_entries(drawn.m, drawn.rounded);
    const Entries m{drawn.m}, rounded{drawn.rounded};
    const double error = detail::elimination_error<most_joints>(m, rounded, n, drawn.parents);
    EXPECT_NEAR(error, expected, 1e-6 * expected) << "draw " << draw;
    const detail::ScaledInverse<most_joints> inverse(m, drawn.parents, n);
    EXPECT_LE(inverse.least_error(), error * (1.0 + 1e-12)) << "draw " << draw;
    EXPECT_NEAR(inverse.least_error(), inverse.error(m, m), 1e-12 * error) << "draw " << draw;
  }
}
