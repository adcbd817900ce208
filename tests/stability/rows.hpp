// The suite: scenarios by routes and number types, each with its gate.
#pragma once

#include <functional>
#include <stability/measure.hpp>
#include <stability/routes.hpp>
#include <string>

namespace stability {

/// One answer to one scenario. A gate of infinity is none.
struct Row {
  std::string scenario, family, scalar, route, status;
  int joints = 0;
  double condition = 0.0;
  bool absolute = false;  ///< forward error in rad/s^2
  double forward = 0.0, backward = 0.0;
  cases::Gate gate{};
  bool pass = false;
};

/// Admissible errors of a route. Articulated bodies have the scenario's; the other two solve with M or with a bias
/// torque that its inverse magnifies: 2 cond eps (the scenario's own where that is more), where cond eps < 1e-2; no
/// gate beyond.
cases::Gate gate_of(const Scenario& scenario, double condition, Route route, Scalar scalar);

/// Whether every one of them is a number.
bool is_finite(const oracle::Vector<double>& values);

/// A scenario by every route in both types. A singular one passes where it is reported and finite; elsewhere NaN must
/// be reported.
std::vector<Row> rows_of(const Scenario& scenario);

/// ST7 at 0.1 degrees over random sizes of the cubes: the median, since one instance is luck.
std::vector<Row> median_rows(int instances = 300);

/// ST12: masses times 2^-20, 1, 2^20 and lengths with gravity times 2^-10, 1, 2^10: the forward "error" is the largest
/// change of an acceleration, and its gate 0.
std::vector<Row> scaling_rows();

/// Every row whose scenario's name holds `filter`; tells `progress` the names.
std::vector<Row> all_rows(const std::string& filter, const std::function<void(const std::string&)>& progress);

}  // namespace stability
