// A motion without rest or repetition, and the noise of what measures it.
#pragma once

#include <axial/scene/joints.hpp>

#include <cmath>
#include <random>

namespace host_sim::collide {

/// Seeded noise that is the same with every standard library.
class Noise {
 public:
  explicit Noise(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  /// Gaussian, of deviation 1 (Box and Muller).
  double gaussian() {
    const double radius = std::sqrt(-2.0 * std::log(uniform(1e-12, 1.0)));
    return radius * std::cos(uniform(0.0, 6.283185307179586));
  }

 private:
  std::mt19937 engine_;
};

/// Every joint the sum of three sines of 0.05 to 0.4 Hz about the middle of its range, within a share of the declared
/// range, speed and acceleration.
template <class Robot>
class Motion {
 public:
  static constexpr int joints = Robot::chain.size;
  using Values = axial::Joints<Robot, double>;

  explicit Motion(Noise& noise, double share = 0.6) {
    for (int i = 0; i < joints; ++i) {
      const auto& limits = Robot::chain.links[i];
      double speed = 0.0, acceleration = 0.0;
      for (int k = 0; k < 3; ++k) {
        const double w = pace_[i][k] = 6.283185307179586 * noise.uniform(0.05, 0.4);
        phase_[i][k] = noise.uniform(0.0, 6.283185307179586);
        speed += w, acceleration += w * w;
      }
      const double low = std::fmax(limits.position_min, -3.0), high = std::fmin(limits.position_max, 3.0);
      middle_[i] = 0.5 * (low + high);
      size_[i] = share * std::fmin(std::fmin((high - low) / 6.0, limits.speed_limit / speed),
                                   limits.acceleration_limit / acceleration);
    }
  }
  void at(double time, Values& q, Values& qd, Values& qdd) const {
    for (int i = 0; i < joints; ++i) {
      q[i] = middle_[i], qd[i] = qdd[i] = 0.0;
      for (int k = 0; k < 3; ++k) {
        const double w = pace_[i][k], angle = w * time + phase_[i][k], size = size_[i];
        q[i] += size * std::sin(angle), qd[i] += size * w * std::cos(angle), qdd[i] -= size * w * w * std::sin(angle);
      }
    }
  }

 private:
  double pace_[joints][3] = {}, phase_[joints][3] = {}, middle_[joints] = {}, size_[joints] = {};
};

}  // namespace host_sim::collide
