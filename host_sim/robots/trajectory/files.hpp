// Trajectories as files: way-points to plan through (.json) or finished set-points (.csv).
#pragma once

#include <host_sim/robots/trajectory/pick_and_place.hpp>

#include <functional>
#include <string>
#include <vector>

namespace host_sim {

/// Reads way-points as in host_sim/robots/trajectories/<robot>.json (README.md there says the fields).
/// Throws std::runtime_error that says what is wrong with the file.
Cycle read_cycle(const std::string& path);

/// Reads set-points: a header line, then time, q..., qd..., qdd... a line, comma separated; rad or m, s.
/// Throws std::runtime_error with the line's number.
Trajectory read_set_points(const std::string& path, int joints);

/// Either of the two, by the file's ending. Throws std::runtime_error; also when the file is for another robot or
/// leaves the position limits.
Trajectory load_trajectory(const std::string& path, const std::string& robot, const std::vector<JointLimits>& limits);
/// Overload for way-points that are planned in a way of their own.
Trajectory load_trajectory(const std::string& path, const std::string& robot, const std::vector<JointLimits>& limits,
                           const std::function<Trajectory(const Cycle&)>& planned);

}  // namespace host_sim
