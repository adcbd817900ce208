// What the errors of a kernel's numbers are relative to.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace host_sim {

using Values = std::vector<double>;

/// A vector or a matrix among the numbers of a kernel that has several, by the name of the library's member.
struct ResultBlock {
  std::string name;
  std::size_t count;  ///< numbers: of a symmetric matrix those of its lower triangle
};

/// In the order of the numbers, of derivatives and of motors behind springs; none for other kernels.
std::vector<ResultBlock> blocks_of(const std::string& kernel, std::size_t joints);

/// What the error of each number is divided by, given the exact results of all states: for torques and accelerations
/// joint_scales() of the largest; for M(i, j) sqrt(M(i, i) M(j, j)), each at its largest; for directions 1; for
/// positions and linear Jacobian columns the largest of all; for kernels of several blocks the largest of the vector or
/// matrix.
Values error_scales(const std::string& kernel, const std::vector<Values>& exact);

}  // namespace host_sim
