// The library's routes of forward dynamics on a scenario, over the run-time model in its looped form.
#pragma once

#include <axial/scene/status.hpp>
#include <cases/scenarios.hpp>

namespace stability {

enum class Route { articulated_body, split_articulated_body, composite_body };
enum class Scalar { in_double, in_float };

constexpr Route routes[] = {Route::articulated_body, Route::split_articulated_body, Route::composite_body};
constexpr Scalar scalars[] = {Scalar::in_double, Scalar::in_float};

const char* name_of(Route route);
const char* name_of(Scalar scalar);
const char* name_of(const axial::Status& status);
double epsilon_of(Scalar scalar);

/// Accelerations as they come, in double, and the status.
struct Answer {
  oracle::Vector<double> qdd;
  axial::Status status;
};

Answer solve(const cases::Scenario& scenario, Route route, Scalar scalar);

}  // namespace stability
