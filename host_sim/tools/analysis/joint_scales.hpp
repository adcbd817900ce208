// What the errors of joints are relative to.
#pragma once

#include <algorithm>
#include <vector>

namespace host_sim {

/// For each joint its largest torque or acceleration. An idle joint, with less than a billionth of the most loaded
/// one's, has none of its own to relate to (a vertical axis under gravity, an arm at rest) and takes the most loaded
/// one's.
inline std::vector<double> joint_scales(std::vector<double> largest) {
  const double most = *std::max_element(largest.begin(), largest.end());
  for (double& scale : largest)
    if (scale < 1e-9 * most) scale = most;
  return largest;
}

}  // namespace host_sim
