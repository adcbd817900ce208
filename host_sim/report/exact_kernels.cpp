#include <host_sim/report/exact_kernels.hpp>

#include <host_sim/analysis/joint_scales.hpp>

#include <oracle/lagrange.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace host_sim {

namespace {

using oracle::quad;
using Vector = oracle::Vector<quad>;

struct Inputs {
  const oracle::Chain<quad>& chain;
  Vector q, qd, qdd, torque;
};

Vector joined(const Vector& a, const Vector& b) {
  Vector sum = a;
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] += b[i];
  return sum;
}

void append(Vector& values, const oracle::Vec3<quad>& v) { values.insert(values.end(), {v.x, v.y, v.z}); }

Vector inverse_dynamics(const Inputs& in) { return oracle::inverse_dynamics(in.chain, in.q, in.qd, in.qdd); }
Vector bias(const Inputs& in) {
  return joined(oracle::coriolis_torque(in.chain, in.q, in.qd), oracle::gravity_torque(in.chain, in.q));
}
Vector gravity(const Inputs& in) { return oracle::gravity_torque(in.chain, in.q); }
Vector forward_dynamics(const Inputs& in) { return oracle::forward_dynamics(in.chain, in.q, in.qd, in.torque); }

Vector mass_matrix(const Inputs& in) {
  const auto M = oracle::mass_matrix(in.chain, in.q);
  Vector lower;
  for (int i = 0; i < M.rows(); ++i)
    for (int j = 0; j <= i; ++j)
      lower.push_back(M(i, j));
  return lower;
}

/// The rotation matrix by rows, then the position.
Vector forward_kinematics(const Inputs& in) {
  const auto tool = oracle::tool_pose(in.chain, in.q);
  const auto rows = oracle::transpose(tool.rotation);
  Vector values;
  for (const auto& part : {rows.c0, rows.c1, rows.c2, tool.position})
    append(values, part);
  return values;
}

Vector jacobian(const Inputs& in) {
  const auto J = oracle::tool_jacobian(in.chain, in.q);
  Vector values;
  for (int j = 0; j < in.chain.size(); ++j)
    for (const auto* part : {&J.angular, &J.linear})
      append(values, {(*part)(0, j), (*part)(1, j), (*part)(2, j)});
  return values;
}

using Kernel = Vector (*)(const Inputs&);
const std::map<std::string, Kernel> kernels = {{"inverse_dynamics", inverse_dynamics},
                                               {"closed_form", inverse_dynamics},
                                               {"separation", inverse_dynamics},
                                               {"bias", bias},
                                               {"gravity", gravity},
                                               {"mass_matrix", mass_matrix},
                                               {"forward_dynamics", forward_dynamics},
                                               {"jacobian", jacobian},
                                               {"forward_kinematics", forward_kinematics}};

Vector widened(const Values& values) { return {values.begin(), values.end()}; }

/// Largest magnitude of each number over all states.
Values largest_of(const std::vector<Values>& exact) {
  Values largest(exact.front().size(), 0.0);
  for (const Values& values : exact)
    for (std::size_t i = 0; i < largest.size(); ++i)
      largest[i] = std::max(largest[i], std::abs(values[i]));
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

}  // namespace

Values exact_result(const std::string& kernel, const Robot& robot, const SetPoint& state, const Values& torque) {
  const auto found = kernels.find(kernel);
  if (found == kernels.end()) throw std::runtime_error("the oracle does not know the kernel " + kernel);
  const Inputs in{robot.chain, widened(state.q), widened(state.qd), widened(state.qdd), widened(torque)};
  Values values;
  for (const quad& value : found->second(in))
    values.push_back(static_cast<double>(value));
  return values;
}

Values error_scales(const std::string& kernel, const std::vector<Values>& exact) {
  const Values largest = largest_of(exact);
  if (kernel == "mass_matrix") return mass_matrix_scales(largest);
  if (kernel == "jacobian") return geometry_scales(largest, [](std::size_t i) { return i % 6 >= 3; });
  if (kernel == "forward_kinematics") return geometry_scales(largest, [](std::size_t i) { return i >= 9; });
  return joint_scales(largest);
}

}  // namespace host_sim
