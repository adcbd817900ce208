#include <gtest/gtest.h>
#include <axial/control/payload_equations.hpp>
#include <cmath>

using axial::detail::Equations;

namespace {

// B^T B of a regular B, computed by hand: no entry is zero, no two are equal.
constexpr double b[4][4] = {{2, 1, -1, 3}, {0, 3, 2, 1}, {1, -2, 4, 0}, {-1, 1, 1, 5}};

void fill(double (&a)[4][4]) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      a[i][j] = 0;
      for (int k = 0; k < 4; ++k)
        a[i][j] += b[k][i] * b[k][j];
    }
}

}  // namespace

TEST(PayloadEquations, AreSolvedForAnyRightHandSide) {
  double a[4][4];
  fill(a);
  const Equations<double> equations(a);
  EXPECT_TRUE(equations.regular());
  for (int k = 0; k < 4; ++k) {
    double x[4] = {0.5, -1.0, 0.25, 2.0};
    x[k] += 3.0;
    const double right[4] = {x[0], x[1], x[2], x[3]};
    equations.solve(x);
    for (int i = 0; i < 4; ++i) {
      double left = 0;
      for (int j = 0; j < 4; ++j)
        left += a[i][j] * x[j];
      EXPECT_NEAR(left, right[i], 1e-12) << "row " << i;
    }
  }
}

TEST(PayloadEquations, ReadTheLowerTriangleAlone) {
  double a[4][4], whole[4] = {1, 2, 3, 4}, lower[4] = {1, 2, 3, 4};
  fill(a);
  Equations<double>(a).solve(whole);
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      a[i][j] = NAN;
  Equations<double>(a).solve(lower);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(lower[i], whole[i]);
}

TEST(PayloadEquations, SingularOnesAreToldAndStayFinite) {
  for (int lost = 0; lost < 4; ++lost) {
    double a[4][4], x[4] = {1, 2, 3, 4};
    fill(a);
    for (int i = 0; i < 4; ++i)
      a[lost][i] = a[i][lost] = 0;
    const Equations<double> equations(a);
    EXPECT_FALSE(equations.regular()) << lost;
    equations.solve(x);
    for (const double xi : x)
      EXPECT_TRUE(std::isfinite(xi)) << lost;
  }
}

TEST(PayloadEquations, APivotIsLostBelowSixteenEpsilons) {
  for (const double left : {17.0, 15.0}) {
    double a[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    const double eps = 2.220446049250313e-16;
    a[1][1] = 1 + left * eps;  // of which 1 is subtracted
    EXPECT_EQ(Equations<double>(a).regular(), left > 16) << left;
  }
}
