#pragma once
/// Seeded states of a robot inside its declared limits, the same on every board and host.

#include <axial/axial.hpp>

#include <cstdint>

namespace axial::apps {

/// Marsaglia's xorshift32 (Journal of Statistical Software 8(14), 2003, triple 13, 17, 5).
class Random {
 public:
  constexpr explicit Random(std::uint32_t seed) : state_(seed) {}

  constexpr std::uint32_t bits() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_;
  }
  /// In [-1, 1), a multiple of 2^-23: exact in float.
  constexpr float symmetric() { return static_cast<float>(static_cast<std::int32_t>(bits()) >> 8) * 0x1p-23f; }

 private:
  std::uint32_t state_;
};

/// Desired motion of a robot: rad or m, rad/s or m/s, rad/s^2 or m/s^2.
template <class Robot, class T>
struct MotionState {
  Joints<Robot, T> q{}, qd{}, qdd{};
};

/// Middle and reach of what a joint may do; where the robot declares no limit, half a turn, 2 rad/s, 5 rad/s^2.
template <class Robot>
struct Reach {
  struct Joint {
    float middle, position, speed, acceleration;
  };
  Joint joints[joint_count<Robot>];
};

template <class Robot>
constexpr Reach<Robot> make_reach() {
  constexpr double unlimited = LinkParameters::unlimited;
  const auto or_else = [](double value, double other) { return value < unlimited ? value : other; };
  Reach<Robot> reach{};
  for (int i = 0; i < joint_count<Robot>; ++i) {
    const LinkParameters& p = scene_of<Robot>::Robot::chain.links[i];  // of a drive, where joints share them
    const double high = or_else(p.position_max, 3.140625), low = -or_else(-p.position_min, 3.140625);
    reach.joints[i] = {static_cast<float>((high + low) / 2), static_cast<float>((high - low) / 2),
                       static_cast<float>(or_else(p.speed_limit, 2.0)),
                       static_cast<float>(or_else(p.acceleration_limit, 5.0))};
  }
  return reach;
}

template <class Robot>
inline constexpr Reach<Robot> reach_of = make_reach<Robot>();

/// The next state. Every value is a float, also where T is double.
template <class Robot, class T>
constexpr MotionState<Robot, T> next_state(Random& random) {
  constexpr float inside = 0.999f;  // rounding must not leave the limits
  MotionState<Robot, T> state{};
  for (int i = 0; i < joint_count<Robot>; ++i) {
    const auto& joint = reach_of<Robot>.joints[i];
    state.q[i] = static_cast<T>(joint.middle + joint.position * (inside * random.symmetric()));
    state.qd[i] = static_cast<T>(joint.speed * (inside * random.symmetric()));
    state.qdd[i] = static_cast<T>(joint.acceleration * (inside * random.symmetric()));
  }
  return state;
}

}  // namespace axial::apps
