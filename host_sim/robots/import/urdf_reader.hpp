// URDF by urdfdom: the tree, or the chain to one tip, as it stands in the file.
#pragma once

#include <host_sim/robots/import/right_angles.hpp>
#include <host_sim/robots/import/source_tree.hpp>

#include <string>

namespace importer {

struct UrdfOptions {
  std::string root, tip;       ///< empty: the file's root; every branch
  double right_angles = 1e-5;  ///< rad: an angle this near to a multiple of 90 degrees is one; 0 reads what is written
  bool snap = false;           ///< so is one of a joint that is nearly_right
  bool hold_mimic = false;     ///< joints that mimic another one stay where that one is 0
};

/// What is near, in a file whose origins have this last digit.
Nearness nearness_of(const UrdfOptions& options, double length_digit);

/// Throws description::Refused with everything that is wrong, one line each: what urdfdom refuses, roots and tips that
/// are not there, joints that cannot be expressed (planar, floating, mimics of what does not move), bodies with
/// impossible numbers, transmissions without a linear law.
SourceTree read_urdf(const std::string& text, const std::string& from, const UrdfOptions& options);

}  // namespace importer
