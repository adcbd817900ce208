#pragma once
/// A linear-quadratic regulator along any motion, whose gains the board computes.

#include <firmware/apps/tracking/controller.hpp>

#include "linear_step.hpp"
#include "riccati.hpp"
#include "weights.hpp"

namespace axial::apps {

/// tau = tau_ff(wanted) - K(t) (x - x_wanted), x = (q, qd), cut to the declared efforts. Each tick linearises the arm
/// at the wanted motion and takes one step of the Riccati equation, from where the last one ended: P follows the
/// solution that belongs to the present posture (A. Prach, O. Tekinalp, D. Bernstein, "Infinite-horizon
/// linear-quadratic control by forward propagation of the differential Riccati equation", IEEE Control Systems Magazine
/// 35(2), 2015). P begins at zero, so feedback comes up without a step, within some hundredths of a second. Constant
/// time. Velocities are differences of the error, as in the tracking image.
template <class Scene>
class LqrController : public TrackingController<Scene, float> {
  using Tracking = TrackingController<Scene, float>;
  using Plain = Controller<Scene, float>;
  using Values = typename scene_of<Scene>::Robot;  // what has values: joints, or drives that they share
  static constexpr int n = Values::chain.size;

 public:
  void compute() {
    Plain::compute();
    this->sum_ = this->result_.tau;
    if (this->met()) update_gains();
    if (this->met()) add(std::make_integer_sequence<int, n>{});
  }

  void restart() {
    Tracking::restart();
    P_ = {};
  }

  /// K of the last tick: N m/rad and N m s/rad, N/m and N s/m.
  const Matrix<n, 2 * n>& gains() const { return K_; }

 private:
  struct Weights {
    float state[2 * n], effort[n];
  };
  static constexpr Weights make_weights() {
    Weights w{};
    for (int i = 0; i < n; ++i) {
      w.state[i] = static_cast<float>(position_weight(is_in_metres<Scene>(i)));
      w.effort[i] = static_cast<float>(effort_weight(Values::chain.links[i].effort_limit));
    }
    return w;
  }
  static constexpr Weights weights = make_weights();

  void update_gains() {
    const auto& wanted = this->request_;
    const auto d = forward_dynamics_derivatives<Scene>(wanted.q, wanted.qd, this->result_.tau);
    if (!d.qdd.status.met()) {
      this->result_.status = d.qdd.status;
      return;
    }
    const auto step = linear_step(d, 1.0F / control_Hz);
    K_ = riccati_step(P_, step.A, step.B, weights.state, weights.effort);
  }

  template <int... I>
  void add(std::integer_sequence<int, I...>) {
    if (!this->feeds_forward_) this->sum_ = {};
    const float errors[] = {this->template tracking_error<I>()...};
    for (int i = 0; i < n; ++i) {
      const float rate = this->started_ ? control_Hz * (errors[i] - this->last_[i]) : 0.0F;
      for (int k = 0; k < n; ++k)
        this->sum_[k] += K_(k, i) * errors[i] + K_(k, n + i) * rate;
      this->last_[i] = errors[i];
    }
    (void)detail::clamp_efforts<Scene>(this->sum_);  // what the wire tells is whether the feed-forward was cut
    this->started_ = true;
  }

  Matrix<2 * n, 2 * n> P_;
  Matrix<n, 2 * n> K_;
};

}  // namespace axial::apps
