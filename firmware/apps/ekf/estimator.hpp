#pragma once
/// Positions and velocities of an arm from its encoders and the efforts that act on it.

#include <axial/axial.hpp>

#include <firmware/apps/lqr/linear_step.hpp>
#include <firmware/apps/lqr/riccati.hpp>

namespace axial::apps {

/// What the filter believes of the arm: standard deviations.
template <int N>
struct StateNoise {
  float encoder[N];       ///< rad or m, of a measured position
  float acceleration[N];  ///< rad/s^2 or m/s^2, of what the model leaves out, anew each tick
  float speed[N];         ///< rad/s or m/s, of a velocity about which nothing is known yet
};

/// Extended Kalman filter of x = (q, qd) in ticks of T seconds: forward dynamics predicts, its derivatives carry the
/// covariance, encoders correct (B. Anderson, J. Moore, "Optimal Filtering", 1979, section 8.2). The covariance's step
/// is the regulator's Riccati step, transposed. Constant time.
template <class S>
class StateEstimator {
  static constexpr int n = joint_count<S>;
  using Robot = robot_of<S>;

 public:
  constexpr StateEstimator(const StateNoise<n>& noise, float T) : noise_(noise), T_(T) {
    for (int i = 0; i < n; ++i) {
      C_(i, i) = 1.0F;
      r_[i] = noise.encoder[i] * noise.encoder[i];
      const float change = T * noise.acceleration[i];
      w_[i] = 0.25F * T * T * change * change, w_[n + i] = change * change;
    }
  }

  /// At rest where the encoders say.
  constexpr void begin(const Positions<Robot, float>& measured) {
    q_ = measured, qd_ = {}, P_ = {};
    for (int i = 0; i < n; ++i)
      P_(i, i) = r_[i], P_(n + i, n + i) = noise_.speed[i] * noise_.speed[i];
  }

  /// x += P C^T (C P C^T + R)^-1 (measured - q), where C picks the positions.
  constexpr void correct(const Positions<Robot, float>& measured) {
    Matrix<n, n> spread;
    Matrix<n, 1> off;
    for (int i = 0; i < n; ++i) {
      off(i, 0) = measured[i] - q_[i];
      for (int j = 0; j < n; ++j)
        spread(i, j) = P_(i, j);
      spread(i, i) += r_[i];
    }
    const Matrix<n, 1> weighed = solve(spread, off);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        q_[i] += P_(i, j) * weighed(j, 0), qd_[i] += P_(n + i, j) * weighed(j, 0);
  }

  /// A tick under efforts `tau`, N m or N, after correct(). Where the status is not met nothing has changed.
  constexpr Status predict(const EffortsOf<S, float>& tau) {
    const auto d = forward_dynamics_derivatives<S>(q_, qd_, tau);
    if (!d.qdd.status.met()) return d.qdd.status;
    (void)riccati_step(P_, transpose(linear_step(d, T_).A), C_, w_, r_);
    for (int i = 0; i < n; ++i) {
      q_[i] += T_ * qd_[i] + 0.5F * T_ * T_ * d.qdd[i];
      qd_[i] += T_ * d.qdd[i];
    }
    return d.qdd.status;
  }

  constexpr const Positions<Robot, float>& q() const { return q_; }     ///< rad or m
  constexpr const Velocities<Robot, float>& qd() const { return qd_; }  ///< rad/s or m/s

  /// Of q_i, or of qd_(i - n): what the filter believes of its error.
  constexpr float variance(int i) const { return P_(i, i); }

 private:
  StateNoise<n> noise_;
  float T_, w_[2 * n] = {}, r_[n] = {};
  Matrix<2 * n, n> C_;  ///< transposed
  Matrix<2 * n, 2 * n> P_;
  Positions<Robot, float> q_{};
  Velocities<Robot, float> qd_{};
};

}  // namespace axial::apps
