#include <host_sim/robots/description/angles.hpp>
#include <host_sim/robots/description/numbers.hpp>
#include <host_sim/robots/description/poses.hpp>
#include <host_sim/robots/import/right_angles.hpp>

#include <algorithm>
#include <cmath>

namespace importer {
namespace {

using description::Finding;
using description::number;

constexpr double quarter = 1.57079632679489661923, rounding = 1e-13;

double nearest_right(double angle) { return quarter * std::round(angle / quarter); }

Finding nearly(const std::string& link, const std::string& what, double off) {
  return {false, link, what + " is " + number(off, 2) + " rad off a multiple of 90 degrees",
          "if a right angle was meant, --snap makes it exact, which also costs less"};
}

/// The signed permutation that a rotation is within so much of, entry by entry; false where it is none or is one
/// already.
bool snap_rotation(axial::FixedPose& pose, double within, double& off) {
  off = 0.0;
  axial::FixedPose right = pose;
  for (int i = 0; i < 9; ++i) {
    right.rotation[i] = std::round(pose.rotation[i]) + 0.0;
    off = std::max(off, std::abs(pose.rotation[i] - right.rotation[i]));
  }
  if (off > within || off <= rounding || !description::is_rotation(right)) return false;
  pose = right;
  return true;
}

/// Significant digits of a number.
int digits(const std::string& number) {
  const auto mantissa = number.substr(0, number.find_first_of("eE"));
  const auto first = mantissa.find_first_of("123456789");
  if (first == std::string::npos) return 0;
  return static_cast<int>(std::count_if(mantissa.begin() + static_cast<std::ptrdiff_t>(first), mantissa.end(),
                                        [](char c) { return c >= '0' && c <= '9'; }));
}

}  // namespace

Finding nearly_right_joint(const std::string& name, double off) {
  return nearly("", "joint '" + name + "': its axis or frame", off);
}

void LengthDigit::see(const std::string& written, double length) {
  digits_ = std::max(digits_, digits(written)), longest_ = std::max(longest_, std::abs(length));
}
double LengthDigit::value() const { return std::min(1e-6, longest_ * std::pow(10.0, -digits_)); }

void record(std::vector<Change>& changes, const Change& change) {
  for (auto& earlier : changes)
    if (earlier.of == change.of && earlier.name == change.name && earlier.index == change.index) {
      earlier.read = change.read;
      return;
    }
  changes.push_back(change);
}

void RightAngles::change(Change::Of of, const std::string& name, std::size_t index, double written, double read) {
  record(changes_, {of, name, index, written, read});
}

Rows RightAngles::rotation(std::array<double, 3> rpy, Change::Of of, const std::string& name) {
  static constexpr const char* names[] = {"roll", "pitch", "yaw"};
  const bool joint = of == Change::Of::joint_rpy;
  for (std::size_t i = 0; i < 3; ++i) {
    const double written = rpy[i], nearest = nearest_right(written), off = std::abs(written - nearest);
    if (off <= rounding) continue;
    if (off <= (joint ? near_.of_joints() : near_.angle))
      rpy[i] = nearest, change(of, name, i, written, nearest);
    else if (joint && off <= nearly_right)
      warnings_.push_back(nearly("", "joint '" + name + "': " + names[i] + " of " + number(written, 6) + " rad", off));
  }
  axial::FixedPose pose;
  description::set_rotation(pose, rpy[0], rpy[1], rpy[2]);
  Rows result;
  std::copy(pose.rotation, pose.rotation + 9, result.begin());
  return result;
}

std::array<double, 3> RightAngles::axis(std::array<double, 3> written, const std::string& joint) {
  const double length = std::hypot(written[0], written[1], written[2]);
  double moved = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double off = std::abs(written[i]) / length;
    if (off == 0.0 || off > std::max(nearly_right, near_.of_joints())) continue;
    if (std::hypot(moved, off) <= near_.of_joints())
      moved = std::hypot(moved, off), change(Change::Of::joint_axis, joint, i, written[i], 0.0), written[i] = 0.0;
    else if (off > rounding)
      warnings_.push_back(nearly("", "joint '" + joint + "': the axis' angle to an axis of its frame", off));
  }
  return written;
}

