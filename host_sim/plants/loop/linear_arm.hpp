// An arm linearised along its cycle and discretised, in double: what other programs regulate it by.
#pragma once

#include <host_sim/robots/trajectory/set_point.hpp>

#include <string>
#include <vector>

namespace host_sim::loop {

/// Row by row.
struct Table2 {
  int rows = 0, columns = 0;
  std::vector<double> values;
  double operator()(int i, int j) const {
    return values[static_cast<std::size_t>(i) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(j)];
  }
};

/// dx' = A dx + B du a tick later, for small deviations dx of x = (q, qd) from the motion and du of the efforts that it
/// takes, which are held in between. Where joints share drives all are the drives', with their own limits: those of
/// joints that several move are not linear bounds of one state, and are left out.
struct LinearArm {
  std::string robot;
  SetPoint at;                                       ///< where in the cycle, and how it moves there
  double tick = 0.0;                                 ///< s
  std::vector<double> tau;                           ///< N m or N, that the motion takes
  Table2 A, B;                                       ///< 2n x 2n and 2n x n
  std::vector<double> Q, R;                          ///< diagonal weights, those of firmware/apps/lqr
  std::vector<double> low_x, high_x, low_u, high_u;  ///< declared limits less the motion's
};

/// At `time` s into the cycle of host_sim/robots/trajectories, without friction; d qdd by
/// axial::forward_dynamics_derivatives, the zero-order hold by a matrix exponential. Throws std::runtime_error that
/// says what is wrong.
LinearArm linear_arm(const std::string& robot, double time, double tick);

/// A header with a problem of so many stages in the layout of TinyMPC's examples: Adyn_data and Bdyn_data row by row,
/// Q_data and R_data the diagonals, x_min_data and so on one stage of the bounds.
std::string tinympc_header(const LinearArm& arm, int stages, double rho);

}  // namespace host_sim::loop
