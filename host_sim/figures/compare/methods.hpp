// The torque of one robot by every method there is for it: errors against the oracle, and what a slow refresh costs.
#pragma once

#include <host_sim/robots/robots/robot.hpp>

#include <string>
#include <vector>

namespace compare {

/// Error of a method over seeded states inside the declared limits, relative to each joint's largest torque.
struct MethodError {
  std::string robot, method, scalar;
  double error = 0.0, error_rms = 0.0;
};

/// Error of a two-rate feed-forward against the full rate, along the robot's pick-and-place cycle, relative to each
/// joint's largest torque there.
struct TwoRateError {
  std::string robot;
  int ticks = 0;  ///< of 1 ms between two refreshes
  double error = 0.0, error_rms = 0.0;
  double error_ahead = 0.0;  ///< separated where the robot will be half a period later
};

std::vector<MethodError> method_errors(const std::string& robot);
std::vector<TwoRateError> two_rate_errors(const std::string& robot, const host_sim::Trajectory& trajectory);

/// The robots that are compared: RRP, RRPR, 6R, 7R.
std::vector<std::string> robots();

}  // namespace compare
