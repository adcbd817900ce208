// What is streamed: desired motion, tick by tick.
#pragma once

#include <vector>

namespace host_sim {

/// Desired motion of all joints at one tick; rad or m and their derivatives by time.
struct SetPoint {
  double time = 0.0;  ///< s
  std::vector<double> q, qd, qdd;
  std::vector<double> q3{}, q4{};  ///< third and fourth derivative, of a smooth motion alone
};

/// Set-points at a constant rate.
using Trajectory = std::vector<SetPoint>;

/// What a joint's drive allows; rad or m.
struct JointLimits {
  double position_min = 0.0, position_max = 0.0;
  double speed = 0.0, acceleration = 0.0;
};

}  // namespace host_sim
