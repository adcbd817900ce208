// Every kernel's exact result by the oracle, and what its errors are relative to.
#pragma once

#include <host_sim/robots/robot.hpp>

#include <string>
#include <vector>

namespace host_sim {

using Values = std::vector<double>;

/// Result of a kernel in 113-bit precision, rounded to double, in the kernels image's order. `torque` is the input of
/// forward dynamics. Throws std::runtime_error for an unknown kernel.
Values exact_result(const std::string& kernel, const Robot& robot, const SetPoint& state, const Values& torque);

/// What the error of each number is divided by, given the exact results of all states: for torques and accelerations
/// joint_scales() of the largest; for M(i, j) sqrt(M(i, i) M(j, j)), each at its largest; for directions 1; for
/// positions and linear Jacobian columns the largest of all.
Values error_scales(const std::string& kernel, const std::vector<Values>& exact);

}  // namespace host_sim
