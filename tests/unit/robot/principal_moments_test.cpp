#include <gtest/gtest.h>
#include <axial/robot/principal_moments.hpp>

using namespace axial;

namespace {

/// diag(l, m, n) turned by 30 degrees about z, then by 90 about x.
PrincipalMoments turned(double l, double m, double n) {
  const double s = 0.5, c = 0.86602540378443864676;
  const double tensor[6] = {c * c * l + s * s * m, n, s * s * l + c * c * m, 0.0, c * s * (l - m), 0.0};
  return principal_moments(tensor);
}
void expect_moments(const PrincipalMoments& moments, double least, double middle, double largest, double tolerance) {
  EXPECT_NEAR(moments.least, least, tolerance);
  EXPECT_NEAR(moments.middle, middle, tolerance);
  EXPECT_NEAR(moments.largest, largest, tolerance);
}

}  // namespace

TEST(PrincipalMoments, AreTheEigenvaluesInAnyAxes) {
  expect_moments(turned(1.0, 2.0, 2.5), 1.0, 2.0, 2.5, 1e-14);
  expect_moments(turned(3.0, -0.5, 1.0), -0.5, 1.0, 3.0, 1e-14);
  expect_moments(turned(1.0, 2.0, 1.0), 1.0, 1.0, 2.0, 2e-7);
  expect_moments(turned(1.0, 1.0, 1.0), 1.0, 1.0, 1.0, 1e-4);
  expect_moments(turned(0.0, 0.0, 0.0), 0.0, 0.0, 0.0, 0.0);
}

TEST(PrincipalMoments, OfTinyAndHugeBodiesAreAsExact) {
  expect_moments(turned(1e-200, 2e-200, 2.5e-200), 1e-200, 2e-200, 2.5e-200, 1e-214);
  expect_moments(turned(1e200, 2e200, 2.5e200), 1e200, 2e200, 2.5e200, 1e186);
}

TEST(InertiaDefect, IsTheShareThatNoBodyHas) {
  EXPECT_EQ(inertia_defect({1.0, 1.0, 2.0}).triangle, 0.0);
  EXPECT_NEAR(inertia_defect({1.0, 1.0, 2.1}).triangle, 0.05, 1e-15);
  EXPECT_NEAR(inertia_defect({-0.1, 1.0, 1.1}).triangle, 0.1, 1e-15);  // a negative moment is none to add
  EXPECT_NEAR(inertia_defect({-0.1, 1.0, 2.0}).negative, 0.05, 1e-15);
  EXPECT_EQ(inertia_defect({0.0, 1.0, 1.0}).negative, 0.0);
  EXPECT_GT(inertia_defect({0.0, 0.0, 1.0}).triangle, 1e9);
  EXPECT_GT(inertia_defect({-1.0, -1.0, -1.0}).negative, 1e9);
}

TEST(PrincipalMoments, AreKnownWhileCompiling) {
  constexpr double tensor[6] = {2.0, 2.0, 3.0, 1.0, 0.0, 0.0};
  static_assert(principal_moments(tensor).largest > 2.999999 && principal_moments(tensor).least < 1.000001);
}
