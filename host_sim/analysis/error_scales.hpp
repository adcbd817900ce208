// What the errors of a kernel's numbers are relative to.
#pragma once

#include <string>
#include <vector>

namespace host_sim {

using Values = std::vector<double>;

/// What the error of each number is divided by, given the exact results of all states: for torques and accelerations
/// joint_scales() of the largest; for M(i, j) sqrt(M(i, i) M(j, j)), each at its largest; for directions 1; for
/// positions and linear Jacobian columns the largest of all.
Values error_scales(const std::string& kernel, const std::vector<Values>& exact);

}  // namespace host_sim
