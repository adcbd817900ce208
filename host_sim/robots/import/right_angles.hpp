// Angles, axes and lengths that were meant as special ones and written with few digits: one rule for all of them.
#pragma once

#include <host_sim/robots/description/findings.hpp>
#include <host_sim/robots/description/table.hpp>
#include <host_sim/robots/import/source_tree.hpp>

#include <string>

namespace importer {

/// An angle this near to a multiple of 90 degrees, but not one, was most likely meant as it: 1.57 or 89.75 degrees.
constexpr double nearly_right = 5e-3;  // rad

/// How near is near: what --right-angles and --snap allow.
struct Nearness {
  double angle = 1e-5;   ///< rad: of any angle or axis to a multiple of 90 degrees; 0 reads what is written
  bool snap = false;     ///< nearly right ones of joints are taken for right
  double length = 1e-6;  ///< m: less than this from 0 is 0

  double of_joints() const { return snap && nearly_right > angle ? nearly_right : angle; }
  bool changes() const { return of_joints() > 0.0; }
};

/// A joint whose axis or frame is that far off one that would be taken for right with --snap.
description::Finding nearly_right_joint(const std::string& name, double off);

/// How fine lengths are written: the longest over 10 to as many digits as any has, at most 1e-6 m.
class LengthDigit {
 public:
  void see(const std::string& written, double length);
  double value() const;

 private:
  int digits_ = 0;
  double longest_ = 0.0;
};

/// Reads a URDF's rotations, axes and positions. What is near a special value becomes it, exactly, and is recorded as a
/// change; what is `nearly_right` and stays is a warning that names its joint.
class RightAngles {
 public:
  explicit RightAngles(const Nearness& near) : near_(near) {}

  /// The matrix of roll, pitch and yaw: of a joint's origin, or of a link's inertial frame.
  Rows rotation(std::array<double, 3> rpy, Change::Of of, const std::string& name);
  /// A joint's axis: components near 0 are 0.
  std::array<double, 3> axis(std::array<double, 3> written, const std::string& joint);
  /// Where a joint's origin is.
  std::array<double, 3> position(std::array<double, 3> written, const std::string& joint);

  const std::vector<Change>& changes() const { return changes_; }
  /// Of angles that were left as they are and are nearly right.
  const std::vector<description::Finding>& warnings() const { return warnings_; }

 private:
  void change(Change::Of of, const std::string& name, std::size_t index, double written, double read);

  Nearness near_;
  std::vector<Change> changes_;
  std::vector<description::Finding> warnings_;
};

/// Records that a number was read as another one; of one that was changed before, as what it is now.
void record(std::vector<Change>& changes, const Change& change);

/// How many numbers were changed and how far, a sentence a kind; empty where none was by more than rounding.
std::vector<std::string> sentences(const std::vector<Change>& changes, const Nearness& near);

/// The same of a table: alpha, theta and gamma of its rows, rotations of base and tool, lengths of rows.
struct TableChanges {
  std::vector<Change> changes;
  std::vector<description::Finding> warnings;
};
TableChanges table_right_angles(description::Table& table, const Nearness& near);

}  // namespace importer
