// How exact a torque is in every number system, on the same states.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace numbers {

/// One algorithm of one robot in one number system, over seeded states inside the declared limits. Relative to each
/// joint's largest torque on these states.
struct Row {
  std::string robot, algorithm, scalar;
  int states;
  double error, error_rms;
  std::optional<double> certified;  ///< what the analysis proves of any state, of fixed point
};

/// Rows of robot R: a source each (robot.cpp.in).
template <class R>
std::vector<Row> rows_of();

/// Names of the robots that are compared.
std::vector<std::string> robots();

/// Rows of a robot. Throws std::runtime_error that names the robots there are.
std::vector<Row> rows(const std::string& robot);

}  // namespace numbers
