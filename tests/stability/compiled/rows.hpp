// Scenarios by the compile-time default route.
#pragma once

#include <stability/rows.hpp>

namespace stability {

/// Those of 12 joints and fewer whose names hold `filter`, in both types. The gate is what the choice of the route
/// promises: 16 times the error of ABA on the same scenario, or 10 roundings; a singular scenario passes where it is
/// reported and finite.
std::vector<Row> default_rows(const std::string& filter);

/// The form that the robot of a scenario takes by default; ABA where the compiler knows no such robot.
Route default_route(const std::string& scenario);

}  // namespace stability
