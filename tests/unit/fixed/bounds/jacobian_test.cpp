// The certified error of the Jacobian, where rounding to the exponent of lengths is most of it.
#include <gtest/gtest.h>
#include <axial/fixed.hpp>
#include <cmath>
#include <random>

namespace {

using namespace axial;

/// A slide in any direction at the end of a long arm: lengths leave few bits for its direction.
struct Crane {
  static constexpr auto chain = axial::chain(
      gravity(0.0, 0.0, -9.81), revolute().mass(1.0).inertia_com(1, 1, 1).speed_limit(1.0).acceleration_limit(1.0),
      revolute().alpha_deg(40.0).a(30.0).mass(1.0).inertia_com(1, 1, 1).speed_limit(1.0).acceleration_limit(1.0),
      prismatic()
          .alpha_deg(50.0)
          .a(40.0)
          .mass(1.0)
          .position_limits(-20.0, 20.0)
          .speed_limit(1.0)
          .acceleration_limit(1.0));
};

}  // namespace

TEST(JacobianBound, OfASlideHasTheRoundingOfItsDirection) {
  constexpr double most = error_bound<Crane>(algorithm::jacobian)[2];
  const double unit = std::ldexp(1.0, -length_exponent<Crane, Fixed32>);
  std::mt19937_64 random(5);
  std::uniform_int_distribution<std::int32_t> any(INT32_MIN, INT32_MAX);
  double worst = 0.0;
  for (int k = 0; k < 2000; ++k) {
    Positions<Crane, Fixed32> words{};
    Joints<Crane, double> q{};
    for (int i = 0; i < 2; ++i) {
      words[i].raw = any(random);
      q[i] = words[i].raw * (6.283185307179586476925 * 0x1p-32);
    }
    const auto got = jacobian<Crane>(words)[2].linear;
    const auto exact = jacobian<Crane>(q)[2].linear;
    const double x = got.x.raw * unit - exact.x, y = got.y.raw * unit - exact.y, z = got.z.raw * unit - exact.z;
    worst = std::fmax(worst, std::sqrt(x * x + y * y + z * z));
  }
  EXPECT_LE(worst, most);
  EXPECT_GE(worst, 0.4 * most) << "a bound as loose as this says little";
}
