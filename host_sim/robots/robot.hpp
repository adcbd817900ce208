// The project's robots by name: limits for planning, and the oracle as the plant's exact dynamics.
#pragma once

#include <host_sim/trajectory/set_point.hpp>

#include <oracle/chain.hpp>

#include <string>
#include <vector>

namespace host_sim {

struct Robot {
  std::string name;
  std::vector<JointLimits> limits;
  oracle::Chain<oracle::quad> chain;  ///< with its rotors, as a bare robot stands for

  int joints() const { return chain.size(); }
  bool prismatic(int joint) const { return chain[joint].type == oracle::Joint::prismatic; }
  const char* effort_unit(int joint) const { return prismatic(joint) ? "N" : "N m"; }
  const char* acceleration_unit(int joint) const { return prismatic(joint) ? "m/s^2" : "rad/s^2"; }
};

/// Names of all robots, in the order of robots/robots.hpp.
std::vector<std::string> robot_names();

/// Throws std::runtime_error that names the robots there are.
Robot find_robot(const std::string& name);

/// Torque of gravity, rotors and motion (N m or N), computed in 113-bit precision and rounded to double.
std::vector<double> exact_torque(const Robot& robot, const SetPoint& point);

}  // namespace host_sim
