#include <host_sim/robots/description/angles.hpp>
#include <host_sim/robots/import/geometry.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

namespace importer {

namespace {

constexpr Real parallel = 1e-13L;  // sine, or metres: directions come from doubles

/// The shortest decimal of up to ten digits that is so near.
std::optional<double> short_decimal(Real value, Real noise) {
  for (int digits = 0; digits < 10; ++digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*Le", digits, value);
    if (std::abs(std::strtold(text, nullptr) - value) <= noise) return std::strtod(text, nullptr) + 0.0;
  }
  return std::nullopt;
}

}  // namespace

Normal common_normal(const Line& first, const Line& second, const Vector& foot, const Vector& direction) {
  const Vector cross = first.direction.cross(second.direction), between = second.point - first.point;
  const Real sine = cross.norm();
  if (sine > parallel) {
    const Real along_first = between.cross(second.direction).dot(cross) / (sine * sine);
    const Real along_second = between.cross(first.direction).dot(cross) / (sine * sine);
    const Vector n = cross / sine;
    return {first.point + along_first * first.direction, second.point + along_second * second.direction,
            n.dot(direction) < -parallel ? Vector(-n) : n};
  }
  const Vector other = second.point + (foot - second.point).dot(second.direction) * second.direction;
  const Vector way = other - foot;
  if (way.norm() <= parallel) return {foot, other, direction};
  const Vector n = way.normalized();
  return {foot, other, n.dot(direction) < -parallel ? Vector(-n) : n};
}

Real angle_about(const Vector& axis, const Vector& from, const Vector& to) {
  return std::atan2(from.cross(to).dot(axis), from.dot(to));
}

Pose frame(const Vector& origin, const Vector& x, const Vector& z) {
  Pose result;
  result.position = origin;
  result.rotation << x, z.cross(x), z;
  return result;
}

double near_decimal(Real value, Real noise) { return short_decimal(value, noise).value_or(static_cast<double>(value)); }

double rounded(Real value) { return std::abs(value) < 1e-14L ? 0.0 : near_decimal(value, 2e-15L); }

axial::Angle near_angle(Real radians) {
  constexpr Real degree = 3.14159265358979323846264338327950288L / 180.0L, noise = 2e-15L;
  const auto nearest = description::canonical_angle(radians);
  if (!std::isfinite(radians) || nearest.cos == 0.0 || nearest.sin == 0.0) return nearest;
  if (const auto degrees = short_decimal(radians / degree, noise / degree)) return axial::Angle::from_degrees(*degrees);
  return description::canonical_angle(near_decimal(radians, noise));
}

axial::FixedPose rounded(const Pose& pose) {
  axial::FixedPose result;
  for (int i = 0; i < 3; ++i) {
    result.position[i] = rounded(pose.position[i]);
    for (int j = 0; j < 3; ++j)
      result.rotation[3 * i + j] = rounded(pose.rotation(i, j));
  }
  return result;
}

Matrix orthonormal(const double* rows) {
  Vector x(rows[0], rows[3], rows[6]), y(rows[1], rows[4], rows[7]);
  x.normalize();
  y = (y - x.dot(y) * x).normalized();
  Matrix result;
  result << x, y, x.cross(y);
  return result;
}

}  // namespace importer
