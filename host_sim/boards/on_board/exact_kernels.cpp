#include <host_sim/boards/on_board/exact_kernels.hpp>

#include <oracle/compare.hpp>
#include <oracle/differences.hpp>
#include <oracle/lagrange.hpp>
#include <oracle/recursive.hpp>

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

Vector lower_triangle(const oracle::Matrix<quad>& M) {
  Vector lower;
  for (int i = 0; i < M.rows(); ++i)
    for (int j = 0; j <= i; ++j)
      lower.push_back(M(i, j));
  return lower;
}

Vector mass_matrix(const Inputs& in) { return lower_triangle(oracle::mass_matrix(in.chain, in.q)); }

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

/// Column by column.
oracle::Matrix<quad> inverse_of(const oracle::Matrix<quad>& M) {
  oracle::Matrix<quad> inverse(M.rows(), M.rows());
  for (int j = 0; j < M.rows(); ++j) {
    Vector unit(std::size_t(M.rows()), quad(0));
    unit[std::size_t(j)] = quad(1);
    const Vector column = oracle::solve(M, unit);
    for (int i = 0; i < M.rows(); ++i)
      inverse(i, j) = column[std::size_t(i)];
  }
  return inverse;
}

void append(Vector& values, const Vector& more) { values.insert(values.end(), more.begin(), more.end()); }

/// The lower triangle of a symmetric matrix, and the Jacobians of f(q, qd) row by row.
template <class F>
Vector matrices(const Inputs& in, const oracle::Matrix<quad>& symmetric, const F& f) {
  const auto slopes = oracle::differences(in.q, in.qd, f);
  Vector values = lower_triangle(symmetric);
  append(values, oracle::elements(slopes.by_position));
  append(values, oracle::elements(slopes.by_velocity));
  return values;
}
Vector inverse_dynamics_derivatives(const Inputs& in) {
  Vector values = inverse_dynamics(in);
  append(values, matrices(in, oracle::mass_matrix(in.chain, in.q), [&](const Vector& q, const Vector& qd) {
           return oracle::recursive_inverse_dynamics(in.chain, q, qd, in.qdd);
         }));
  return values;
}
Vector forward_dynamics_derivatives(const Inputs& in) {
  const auto acceleration = [&](const Vector& q, const Vector& qd) {
    return oracle::recursive_forward_dynamics(in.chain, q, qd, in.torque);
  };
  Vector values = matrices(in, inverse_of(oracle::mass_matrix(in.chain, in.q)), acceleration);
  append(values, forward_dynamics(in));
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
                                               {"forward_kinematics", forward_kinematics},
                                               {"inverse_dynamics_derivatives", inverse_dynamics_derivatives},
                                               {"forward_dynamics_derivatives", forward_dynamics_derivatives}};

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
