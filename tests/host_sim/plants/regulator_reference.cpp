#include "regulator_reference.hpp"

#include <oracle/from_axial.hpp>
#include <oracle/lagrange.hpp>

#include <Eigen/Dense>

#include <cmath>

#include <robots/puma560.hpp>
#include <robots/scara.hpp>

namespace regulator_reference {

// In sources of their own: together a compiler takes over a gigabyte for them.
Eigen::MatrixXd exponential(const Eigen::MatrixXd& m);
Eigen::MatrixXd solved(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B, const Eigen::MatrixXd& Q,
                       const Eigen::MatrixXd& R);

namespace {

using oracle::quad;
using Dense = Eigen::MatrixXd;
using Vector = std::vector<double>;

constexpr double T = 1e-3;

oracle::Vector<quad> exact(const Vector& from) { return {from.begin(), from.end()}; }

/// d qdd / d (q, qd, tau) where the arm moves so.
template <class Robot>
Dense accelerations_by_state_and_effort(const Motion& at) {
  const auto chain = oracle::of_robot<quad, Robot>();
  const auto q = exact(at.q), qd = exact(at.qd), tau = oracle::inverse_dynamics(chain, q, qd, exact(at.qdd));
  const auto n = at.q.size();
  const quad h = quad(1) / quad(1LL << 36);
  Dense slopes(n, 3 * n);
  for (std::size_t j = 0; j < 3 * n; ++j) {
    oracle::Vector<quad> low[] = {q, qd, tau}, high[] = {q, qd, tau};
    low[j / n][j % n] -= h, high[j / n][j % n] += h;
    const auto below = oracle::forward_dynamics(chain, low[0], low[1], low[2]),
               above = oracle::forward_dynamics(chain, high[0], high[1], high[2]);
    for (std::size_t i = 0; i < n; ++i)
      slopes(static_cast<int>(i), static_cast<int>(j)) = static_cast<double>((above[i] - below[i]) / (h + h));
  }
  return slopes;
}

struct Step {
  Dense A, B;
};
/// Over a tick in which the effort is held.
template <class Robot>
Step zero_order_hold(const Motion& at) {
  const auto n = static_cast<int>(at.q.size());
  Dense rates = Dense::Zero(3 * n, 3 * n);
  rates.block(0, n, n, n).setIdentity();
  rates.block(n, 0, n, 3 * n) = accelerations_by_state_and_effort<Robot>(at);
  const Dense after = exponential(T * rates);
  return {after.topLeftCorner(2 * n, 2 * n), after.topRightCorner(2 * n, n)};
}

Dense diagonal(const Vector& entries) {
  return Eigen::Map<const Eigen::VectorXd>(entries.data(), static_cast<Eigen::Index>(entries.size())).asDiagonal();
}

}  // namespace

template <class Robot>
Vector gains(const Motion& at, const Weights& weights) {
  const Step step = zero_order_hold<Robot>(at);
  const Dense K = solved(step.A, step.B, diagonal(weights.state), diagonal(weights.effort));
  Vector rows;
  for (Eigen::Index i = 0; i < K.rows(); ++i)
    for (Eigen::Index j = 0; j < K.cols(); ++j)
      rows.push_back(K(i, j));
  return rows;
}
template Vector gains<robots::Scara>(const Motion&, const Weights&);
template Vector gains<robots::Puma560>(const Motion&, const Weights&);

}  // namespace regulator_reference
