// A robot that follows a motion, and what its controller sees of it: quantised encoders, noisy torques.
#pragma once

#include <axial/dynamics/forward_dynamics.hpp>
#include <host_sim/collide/motion.hpp>

namespace host_sim::collide {

inline constexpr double period = 1e-3;  ///< s, of a tick
inline constexpr int window = 4;        ///< ticks over which a velocity is the encoder's difference
inline constexpr double encoder_step = 6.283185307179586 / 1048576.0;  ///< rad: 2^20 counts a turn of the joint
inline constexpr double torque_noise = 0.005;  ///< deviation of a measured torque, of the joint's effort limit

/// What a controller knows at a tick; the torque is that of the last tick.
template <class Robot>
struct Measured {
  axial::Joints<Robot, double> q{}, qd{}, tau{};
};

/// The plant `Moving` under the feed-forward of the model `Known` and a weak feedback, in double by one Runge-Kutta
/// step a tick under a held torque. `Scene` templates name what both consist of.
template <class Known, class Moving, class KnownScene, class MovingScene>
class Arm {
 public:
  static constexpr int joints = Known::chain.size;
  using Values = axial::Joints<Known, double>;

  explicit Arm(unsigned seed, double share = 0.6) : noise_(seed), motion_(noise_, share) {
    Values qdd{};
    motion_.at(0.0, q_, qd_, qdd);
    for (int k = window; k > 0; --k)
      remember(quantised(-k * period));
  }
  /// What the encoders say now.
  const Measured<Known>& measure() {
    seen_.q = quantised(0.0);
    for (int i = 0; i < joints; ++i)
      seen_.qd[i] = (seen_.q[i] - past_[0][i]) / (window * period);
    remember(seen_.q);
    return seen_;
  }
  /// A tick on, with external efforts; `in` loads the plant.
  void move(const Values& external, const axial::Inputs<MovingScene, double>& in = {}) {
    Values tau = command();
    for (int i = 0; i < joints; ++i) {
      const double limit = Known::chain.links[i].effort_limit;
      tau[i] = std::fmin(std::fmax(tau[i], -limit), limit);
      seen_.tau[i] = std::fmin(std::fmax(tau[i] + torque_noise * limit * noise_.gaussian(), -limit), limit);
      tau[i] += external[i];
    }
    step(tau, in);
    ++ticks_;
  }

 private:
  using Moved = axial::Joints<Moving, double>;

  // At a time (s) from now, at the present speed.
  Values quantised(double time) const {
    Values q{};
    for (int i = 0; i < joints; ++i)
      q[i] = std::nearbyint((q_[i] + time * qd_[i]) / encoder_step) * encoder_step;
    return q;
  }
  void remember(const Values& q) {
    for (int k = 1; k < window; ++k)
      past_[k - 1] = past_[k];
    past_[window - 1] = q;
  }
  Values command() const {
    Values q{}, qd{}, qdd{};
    motion_.at(static_cast<double>(ticks_) * period, q, qd, qdd);
    Values tau = axial::inverse_dynamics<KnownScene>(q, qd, qdd);
    for (int i = 0; i < joints; ++i) {
      const double strength = std::fmin(Known::chain.links[i].effort_limit, 100.0);
      tau[i] += strength * (2.0 * (q[i] - seen_.q[i]) + 0.12 * (qd[i] - seen_.qd[i]));
    }
    return tau;
  }
  Moved acceleration(const Moved& q, const Moved& qd, const Moved& tau,
                     const axial::Inputs<MovingScene, double>& in) const {
    const auto answer = axial::forward_dynamics<MovingScene>(q, qd, tau, in);
    Moved qdd{};
    for (int i = 0; i < joints; ++i)
      qdd[i] = answer[i];
    return qdd;
  }
  static Moved moved(const Moved& x, const Moved& rate, double time) {
    Moved y{};
    for (int i = 0; i < joints; ++i)
      y[i] = x[i] + time * rate[i];
    return y;
  }
  void step(const Values& effort, const axial::Inputs<MovingScene, double>& in) {
    Moved q{}, v{}, tau{};
    for (int i = 0; i < joints; ++i)
      q[i] = q_[i], v[i] = qd_[i], tau[i] = effort[i];
    const double h = period;
    const Moved a1 = acceleration(q, v, tau, in), v2 = moved(v, a1, 0.5 * h);
    const Moved a2 = acceleration(moved(q, v, 0.5 * h), v2, tau, in), v3 = moved(v, a2, 0.5 * h);
    const Moved a3 = acceleration(moved(q, v2, 0.5 * h), v3, tau, in), v4 = moved(v, a3, h);
    const Moved a4 = acceleration(moved(q, v3, h), v4, tau, in);
    for (int i = 0; i < joints; ++i) {
      q_[i] += h / 6.0 * (v[i] + 2.0 * v2[i] + 2.0 * v3[i] + v4[i]);
      qd_[i] += h / 6.0 * (a1[i] + 2.0 * a2[i] + 2.0 * a3[i] + a4[i]);
    }
  }

  Noise noise_;
  Motion<Known> motion_;
  Values q_{}, qd_{}, past_[window]{};
  Measured<Known> seen_;
  long ticks_ = 0;
};

}  // namespace host_sim::collide
