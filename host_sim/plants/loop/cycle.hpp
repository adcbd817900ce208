// The motion that a robot follows.
#pragma once

#include <host_sim/robots/trajectory/set_point.hpp>

#include <string>

namespace host_sim::loop {

/// s, from set-point to set-point.
constexpr double control_tick = 1e-3;

/// The robot's cycle in host_sim/robots/trajectories, planned within its limits; if asked for smoothly, with four
/// derivatives and at half the accelerations. Where joints share drives it is of the drives, within limits of both.
/// Throws std::runtime_error that says what is wrong.
Trajectory cycle_of(const std::string& robot, bool smooth = false);

}  // namespace host_sim::loop
