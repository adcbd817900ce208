// A robot that follows a motion, and what its controller sees of it: quantised encoders, noisy torques.
#pragma once

#include <host_sim/plants/collide/motion.hpp>
#include <host_sim/plants/collide/plant.hpp>

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
  using Moved = axial::Joints<Moving, double>;
  using Inputs = axial::Inputs<MovingScene, double>;

  explicit Arm(unsigned seed, double share = 0.6) : noise_(seed), motion_(noise_, share) {
    Values q{}, qd{}, qdd{};
    motion_.at(0.0, q, qd, qdd);
    for (int i = 0; i < joints; ++i)
      q_[i] = q[i], qd_[i] = qd[i];
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
  void move(const Values& external, const Inputs& in = {}) {
    const Moved tau = efforts(external);
    advance<MovingScene>(q_, qd_, tau, in, period);
  }
  /// A tick on of two arms, whose plants are lanes of a batch: what move() does to each.
  static void move_both(Arm (&arms)[2], const Values (&external)[2], const Inputs (&in)[2] = {}) {
    const Moved tau[] = {arms[0].efforts(external[0]), arms[1].efforts(external[1])};
    Moved q[] = {arms[0].q_, arms[1].q_}, qd[] = {arms[0].qd_, arms[1].qd_};
    advance_both<MovingScene>(q, qd, tau, in, period);
    for (int k = 0; k < 2; ++k)
      arms[k].q_ = q[k], arms[k].qd_ = qd[k];
  }
  /// Where the plant is: rad.
  const Moved& positions() const { return q_; }

 private:
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
  // What acts on the plant for a tick: the command within its limits, and what is outside.
  Moved efforts(const Values& external) {
    const Values wanted = command();
    Moved tau{};
    for (int i = 0; i < joints; ++i) {
      const double limit = Known::chain.links[i].effort_limit;
      const double given = std::fmin(std::fmax(wanted[i], -limit), limit);
      seen_.tau[i] = std::fmin(std::fmax(given + torque_noise * limit * noise_.gaussian(), -limit), limit);
      tau[i] = given + external[i];
    }
    ++ticks_;
    return tau;
  }

  Noise noise_;
  Motion<Known> motion_;
  Moved q_{}, qd_{};
  Values past_[window]{};
  Measured<Known> seen_;
  long ticks_ = 0;
};

}  // namespace host_sim::collide
