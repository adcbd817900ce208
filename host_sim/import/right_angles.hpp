// Angles that were meant as multiples of 90 degrees and written with few digits.
#pragma once

#include <host_sim/import/source_tree.hpp>

#include <urdf_model/pose.h>
#include <string>

namespace importer {

/// Reads rotations; roll, pitch and yaw within `tolerance` rad of a multiple of 90 degrees become it, exactly.
class RightAngles {
 public:
  explicit RightAngles(double tolerance) : tolerance_(tolerance) {}

  /// The matrix of a URDF's rotation.
  Rows rotation(const urdf::Rotation& written);
  /// Angles that were moved by more than rounding.
  int changed() const { return changed_; }
  /// How many were moved and how far, as a sentence.
  std::string text() const;

 private:
  double snapped(double angle);

  double tolerance_, farthest_ = 0.0;
  int changed_ = 0;
};

}  // namespace importer
