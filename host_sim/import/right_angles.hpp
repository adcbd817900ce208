// Angles that were meant as multiples of 90 degrees and written with few digits.
#pragma once

#include <host_sim/description/findings.hpp>
#include <host_sim/description/table.hpp>
#include <host_sim/import/source_tree.hpp>

#include <urdf_model/pose.h>
#include <string>

namespace importer {

/// An angle this near to a multiple of 90 degrees, but not one, was most likely meant as it: 1.57 or 89.9 degrees.
constexpr double nearly_right = 2e-3;  // rad

/// Reads a URDF's rotations and axes. Roll, pitch and yaw within `tolerance` rad of a multiple of 90 degrees become it,
/// exactly. Those of joints that are `nearly_right` do so too where they are to snap, else a warning names the joint;
/// likewise axes of joints that are nearly perpendicular to an axis of their frame.
class RightAngles {
 public:
  RightAngles(double tolerance, bool snap) : tolerance_(tolerance), snap_(snap) {}

  /// The matrix of a URDF's rotation: of a joint's origin, or of an inertial frame where no joint is named.
  Rows rotation(const urdf::Rotation& written, const std::string& joint);
  /// A joint's axis.
  std::array<double, 3> axis(std::array<double, 3> written, const std::string& joint);
  /// Angles that were moved by more than rounding.
  int changed() const { return changed_; }
  /// How many were moved and how far, as a sentence.
  std::string text() const;
  /// Of angles that were left as they are and are nearly right.
  const std::vector<description::Finding>& warnings() const { return warnings_; }

 private:
  double snapped(double angle, const std::string& joint, const char* name);

  double tolerance_, farthest_ = 0.0;
  bool snap_;
  int changed_ = 0;
  std::vector<description::Finding> warnings_;
};

/// alpha, theta and gamma of a table's rows, rotations of base and tool: nearly right ones become right where they are
/// to snap, which a note of the table says; else warnings.
std::vector<description::Finding> table_right_angles(description::Table& table, bool snap);

}  // namespace importer
