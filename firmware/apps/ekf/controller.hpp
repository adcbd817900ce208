#pragma once
/// The tracking image's feedback, of what an extended Kalman filter makes of the encoders.

#include <firmware/apps/tracking/controller.hpp>

#include "estimator.hpp"

namespace axial::apps {

/// Encoders of so many bits a turn; a slide's steps of so many metres.
constexpr int encoder_bits = 14;
constexpr double slide_step_m = 1.0 / (1 << encoder_bits);
/// What the model leaves out, as a share of the declared acceleration limits.
constexpr double unknown_acceleration = 0.4;

/// tau = tau_ff + Kp (q_wanted - q) + Kd (qd_wanted - qd), cut to the declared efforts, with q and qd from the filter.
/// Each tick corrects by the encoders, then predicts with the efforts that are sent. After a pause it begins anew.
template <class Scene>
class EkfController : public TrackingController<Scene, float> {
  using Tracking = TrackingController<Scene, float>;
  using Plain = Controller<Scene, float>;
  using Robot = robot_of<Scene>;
  using Values = typename scene_of<Scene>::Robot;  // what has values: joints, or drives that they share
  static constexpr int n = Values::chain.size;
  static constexpr Gains<n> gains = tracking_gains<Scene>();

 public:
  void compute() {
    Plain::compute();
    this->sum_ = this->result_.tau;
    if (!this->met()) return;
    observe(std::make_integer_sequence<int, n>{});
    add();
    const Status predicted = estimator_.predict(this->sum_);
    if (!predicted.met()) this->result_.status = predicted;
  }

  /// What the filter knew after the last measurement: rad/s or m/s.
  const Velocities<Robot, float>& velocity() const { return seen_; }

 private:
  static constexpr StateNoise<n> make_noise() {
    StateNoise<n> noise{};
    for (int i = 0; i < n; ++i) {
      const auto& link = Values::chain.links[i];
      constexpr double count_rad = 2.0 * 3.14159265358979323846 / (1 << encoder_bits);
      noise.encoder[i] = static_cast<float>(link.type == JointType::prismatic ? slide_step_m : count_rad);
      noise.acceleration[i] = static_cast<float>(unknown_acceleration * link.acceleration_limit);
      noise.speed[i] = static_cast<float>(link.speed_limit);
    }
    return noise;
  }

  /// Positions nearest to where they are wanted, so that an angle's turn does not matter.
  template <int... I>
  void observe(std::integer_sequence<int, I...>) {
    const Positions<Robot, float> measured{this->request_.q[I] - this->template tracking_error<I>()...};
    if (!this->started_) estimator_.begin(measured);
    estimator_.correct(measured);
    seen_ = estimator_.qd();
    this->started_ = true;
  }

  void add() {
    if (!this->feeds_forward_) this->sum_ = {};
    const auto& wanted = this->request_;
    for (int i = 0; i < n; ++i)
      this->sum_[i] += static_cast<float>(gains.stiffness[i]) * (wanted.q[i] - estimator_.q()[i]) +
                       static_cast<float>(gains.damping[i]) * (wanted.qd[i] - seen_[i]);
    (void)detail::clamp_efforts<Scene>(this->sum_);  // what the wire tells is whether the feed-forward was cut
  }

  StateEstimator<Scene> estimator_{make_noise(), 1.0F / control_Hz};
  Velocities<Robot, float> seen_{};
};

}  // namespace axial::apps
