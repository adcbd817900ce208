// What motions in real time are off, robot by robot.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <limits>
#include <string>
#include <vector>

namespace host_sim::real_time {

/// One motion of a robot by a method over numbers.
struct Row {
  std::string robot, scalar, method;
  std::string motion;         ///< what it is
  double step = 0.0;          ///< s
  double error = 0.0;         ///< of a driven motion: the largest difference of a joint's position, over its travel
  double energy_drift = 0.0;  ///< of a free one: the largest change of energy, over what swings
  double gate = std::numeric_limits<double>::infinity();  ///< of either
  bool made = true;                                       ///< whether no step was refused
  bool pass() const { return made && error <= gate && energy_drift <= gate; }
};

/// A robot's rows.
///@{
std::vector<Row> puma560_rows();
std::vector<Row> scara_rows();
std::vector<Row> swing_rows();  ///< of the Puma 560
///@}
/// All of them.
std::vector<Row> rows();

/// With the fields that every machine-readable `plant` has.
nlohmann::json to_json(const std::vector<Row>& rows);

}  // namespace host_sim::real_time
