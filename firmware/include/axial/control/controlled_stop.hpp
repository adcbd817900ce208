// Braking to rest along declared decelerations, inside the position limits: where each joint is wanted at every tick.
#pragma once

#include <axial/control/limits.hpp>

#include <axial/options/begin.hpp>

namespace axial {

// A controlled stop is a type of the caller's with `static constexpr double`
//   period            s, of a control tick
//   deceleration[n]   rad/s^2 or m/s^2, one per joint value, at most its acceleration limit; half of that where left
//   out
// struct Stop { static constexpr double period = 1e-3; };

namespace detail {

template <class Stop, class = void>
struct DeclaredDeceleration {
  static constexpr double of(const LinkParameters& p, int) { return 0.5 * p.acceleration_limit; }
};
template <class Stop>
struct DeclaredDeceleration<Stop, std::void_t<decltype(Stop::deceleration)>> {
  static constexpr double of(const LinkParameters&, int i) { return Stop::deceleration[i]; }
};

/// The decelerations of a stop, rad/s^2 or m/s^2.
template <class S, class Stop>
struct Decelerations {
  double usual[joint_count<S>] = {}, most[joint_count<S>] = {};
  bool sound = Stop::period > 0.0 && Stop::period < 1.0;
  constexpr Decelerations() {
    for (int i = 0; i < joint_count<S>; ++i) {
      const LinkParameters& p = scene_of<S>::Robot::chain.links[i];
      usual[i] = DeclaredDeceleration<Stop>::of(p, i), most[i] = p.acceleration_limit;
      sound = sound && usual[i] > 0.0 && usual[i] <= most[i] && most[i] < LinkParameters::unlimited;
    }
  }
};
template <class S, class Stop>
inline constexpr Decelerations<S, Stop> decelerations{};

/// One tick of joint i, in real numbers; number systems with formats have their own.
template <class S, class T, class Stop>
struct StopStep {
  using N = NumberTraits<T>;
  /// What a tick of braking takes off a speed, either way; v^2 per way that is too much for the usual one.
  struct Joints {
    T usual[joint_count<S>] = {}, most[joint_count<S>] = {}, late[joint_count<S>] = {};
    constexpr Joints() {
      for (int i = 0; i < joint_count<S>; ++i) {
        const auto& rates = decelerations<S, Stop>;
        usual[i] = N::constant(rates.usual[i] * Stop::period), most[i] = N::constant(rates.most[i] * Stop::period);
        late[i] = N::constant(1.96875 * rates.usual[i]);
      }
    }
  };
  static constexpr Joints joints{};
  /// Whether the usual deceleration from v ends beyond the position limits: v^2 > 2 a way, to a 64th.
  static constexpr bool is_late(int i, const T& q, const T& v) {
    const auto& l = LimitsFor<S, T>::joint(i);
    const T way = select(is_below_zero(v), T(q - l.position_min), T(l.position_max - q));
    return v * v > joints.late[i] * way;
  }
  /// v a tick later, braked as usual, or where that is late as hard as declared.
  static constexpr T slowed(int i, const T& v, bool late) {
    const T less = select(late, joints.most[i], joints.usual[i]);
    const T size = absolute_of(v) - less, kept = select(is_below_zero(size), T(Zero{}), size);
    return select(is_below_zero(v), T(-kept), kept);
  }
  /// v a tick later under the acceleration a.
  static constexpr T gained(int, const T& v, const T& a) { return v + a * N::constant(Stop::period); }
  /// q a tick later, while v becomes `next`; no farther than the position limit.
  static constexpr T moved(int i, const T& q, const T& v, const T& next) {
    const T there = q + (v + next) * N::constant(0.5 * Stop::period);
    return LimitsFor<S, T>::nearest_position(LimitsFor<S, T>::joint(i), there);
  }
  /// The acceleration that makes `next` of v in a tick.
  static constexpr T rate(int, const T& v, const T& next) { return (next - v) * N::constant(1.0 / Stop::period); }
  static constexpr bool is_moving(const T& v) { return is_larger(v, T(Zero{})); }
};

/// The motion that a fall-back knows of: while the last request is young it goes on as asked for, then every joint
/// brakes. Constant time: the same instructions for every joint, state and tick.
template <class S, class T, class Stop>
class Braking {
  using Step = StopStep<S, T, Stop>;
  using For = LimitsFor<S, T>;
  static_assert(
      decelerations<S, Stop>.sound,
      "axial: a controlled stop needs a period in (0, 1) s and, of every joint, an acceleration_limit() and a "
      "deceleration beyond 0 and within it");

 public:
  constexpr void begin(const Request<S, T>& motion) { motion_ = motion; }
  [[nodiscard]] constexpr const Request<S, T>& motion() const { return motion_; }

  /// A tick in which the last good torque stays: so do its accelerations, within the declared speeds.
  constexpr void coast() {
    for (int i = 0; i < joint_count<S>; ++i) {
      const auto& l = For::joint(i);
      move(i, For::nearest(l.speed, Step::gained(i, motion_.qd[i], motion_.qdd[i])));
    }
  }
  /// A tick of braking.
  constexpr void brake() {
    for (int i = 0; i < joint_count<S>; ++i)
      move(i, next_speed(i));
  }
  /// Makes the accelerations those of braking until the next tick.
  constexpr void plan() {
    for (int i = 0; i < joint_count<S>; ++i)
      motion_.qdd[i] = Step::rate(i, motion_.qd[i], next_speed(i));
  }
  [[nodiscard]] constexpr bool is_moving() const {
    bool any = false;
    for (int i = 0; i < joint_count<S>; ++i)
      any = any | Step::is_moving(motion_.qd[i]);
    return any;
  }

 private:
  [[nodiscard]] constexpr auto next_speed(int i) const {
    return Step::slowed(i, motion_.qd[i], Step::is_late(i, motion_.q[i], motion_.qd[i]));
  }
  template <class V>
  constexpr void move(int i, const V& next) {
    motion_.q[i] = Step::moved(i, motion_.q[i], motion_.qd[i], next);
    motion_.qd[i] = next;
  }

  Request<S, T> motion_{};
};

/// Without a controlled stop nothing is known of a motion but its position.
template <class S, class T>
class Braking<S, T, void> {
 public:
  constexpr void begin(const Positions<robot_of<S>, T>& q) { motion_.q = q; }
  [[nodiscard]] constexpr const auto& motion() const { return motion_; }

 private:
  struct Position {
    Positions<robot_of<S>, T> q{};
  };
  Position motion_{};
};

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
