#include <host_sim/on_board/exact_kernels.hpp>

#include <oracle/lagrange.hpp>

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

}  // namespace host_sim
