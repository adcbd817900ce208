// The gains of a linear-quadratic regulator in double, by other means than the firmware's: the arm linearised by
// differences of the oracle, discretised by a matrix exponential, the equation solved by eigenvectors (Eigen).
#pragma once

#include <vector>

namespace regulator_reference {

/// rad or m, and their derivatives by time.
struct Motion {
  std::vector<double> q, qd, qdd;
};

/// Diagonals of the weights.
struct Weights {
  std::vector<double> state, effort;
};

/// K of the algebraic Riccati equation, n x 2n, row by row, for ticks of a millisecond around the motion. For Scara and
/// Puma560.
template <class Robot>
std::vector<double> gains(const Motion& at, const Weights& weights);

}  // namespace regulator_reference
