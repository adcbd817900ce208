#include <host_sim/description/numbers.hpp>
#include <host_sim/description/poses.hpp>
#include <host_sim/import/right_angles.hpp>

#include <algorithm>
#include <cmath>

namespace importer {
namespace {

constexpr double quarter = 1.57079632679489661923, rounding = 1e-13;

Rows of_quaternion(const urdf::Rotation& q) {
  const long double x = q.x, y = q.y, z = q.z, w = q.w, s = 2.0L / (x * x + y * y + z * z + w * w);
  const auto entry = [](long double v) { return static_cast<double>(v); };
  return {entry(1 - s * (y * y + z * z)), entry(s * (x * y - z * w)),     entry(s * (x * z + y * w)),
          entry(s * (x * y + z * w)),     entry(1 - s * (x * x + z * z)), entry(s * (y * z - x * w)),
          entry(s * (x * z - y * w)),     entry(s * (y * z + x * w)),     entry(1 - s * (x * x + y * y))};
}

}  // namespace

double RightAngles::snapped(double angle) {
  const double nearest = quarter * std::round(angle / quarter);
  return std::abs(angle - nearest) <= tolerance_ ? nearest : angle;
}

Rows RightAngles::rotation(const urdf::Rotation& written) {
  const Rows plain = of_quaternion(written);
  if (tolerance_ <= 0.0) return plain;
  double roll = 0.0, pitch = 0.0, yaw = 0.0;
  written.getRPY(roll, pitch, yaw);
  axial::FixedPose pose;
  description::set_rotation(pose, snapped(roll), snapped(pitch), snapped(yaw));
  Rows result;
  std::copy(pose.rotation, pose.rotation + 9, result.begin());
  double change = 0.0;
  for (std::size_t i = 0; i < 9; ++i)
    change = std::max(change, std::abs(result[i] - plain[i]));
  if (change > rounding) ++changed_, farthest_ = std::max(farthest_, change);
  return result;
}

std::string RightAngles::text() const {
  return std::to_string(changed_) + " rotations were read as the multiples of 90 degrees that they are within " +
         description::number(tolerance_, 2) + " rad of; the farthest by " + description::number(farthest_, 2) +
         " (--right-angles 0 reads what is written)";
}

}  // namespace importer
