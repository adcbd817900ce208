#include <host_sim/plants/loop/cycle.hpp>
#include <host_sim/plants/loop/linear_arm.hpp>
#include <host_sim/plants/simulation/models.hpp>

#include <firmware/apps/lqr/weights.hpp>

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace host_sim::loop {

namespace {

using Dense = Eigen::MatrixXd;

template <class Model>
axial::Joints<Model, double> values_of(const std::vector<double>& from) {
  axial::Joints<Model, double> to{};
  std::copy(from.begin(), from.end(), to.values);
  return to;
}

SetPoint point_of(const std::string& robot, double time) {
  const Trajectory cycle = cycle_of(robot);
  if (!(time >= 0.0)) throw std::runtime_error("the cycle begins at 0 s");
  return cycle[static_cast<std::size_t>(std::lround(time / control_tick)) % cycle.size()];
}

template <class Matrix>
void fill(Dense& into, int row, int column, int n, const Matrix& from) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      into(row + i, column + j) = from(i, j);
}

/// d/dt (q, qd, tau) = rates (q, qd, tau), tau held.
template <class Model>
Dense rates(const Model& model, const SetPoint& at, const axial::Joints<Model, double>& tau) {
  const int n = model.size(), all = 3 * n;
  const auto d = axial::forward_dynamics_derivatives(model, values_of<Model>(at.q), values_of<Model>(at.qd), tau, {});
  if (!d.qdd.status.met()) throw std::runtime_error("the arm has no accelerations there");
  Dense F = Dense::Zero(all, all);
  F.block(0, n, n, n).setIdentity();
  fill(F, n, 0, n, d.dqdd_dq), fill(F, n, n, n, d.dqdd_dqd), fill(F, n, 2 * n, n, d.M_inverse);
  return F;
}

Table2 table(const Dense& from) {
  Table2 to{static_cast<int>(from.rows()), static_cast<int>(from.cols()), {}};
  for (int i = 0; i < to.rows; ++i)
    for (int j = 0; j < to.columns; ++j)
      to.values.push_back(from(i, j));
  return to;
}

void add_limits(LinearArm& arm, const std::vector<axial::LinkParameters>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto& of = values[i];
    arm.low_x.push_back(of.position_min - arm.at.q[i]), arm.high_x.push_back(of.position_max - arm.at.q[i]);
    arm.low_u.push_back(-of.effort_limit - arm.tau[i]), arm.high_u.push_back(of.effort_limit - arm.tau[i]);
    arm.Q.push_back(axial::apps::position_weight(of.type == axial::JointType::prismatic)),
        arm.R.push_back(axial::apps::effort_weight(of.effort_limit));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    arm.low_x.push_back(-values[i].speed_limit - arm.at.qd[i]),
        arm.high_x.push_back(values[i].speed_limit - arm.at.qd[i]);
    arm.Q.push_back(0.0);
  }
}

/// The system of a model without friction, whatever its values belong to.
template <class Model>
LinearArm linearised(const std::string& robot, const Model& model, double time, double tick) {
  LinearArm arm;
  arm.robot = robot, arm.at = point_of(robot, time), arm.tick = tick;
  const auto tau = axial::inverse_dynamics(model, values_of<Model>(arm.at.q), values_of<Model>(arm.at.qd),
                                           values_of<Model>(arm.at.qdd), {});
  const int n = model.size();
  arm.tau.assign(tau.values, tau.values + n);
  const Dense after = (tick * rates(model, arm.at, tau)).exp();
  arm.A = table(after.topLeftCorner(2 * n, 2 * n)), arm.B = table(after.topRightCorner(2 * n, n));
  return arm;
}

}  // namespace

LinearArm linear_arm(const std::string& robot, double time, double tick) {
  auto links = simulation::robot_links(robot);
  for (auto& link : links)
    link.viscous = link.coulomb_forward = link.coulomb_backward = link.static_friction = 0.0;
  auto arm = simulation::shares_drives(robot) ? linearised(robot, simulation::driven_model_of(robot, links), time, tick)
                                              : linearised(robot, simulation::model_of(robot, links), time, tick);
  add_limits(arm, simulation::robot_values(robot));
  return arm;
}

namespace {

void write(std::ostream& out, const std::string& name, const std::string& size, const std::vector<double>& values,
           std::size_t per_line) {
  out << "tinytype " << name << "[" << size << "] = {";
  for (std::size_t k = 0; k < values.size(); ++k)
    out << (k == 0 ? "\n    " : k % per_line == 0 ? ",\n    " : ", ") << values[k];
  out << "};\n\n";
}

}  // namespace

std::string tinympc_header(const LinearArm& arm, int stages, double rho) {
  const auto n = arm.tau.size();
  std::ostringstream out;
  out.precision(17);
  out << "// " << arm.robot << " at " << arm.at.time
      << " s of its cycle: x = (q, qd) and u = tau, both less the motion's; a step is " << arm.tick
      << " s.\n// Adyn and Bdyn row by row: Map<Matrix<tinytype, NSTATES, NSTATES, RowMajor>>(Adyn_data). Bounds are "
         "those of one stage.\n"
      << "#pragma once\n\n#include <tinympc/types.hpp>\n\n"
      << "#define NSTATES " << 2 * n << "\n#define NINPUTS " << n << "\n#define NHORIZON " << stages << "\n\n"
      << "tinytype rho_value = " << rho << ";\n\n";
  write(out, "Adyn_data", "NSTATES * NSTATES", arm.A.values, 2 * n),
      write(out, "Bdyn_data", "NSTATES * NINPUTS", arm.B.values, n);
  write(out, "Q_data", "NSTATES", arm.Q, 2 * n), write(out, "R_data", "NINPUTS", arm.R, n);
  write(out, "x_min_data", "NSTATES", arm.low_x, 2 * n), write(out, "x_max_data", "NSTATES", arm.high_x, 2 * n);
  write(out, "u_min_data", "NINPUTS", arm.low_u, n), write(out, "u_max_data", "NINPUTS", arm.high_u, n);
  return out.str();
}

}  // namespace host_sim::loop
