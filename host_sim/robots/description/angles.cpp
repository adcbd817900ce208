#include <host_sim/robots/description/angles.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace description {
namespace {

constexpr long double half_turn = 3.14159265358979323846264338327950288L;

bool same(const axial::Angle& left, const axial::Angle& right) {
  return !(left.radians < right.radians || left.radians > right.radians || left.cos < right.cos ||
           left.cos > right.cos || left.sin < right.sin || left.sin > right.sin);
}

// The nearest number of so many digits; written and read in one locale.
double rounded(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return std::strtod(text, nullptr);
}

}  // namespace

axial::Angle canonical_angle(long double radians, double rounding) {
  if (!std::isfinite(radians)) return axial::Angle::from_radians(static_cast<double>(radians));
  radians = std::remainder(radians, 2.0L * half_turn);
  const long double quarters = std::round(radians / (half_turn / 2.0L));
  if (std::abs(radians - quarters * half_turn / 2.0L) <= static_cast<long double>(rounding))
    return axial::Angle::from_degrees(quarters <= -2.0L ? 180.0 : 90.0 * static_cast<double>(quarters) + 0.0);
  const auto plain = axial::Angle::from_radians(static_cast<double>(radians));
  const auto degrees = exact_degrees(plain);
  return degrees ? axial::Angle::from_degrees(*degrees) : plain;
}

std::optional<double> exact_degrees(const axial::Angle& angle) {
  if (!std::isfinite(angle.radians)) return std::nullopt;
  const auto degrees = static_cast<double>(static_cast<long double>(angle.radians) * 180.0L / half_turn);
  for (int digits = 1; digits <= 15; ++digits) {
    const double candidate = rounded(degrees, digits);
    if (same(axial::Angle::from_degrees(candidate), angle)) return candidate + 0.0;
  }
  return std::nullopt;
}

}  // namespace description
