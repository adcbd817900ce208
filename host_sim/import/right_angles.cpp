#include <host_sim/description/angles.hpp>
#include <host_sim/description/numbers.hpp>
#include <host_sim/description/poses.hpp>
#include <host_sim/import/right_angles.hpp>

#include <algorithm>
#include <cmath>

namespace importer {
namespace {

using description::Finding;
using description::number;

constexpr double quarter = 1.57079632679489661923, rounding = 1e-13;
constexpr double read_back = 1e-7;  // rad: what roll, pitch and yaw lose by a quaternion near 90 degrees of pitch

Rows of_quaternion(const urdf::Rotation& q) {
  const long double x = q.x, y = q.y, z = q.z, w = q.w, s = 2.0L / (x * x + y * y + z * z + w * w);
  const auto entry = [](long double v) { return static_cast<double>(v); };
  return {entry(1 - s * (y * y + z * z)), entry(s * (x * y - z * w)),     entry(s * (x * z + y * w)),
          entry(s * (x * y + z * w)),     entry(1 - s * (x * x + z * z)), entry(s * (y * z - x * w)),
          entry(s * (x * z - y * w)),     entry(s * (y * z + x * w)),     entry(1 - s * (x * x + y * y))};
}

double nearest_right(double angle) { return quarter * std::round(angle / quarter); }

Finding nearly(const std::string& link, const std::string& what, double off) {
  return {false, link, what + " is " + number(off, 2) + " rad off a multiple of 90 degrees",
          "if a right angle was meant, --snap makes it exact, which also costs less"};
}

/// The signed permutation that a rotation nearly is; false where it is none or is one already.
bool snap_rotation(axial::FixedPose& pose, double& off) {
  off = 0.0;
  axial::FixedPose right = pose;
  for (int i = 0; i < 9; ++i) {
    right.rotation[i] = std::round(pose.rotation[i]) + 0.0;
    off = std::max(off, std::abs(pose.rotation[i] - right.rotation[i]));
  }
  if (off > nearly_right || off <= rounding || !description::is_rotation(right)) return false;
  pose = right;
  return true;
}

}  // namespace

double RightAngles::snapped(double angle, const std::string& joint, const char* name) {
  const double nearest = nearest_right(angle), off = std::abs(angle - nearest);
  const bool near = !joint.empty() && off <= nearly_right;
  if (off <= tolerance_ || (snap_ && near)) return nearest;
  if (near && off > read_back)
    warnings_.push_back(nearly("", "joint '" + joint + "': " + name + " of " + number(angle, 6) + " rad", off));
  return angle;
}

Rows RightAngles::rotation(const urdf::Rotation& written, const std::string& joint) {
  const Rows plain = of_quaternion(written);
  double roll = 0.0, pitch = 0.0, yaw = 0.0;
  written.getRPY(roll, pitch, yaw);
  axial::FixedPose pose;
  description::set_rotation(pose, snapped(roll, joint, "roll"), snapped(pitch, joint, "pitch"),
                            snapped(yaw, joint, "yaw"));
  if (tolerance_ <= 0.0 && !(snap_ && !joint.empty())) return plain;
  Rows result;
  std::copy(pose.rotation, pose.rotation + 9, result.begin());
  double change = 0.0;
  for (std::size_t i = 0; i < 9; ++i)
    change = std::max(change, std::abs(result[i] - plain[i]));
  if (change > rounding) ++changed_, farthest_ = std::max(farthest_, change);
  return result;
}

std::array<double, 3> RightAngles::axis(std::array<double, 3> written, const std::string& joint) {
  const double length = std::hypot(written[0], written[1], written[2]);
  for (double& component : written) {
    const double off = std::abs(component) / length;
    if (!(off > rounding && off <= nearly_right)) continue;
    if (snap_)
      component = 0.0, ++changed_, farthest_ = std::max(farthest_, off);
    else
      warnings_.push_back(nearly("", "joint '" + joint + "': the axis' angle to an axis of its frame", off));
  }
  return written;
}

std::string RightAngles::text() const {
  return std::to_string(changed_) + " rotations were read as the multiples of 90 degrees that they are within " +
         number(snap_ ? std::max(tolerance_, nearly_right) : tolerance_, 2) + " rad of; the farthest by " +
         number(farthest_, 2) + (snap_ ? " (without --snap fewer are)" : " (--right-angles 0 reads what is written)");
}

std::vector<Finding> table_right_angles(description::Table& table, bool snap) {
  std::vector<Finding> warnings;
  int changed = 0;
  double farthest = 0.0;
  const auto count = [&](double off) { ++changed, farthest = std::max(farthest, off); };
  const auto visit = [&](axial::Angle& angle, const description::Link& link, const char* name) {
    const double off = std::abs(angle.radians - nearest_right(angle.radians));
    if (!(off > rounding && off <= nearly_right)) return;
    if (snap)
      angle = description::canonical_angle(angle.radians, nearly_right), count(off);
    else
      warnings.push_back(
          nearly(link.name, "joint '" + link.joint + "': " + name + " of " + number(angle.radians, 6) + " rad", off));
  };
  for (auto& link : table.robot.links) {
    auto& p = link.parameters;
    visit(p.alpha, link, "alpha"), visit(p.theta, link, "theta"), visit(p.gamma, link, "gamma");
  }
  const auto visit_pose = [&](axial::FixedPose& pose, const char* name) {
    axial::FixedPose right = pose;
    double off = 0.0;
    if (!snap_rotation(right, off)) return;
    if (snap)
      pose = right, count(off);
    else
      warnings.push_back(nearly("", std::string("the rotation of ") + name, off));
  };
  visit_pose(table.robot.base, "base"), visit_pose(table.robot.tool, "tool");
  if (changed > 0)
    table.robot.notes.push_back("--snap: " + std::to_string(changed) +
                                " angles were made the multiples of 90 degrees that they nearly are; the farthest by " +
                                number(farthest, 2) + " rad");
  return warnings;
}

}  // namespace importer