std::array<double, 3> RightAngles::position(std::array<double, 3> written, const std::string& joint) {
  for (std::size_t i = 0; i < 3; ++i)
    if (near_.changes() && written[i] != 0.0 && std::abs(written[i]) < near_.length)
      change(Change::Of::joint_xyz, joint, i, written[i], 0.0), written[i] = 0.0;
  return written;
}

std::vector<std::string> sentences(const std::vector<Change>& changes, const Nearness& near) {
  struct Kind {
    int count;
    double farthest;
    std::string joints;
  } angles{}, axes{}, lengths{};
  for (const auto& change : changes) {
    const double off = std::abs(change.read - change.written);
    if (off <= rounding) continue;
    const bool turned = change.of == Change::Of::joint_axis || change.of == Change::Of::joint_turn,
               shifted = change.of == Change::Of::joint_xyz || change.of == Change::Of::row_length;
    auto& kind = turned ? axes : shifted ? lengths : angles;
    ++kind.count, kind.farthest = std::max(kind.farthest, off);
    const std::string name = "'" + change.name + "'";
    if (kind.joints.find(name) == std::string::npos) kind.joints += (kind.joints.empty() ? "" : ", ") + name;
  }
  const std::string remedy = near.snap ? " (without --snap fewer are)" : " (--right-angles 0 reads what is written)";
  std::vector<std::string> text;
  if (angles.count > 0)
    text.push_back(std::to_string(angles.count) +
                   " angles were read as the multiples of 90 degrees that they are within " +
                   number(near.of_joints(), 2) + " rad of; the farthest by " + number(angles.farthest, 2) + remedy);
  if (axes.count > 0)
    text.push_back("axes were turned by up to " + number(axes.farthest, 2) +
                   " rad onto axes of their frames or of their neighbours', joints " + axes.joints + remedy);
  if (lengths.count > 0)
    text.push_back("origins were shifted by up to " + number(lengths.farthest, 2) +
                   " m, which is finer than the file's digits, " + lengths.joints + remedy);
  return text;
}

TableChanges table_right_angles(description::Table& table, const Nearness& near) {
  TableChanges result;
  const auto turn = [&](axial::Angle& angle, const description::Link& link, std::size_t index) {
    static constexpr const char* names[] = {"alpha", "theta", "gamma"};
    const double written = angle.radians, off = std::abs(written - nearest_right(written));
    if (!(off > rounding && off <= std::max(nearly_right, near.of_joints()))) return;
    if (off <= near.of_joints()) {
      angle = description::canonical_angle(written, off + rounding);
      result.changes.push_back({Change::Of::row_angle, link.name, index, written, angle.radians});
    } else {
      result.warnings.push_back(
          nearly(link.name, "joint '" + link.joint + "': " + names[index] + " of " + number(written, 6) + " rad", off));
    }
  };
  const auto shorten = [&](double& length, const description::Link& link, std::size_t index) {
    if (!near.changes() || length == 0.0 || std::abs(length) >= near.length) return;
    result.changes.push_back({Change::Of::row_length, link.name, index, length, 0.0});
    length = 0.0;
  };
  for (auto& link : table.robot.links) {
    auto& p = link.parameters;
    turn(p.alpha, link, 0), turn(p.theta, link, 1), turn(p.gamma, link, 2);
    shorten(p.a, link, 0), shorten(p.d, link, 1), shorten(p.b, link, 2);
  }
  const auto turn_pose = [&](axial::FixedPose& pose, const std::string& name) {
    axial::FixedPose right = pose;
    double off = 0.0;
    if (!snap_rotation(right, std::max(nearly_right, near.of_joints()), off)) return;
    if (off > near.of_joints()) {
      result.warnings.push_back(nearly("", "the rotation of " + name, off));
      return;
    }
    for (std::size_t k = 0; k < 9; ++k)
      if (pose.rotation[k] != right.rotation[k])
        result.changes.push_back({Change::Of::pose_rotation, name, k, pose.rotation[k], right.rotation[k]});
    pose = right;
  };
  turn_pose(table.robot.base, "base"), turn_pose(table.robot.tool, "tool");
  for (const auto& line : sentences(result.changes, near))
    table.robot.notes.push_back(line);
  return result;
}

}  // namespace importer
