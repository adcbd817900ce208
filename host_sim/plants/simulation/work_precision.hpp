// Error against work of the integrators: the same motions at many steps.
#pragma once

#include <host_sim/plants/simulation/reference.hpp>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>
#include <vector>

namespace host_sim::simulation {

/// Where a motion starts.
struct Start {
  Values<double> q{}, qd{};
};

/// A motion whose end every integrator is to reach.
struct Problem {
  std::string name, robot;  ///< smooth, springs, damped_springs, contact; the robot or the scenario's arm
  Model model;
  Start start;
  Drive<double> drive;  ///< none: moves freely
  double seconds = 0.0;
  bool stiff = false;    ///< references by backward differentiation
  bool by_float = true;  ///< the drive is nothing that only double has
};
std::vector<Problem> problems();

struct WorkRow {
  std::string subject, robot, scalar, variant;  ///< variant: the integrator, "compensated" where its sums are
  double step = 0.0, seconds = 0.0;
  double error = 0.0;  ///< largest |q - reference| of the joints at the end, rad or m; infinity: diverged
  long work = 0;       ///< evaluations of forward dynamics
  double time_ratio =
      0.0;              ///< host time over that of a reference kernel: forward dynamics of the puma560, in the same run
  bool pareto = false;  ///< no row of the problem is as exact for as little work
  std::string reference;  ///< who made it: cvode_bdf, arkode_erk, or rk4 with 16 times the evaluations
};

/// Tells `progress` the problems' names.
std::vector<WorkRow> work_precision(const std::function<void(const std::string&)>& progress);

/// With the fields that every machine-readable `report` has; the error of what diverged is the largest double.
nlohmann::json to_json(const std::vector<WorkRow>& rows);

}  // namespace host_sim::simulation
