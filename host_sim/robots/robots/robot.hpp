// The project's robots by name: limits for planning, and the oracle as the plant's exact dynamics.
#pragma once

#include <host_sim/robots/trajectory/set_point.hpp>

#include <oracle/driven.hpp>

#include <string>
#include <vector>

namespace host_sim {

/// Where joints share drives, values are those of the drives.
struct Robot {
  std::string name;
  std::vector<JointLimits> limits;    ///< of joints, or of drives that joints share
  std::vector<bool> slides;           ///< whether a joint, or a drive, is told in m
  oracle::Chain<oracle::quad> chain;  ///< with its rotors, as a bare robot stands for
  oracle::DrivenChain<oracle::quad> driven;
  std::vector<JointLimits> moved{};  ///< limits of the joints that shared drives move; else empty

  int joints() const { return static_cast<int>(limits.size()); }
  bool shares_drives() const { return !moved.empty(); }
  const char* noun() const { return shares_drives() ? "drive" : "joint"; }
  bool prismatic(int joint) const { return slides[static_cast<std::size_t>(joint)]; }
  const char* effort_unit(int joint) const { return prismatic(joint) ? "N" : "N m"; }
  const char* acceleration_unit(int joint) const { return prismatic(joint) ? "m/s^2" : "rad/s^2"; }
};

/// Names of all robots, in the order of robots/robots.hpp.
std::vector<std::string> robot_names();

/// Names of robots whose joints share drives.
std::vector<std::string> driven_robot_names();

/// Of either kind. Throws std::runtime_error that names the robots there are.
Robot find_robot(const std::string& name);

/// Where the joints stand, rad or m: where they share drives, at these positions of drives.
std::vector<double> joint_positions(const Robot& robot, const std::vector<double>& q);

/// Torque of gravity, rotors and motion (N m or N), computed in 113-bit precision and rounded to double.
std::vector<double> exact_torque(const Robot& robot, const SetPoint& point);

}  // namespace host_sim
