// What of a description is read, and how near is near: of every format.
#pragma once

#include <host_sim/robots/import/right_angles.hpp>

#include <string>

namespace importer {

struct ReadingOptions {
  std::string root, tip;       ///< of the file's links; empty: its root, every branch
  double right_angles = 1e-5;  ///< rad: an angle this near to a multiple of 90 degrees is one; 0 reads what is written
  bool snap = false;           ///< so is one of a joint that is nearly_right
  bool hold_mimic = false;     ///< joints that mimic another one stay where that one is 0
};

/// What is near, in a file whose origins have this last digit.
inline Nearness nearness_of(const ReadingOptions& options, double length_digit) {
  return {options.right_angles, options.snap, length_digit};
}

}  // namespace importer
