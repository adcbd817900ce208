// Payloads of a simulated Panda and Puma 560: how well the estimator weighs them.
#pragma once

#include <string>
#include <vector>

namespace host_sim::collide {

/// One payload on one robot.
struct PayloadRow {
  std::string robot;
  double seconds = 0.0, mass = 0.0;             ///< s of motion; kg
  double mass_error = 0.0, moment_error = 0.0;  ///< kg, and kg m (norm)
  double mass_deviation = 0.0;                  ///< kg, as the estimator says
  double ready = 0.0;                           ///< s until the estimator was sure
  bool sure = false;
  int refused = 0;  ///< samples with a bad status
};

/// Payloads of several masses, their centre of mass some 0.16 m (Panda) or 0.12 m (Puma 560) from the last link's
/// origin.
std::vector<PayloadRow> weigh(double seconds, unsigned seed);

}  // namespace host_sim::collide
