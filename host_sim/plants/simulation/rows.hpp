// Stability scenarios of motions: integrators on stiff, chaotic and long ones, each with its gate.
#pragma once

#include <host_sim/plants/simulation/integrate.hpp>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>
#include <vector>

namespace host_sim::simulation {

struct Row {
  std::string scenario, scalar, route;  ///< route: the integrator, "compensated" where its sums are
  double step = 0.0, seconds = 0.0;
  std::string quantity;  ///< what `error` is, with its unit
  double error = 0.0;
  double gate = 0.0;  ///< infinity: none
  bool pass = false;
  std::string status;  ///< ok, diverged (as it must), or what went wrong
};

/// What is measured, and how it is called.
struct MotionScenario {
  std::string name;
  std::function<std::vector<Row>()> measure;
  bool slow = false;  ///< takes more than a few seconds
};

/// ST18 to ST24: A01, double pendulum, ten rods, babyboot, joint springs, contact leg, float at rest, float's clock,
/// elastic joints, shared drives.
std::vector<MotionScenario> motion_scenarios();

/// ST23: a Puma 560 whose joints are elastic tends to the rigid one as their stiffness grows over 40 binary orders.
std::vector<Row> elastic_limit();

/// ST24: what Runge-Kutta steps make of the energy of robots whose joints share drives.
std::vector<Row> shared_drives();

/// With the fields that every machine-readable `stability` has; what is not finite is null.
nlohmann::json to_json(const std::vector<Row>& rows);

/// A row that passes where its error is finite and at most the gate.
Row gated(Row row);

}  // namespace host_sim::simulation
