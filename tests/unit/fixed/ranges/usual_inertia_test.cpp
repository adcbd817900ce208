// What joints usually feel, against what mass matrices say: D of the innermost joint is 1 / (M^-1)_11.
#include <gtest/gtest.h>
#include <axial/fixed.hpp>
#include <axial/fixed/ranges/usual_inertia.hpp>
#include <cmath>

using namespace axial;

namespace {

struct Pair {
  static constexpr auto chain =
      axial::chain(revolute().mass(2.0).com(0.3, 0.1, 0.0).inertia_com(0.01, 0.02, 0.03).rotor_inertia(0.5, 1.0),
                   revolute().a(0.4).d(0.1).mass(1.0).com(0.2, -0.1, 0.05).inertia_com(0.02, 0.01, 0.015));
};
struct SlideOnATwist {
  static constexpr auto chain =
      axial::chain(prismatic().position_limits(-0.5, 0.5).mass(1.0).com(0.1, 0.0, 0.0).inertia_com(0.1, 0.1, 0.1),
                   revolute().alpha_deg(40).a(0.2).mass(3.0).com(0.2, 0.1, 0.0).inertia_com(0.1, 0.2, 0.3));
};

/// The least 1 / (M^-1)_11 of two joints over a fine grid, and the least M_22.
template <class R>
void expect_between(double least, double last) {
  double lowest = 1e300, highest = 0.0;
  for (int k = 0; k < 3600; ++k) {
    const Positions<R, double> q{0.1, k * 6.283185307179586 / 3600.0};
    const auto m = mass_matrix<R>(q);
    const double d = m(0, 0) - m(1, 0) * m(1, 0) / m(1, 1);
    lowest = std::fmin(lowest, d), highest = std::fmax(highest, d);
    EXPECT_NEAR(m(1, 1), last, 1e-12);
  }
  EXPECT_GE(least, lowest * (1.0 - 1e-9));
  EXPECT_LE(least, lowest + 0.1 * (highest - lowest)) << "sixteen positions come near the least";
}

}  // namespace

TEST(UsualInertia, IsNearTheLeastOfAllPositions) {
  constexpr auto pair = detail::usual_inertia(mechanism_of<scene_of<Pair>, FullParameters>);
  expect_between<Pair>(pair.of[0], pair.of[1]);
  constexpr auto slide = detail::usual_inertia(mechanism_of<scene_of<SlideOnATwist>, FullParameters>);
  expect_between<SlideOnATwist>(slide.of[0], slide.of[1]);
}

TEST(UsualInertia, SpreadsItsPositions) {
  for (int joint = 0; joint < 8; ++joint) {
    int seen[4] = {};
    for (int k = 0; k < 16; ++k) {
      const double x = detail::place(k, joint);
      ASSERT_GE(x, 0.0);
      ASSERT_LT(x, 1.0);
      ++seen[static_cast<int>(4.0 * x)];
    }
    for (const int quarter : seen)
      EXPECT_GE(quarter, 2) << "joint " << joint;
    for (int other = 0; other < joint; ++other)
      EXPECT_NE(detail::place(0, joint), detail::place(0, other)) << joint << " turns with " << other;
  }
}
