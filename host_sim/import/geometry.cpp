#include <host_sim/import/geometry.hpp>

#include <cmath>

namespace importer {

namespace {
constexpr Real parallel = 1e-13L;  // sine, or metres: directions come from doubles
}

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

double rounded(Real value) { return std::abs(value) < 1e-14L ? 0.0 : static_cast<double>(value); }

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
