#include <host_sim/tools/analysis/error_scales.hpp>

#include <host_sim/tools/analysis/joint_scales.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <algorithm>
#include <cmath>

namespace host_sim {

namespace {

/// Largest magnitude of each number over all states.
Values largest_of(const std::vector<Values>& exact) {
  Values largest(exact.front().size(), 0.0);
  for (const Values& values : exact)
    for (std::size_t i = 0; i < largest.size(); ++i)
      note_size(largest[i], values[i]);
  return largest;
}

/// Rows of the lower triangle: entry (i, j) is number i (i + 1) / 2 + j.
Values mass_matrix_scales(const Values& largest) {
  const auto diagonal = [&](std::size_t i) { return largest[i * (i + 1) / 2 + i]; };
  Values scales;
  for (std::size_t i = 0; scales.size() < largest.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      scales.push_back(std::sqrt(diagonal(i) * diagonal(j)));
  return scales;
}

/// Numbers that `is_length` picks share the largest of them; the rest are parts of unit vectors.
template <class Predicate>
Values geometry_scales(const Values& largest, Predicate is_length) {
  double longest = 0.0;
  for (std::size_t i = 0; i < largest.size(); ++i)
    if (is_length(i)) longest = std::max(longest, largest[i]);
  Values scales;
  for (std::size_t i = 0; i < largest.size(); ++i)
    scales.push_back(is_length(i) ? longest : 1.0);
  return scales;
}

std::size_t numbers_of(const std::vector<ResultBlock>& blocks) {
  std::size_t sum = 0;
  for (const ResultBlock& block : blocks)
    sum += block.count;
  return sum;
}

/// Every number of a block is relative to its largest.
Values block_scales(const std::string& kernel, const Values& largest) {
  std::size_t n = 1;
  while (numbers_of(blocks_of(kernel, n)) < largest.size())
    ++n;
  Values scales;
  auto begin = largest.begin();
  for (const ResultBlock& block : blocks_of(kernel, n)) {
    const auto end = begin + static_cast<std::ptrdiff_t>(block.count);
    scales.insert(scales.end(), block.count, *std::max_element(begin, end));
    begin = end;
  }
  return scales;
}

}  // namespace

std::vector<ResultBlock> blocks_of(const std::string& kernel, std::size_t joints) {
  const std::size_t n = joints, triangle = n * (n + 1) / 2;
  if (kernel == "inverse_dynamics_derivatives")
    return {{"tau", n}, {"M", triangle}, {"dtau_dq", n * n}, {"dtau_dqd", n * n}};
  if (kernel == "forward_dynamics_derivatives")
    return {{"M_inverse", triangle}, {"dqdd_dq", n * n}, {"dqdd_dqd", n * n}, {"qdd", n}};
  if (kernel == "elastic_feedforward") return {{"tau_m", n}, {"theta", n}, {"thetad", n}, {"tau_l", n}};
  return {};
}

Values error_scales(const std::string& kernel, const std::vector<Values>& exact) {
  const Values largest = largest_of(exact);
  if (kernel == "mass_matrix") return mass_matrix_scales(largest);
  if (kernel == "jacobian") return geometry_scales(largest, [](std::size_t i) { return i % 6 >= 3; });
  if (kernel == "forward_kinematics") return geometry_scales(largest, [](std::size_t i) { return i >= 9; });
  if (!blocks_of(kernel, 1).empty()) return block_scales(kernel, largest);
  return joint_scales(largest);
}

}  // namespace host_sim
