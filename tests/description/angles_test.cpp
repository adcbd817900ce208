// Angles: what is taken for a multiple of 90 degrees, and how others are written.
#include <host_sim/robots/description/angles.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using description::canonical_angle;
using description::exact_degrees;

constexpr long double quarter = 1.57079632679489661923132169163975144L;

TEST(CanonicalAngle, IsAMultipleOf90DegreesWithinTheRoundingAndNotBeyond) {
  for (int k = -4; k <= 4; ++k)
    for (const long double sign : {1.0L, -1.0L}) {
      const auto near = canonical_angle(k * quarter + sign * 0.9e-13L);
      EXPECT_EQ(std::abs(near.cos) + std::abs(near.sin), 1.0) << k;
      const auto far = canonical_angle(k * quarter + sign * 1.2e-13L);
      EXPECT_NE(std::abs(far.cos) + std::abs(far.sin), 1.0) << k;
      const auto wide = canonical_angle(k * quarter + sign * 0.9e-3L, 1e-3);
      EXPECT_EQ(std::abs(wide.cos) + std::abs(wide.sin), 1.0) << k;
    }
}

TEST(CanonicalAngle, LiesInMinus180To180Degrees) {
  const double quarters[] = {0, 90, 180, -90, 0, 90, 180, -90, 0};
  for (int k = -4; k <= 4; ++k)
    EXPECT_EQ(exact_degrees(canonical_angle(k * quarter)).value(), quarters[k + 4]) << k;
  EXPECT_DOUBLE_EQ(canonical_angle(5.0L * quarter + 0.5L).radians, static_cast<double>(quarter) + 0.5);
}

TEST(CanonicalAngle, KeepsADecimalNumberOfDegrees) {
  for (const double degrees : {30.0, -37.25, 0.001, 179.999, 123.456}) {
    const auto written = axial::Angle::from_degrees(degrees);
    const auto read = canonical_angle(static_cast<long double>(written.radians));
    EXPECT_EQ(exact_degrees(read).value(), degrees);
    EXPECT_EQ(read.sin, written.sin);
    EXPECT_EQ(read.cos, written.cos);
  }
}

TEST(CanonicalAngle, KeepsRadiansThatNoDegreesSay) {
  const double radians = 1.23456789012345;
  EXPECT_EQ(canonical_angle(radians).radians, radians);
  EXPECT_FALSE(exact_degrees(canonical_angle(radians)).has_value());
}

TEST(CanonicalAngle, OfWhatIsNotFiniteIsNotFinite) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(std::isfinite(canonical_angle(bad).radians));
    axial::Angle angle;
    angle.radians = bad;
    EXPECT_FALSE(exact_degrees(angle).has_value());
  }
}

TEST(ExactDegrees, AreThoseOfThisVeryAngle) {
  auto angle = axial::Angle::from_degrees(30.0);
  EXPECT_EQ(exact_degrees(angle).value(), 30.0);
  angle.sin = std::nextafter(angle.sin, 1.0);
  EXPECT_FALSE(exact_degrees(angle).has_value()) << "another sine";
  angle = axial::Angle::from_degrees(30.0);
  angle.cos = std::nextafter(angle.cos, 0.0);
  EXPECT_FALSE(exact_degrees(angle).has_value()) << "another cosine";
}

}  // namespace
