// Checks of run-time requests against what a robot declares.
#pragma once

#include <axial/links/inputs_soundness.hpp>
#include <axial/scalar/traits.hpp>
#include <axial/scene/joints.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// The largest number T not beyond a declared limit, so that the limit itself is inside.
template <class T>
[[nodiscard]] constexpr T limit(double value) {
  constexpr double largest = static_cast<double>((std::numeric_limits<T>::max)());
  if (value > largest) return (std::numeric_limits<T>::max)();
  if (value < -largest) return std::numeric_limits<T>::lowest();
  return NumberTraits<T>::constant(value);
}

/// Declared limits of a robot as numbers T.
template <class Robot, class T>
struct Limits {
  /// Limits of one joint.
  struct Joint {
    T position_min, position_max, speed, acceleration, effort;  ///< rad or m, rad/s or m/s, rad/s^2 or m/s^2, N m or N
    T exact_min, exact_max;  ///< rad or m: the range of position, of an angle no farther than its sine is exact
  };
  Joint joints[Robot::chain.size];  ///< from the base outwards
};

namespace detail {
template <class T>
constexpr T exact(const LinkParameters& p, double position) {
  constexpr double farthest = static_cast<double>(largest_angles<T>);
  const bool turns = p.type == JointType::revolute;
  return limit<T>(turns && position > farthest ? farthest : turns && position < -farthest ? -farthest : position);
}
}  // namespace detail

/// The limits that a robot's links declare; unlimited ones as the largest number T.
template <class Robot, class T>
[[nodiscard]] constexpr Limits<Robot, T> declared_limits() {
  constexpr auto& chain = scene_of<Robot>::Robot::chain;
  Limits<Robot, T> all{};
  for (int i = 0; i < chain.size; ++i) {
    const LinkParameters& p = chain.links[i];
    all.joints[i] = {limit<T>(p.position_min),           limit<T>(p.position_max), limit<T>(p.speed_limit),
                     limit<T>(p.acceleration_limit),     limit<T>(p.effort_limit), detail::exact<T>(p, p.position_min),
                     detail::exact<T>(p, p.position_max)};
  }
  return all;
}

/// The declared limits as a constant, so that nothing is copied at run time.
template <class Robot, class T>
inline constexpr Limits<Robot, T> limits_of = declared_limits<Robot, T>();

namespace detail {

// NaN is not inside; unlimited joints have the largest number as limit, so infinity is not inside either.
template <class T>
constexpr bool inside(const T& x, const T& low, const T& high) {
  return x >= low && x <= high;
}

/// What requests and efforts are held against, and how: real numbers of a robot. A number system with formats holds its
/// words against those of the scene.
template <class S, class T>
struct LimitsFor {
  using Joint = typename Limits<robot_of<S>, T>::Joint;
  /// Limits of joint i.
  static constexpr const Joint& joint(int i) { return limits_of<robot_of<S>, T>.joints[i]; }

  /// Whether a position is one that the joint reaches.
  static constexpr bool reaches(const Joint& l, const T& q) { return inside(q, l.exact_min, l.exact_max); }
  /// The nearest position that the joint reaches.
  static constexpr T nearest_position(const Joint& l, const T& q) {
    return q > l.position_max ? l.position_max : q < l.position_min ? l.position_min : q;
  }
  /// What is wrong with a position that is not reached: an angle of so many turns may yet be inside the limits.
  static constexpr Status::Code position_violation(const Joint& l, const T& q) {
    return inside(q, l.position_min, l.position_max) ? Status::Code::angle_range : Status::Code::position_limit;
  }
  /// Whether a speed, an acceleration or an effort is within what it may be in either direction.
  static constexpr bool allows(const T& most, const T& x) { return inside(x, -most, most); }
  /// Clamps a number, which is not NaN, to what is allowed; -1 where it was outside, else 0. By bits, for a comparison
  /// may become a branch.
  static constexpr int clamp(const T& most, T& x) {
    using Bits = typename BitsOf<T>::type;
    constexpr int sign = 8 * static_cast<int>(sizeof(T)) - 1;
    const Bits bits = __builtin_bit_cast(Bits, x), end = __builtin_bit_cast(Bits, most);
    const Bits size = (bits << 1) >> 1, outside = Bits{0} - ((end - size) >> sign);
    x = __builtin_bit_cast(T, static_cast<Bits>(bits ^ ((size ^ end) & outside)));
    return static_cast<int>(outside);
  }
  /// The nearest value that is allowed.
  static constexpr T nearest(const T& most, const T& x) { return x > most ? most : x < -most ? -most : x; }
  /// What is wrong with run-time inputs.
  static constexpr Status check_inputs(const Inputs<S, T>& in) { return inputs_status<S>(in); }
  /// What is wrong with a state where nothing else would tell: here everything else does.
  static constexpr Status check_state(const Positions<robot_of<S>, T>&, const Velocities<robot_of<S>, T>&) {
    return {};
  }
};

// Where T stands for one state: batches have one status per lane.
template <class T>
using if_one_state = std::enable_if_t<std::is_same_v<Lane<T>, T>, int>;

// What is wrong with a joint of which something is.
template <class For, class L, class Q, class T>
constexpr Status::Code violation(const L& l, const Q& q, const T& qd, const T& qdd) {
  using Code = Status::Code;
  if (!(is_finite(q) && is_finite(qd) && is_finite(qdd))) return Code::not_finite;
  if (!For::reaches(l, q)) return For::position_violation(l, q);
  return For::allows(l.speed, qd) ? Code::acceleration_limit : Code::speed_limit;
}

/// How what drives make of joints that they share is held against the limits of those: `joints_status` tells of real
/// numbers. A number system in which angles wrap has its own.
template <class S, class T>
struct SharedCheck {
  /// names the drive that the joint owns, or the first that moves it
  template <class Check, class... Values>
  static constexpr Status status(const Check& joints_status, const Values&...) {
    using Links = decltype(links_of<S, T>());
    Status status = joints_status(Links{});
    if (status.joint >= 0) status.joint = Links::matrix.mover_of(status.joint);
    return status;
  }
};
/// Status of the joints under shared drives, from positions, or from positions, speeds and accelerations; ok where
/// joints have drives of their own.
template <class S, class T, class Check, class... Values>
constexpr Status check_shared(const Check& joints_status, const Values&... values) {
  if constexpr (shares_drives_in<typename scene_of<S>::Robot>)
    return SharedCheck<S, T>::status(joints_status, values...);
  else
    return {};
}

}  // namespace detail

/// First joint with which something is wrong in a request, and what: not finite, outside the declared limits, or an
/// angle of so many turns that its sine is not exact (angle_range), where the limits allow one. Where joints share
/// drives, limits of drives first, then those of the joints; a drive is named.
template <class S, class T, detail::if_one_state<T> = 0>
[[nodiscard]] constexpr Status check_request(const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd,
                                             const Accelerations<robot_of<S>, T>& qdd) {
  using For = detail::LimitsFor<S, T>;
  for (int i = 0; i < joint_count<S>; ++i) {
    const auto& l = For::joint(i);
    if (!(For::reaches(l, q[i]) && For::allows(l.speed, qd[i]) && For::allows(l.acceleration, qdd[i])))
      return {detail::violation<For>(l, q[i], qd[i], qdd[i]), i};
  }
  const auto joints_status = [&](auto links) {
    return check_request<typename decltype(links)::JointScene>(links.positions(q), links.rates(qd), links.rates(qdd));
  };
  return detail::check_shared<S, T>(joints_status, q, qd, qdd);
}

/// First joint whose position is not finite or outside the declared limits, and which of the two, as check_request().
template <class S, class T, detail::if_one_state<T> = 0>
[[nodiscard]] constexpr Status check_position(const Positions<robot_of<S>, T>& q) {
  using For = detail::LimitsFor<S, T>;
  for (int i = 0; i < joint_count<S>; ++i)
    if (!For::reaches(For::joint(i), q[i])) return {detail::violation<For>(For::joint(i), q[i], T{}, T{}), i};
  const auto joints_status = [&](auto links) {
    return check_position<typename decltype(links)::JointScene>(links.positions(q));
  };
  return detail::check_shared<S, T>(joints_status, q);
}

/// A desired motion, and what was wrong with it.
template <class S, class T>
struct Request {
  Positions<robot_of<S>, T> q{};        ///< rad or m
  Velocities<robot_of<S>, T> qd{};      ///< rad/s or m/s
  Accelerations<robot_of<S>, T> qdd{};  ///< rad/s^2 or m/s^2
  Status status{};                      ///< first joint with which something was wrong, and what
};

/// The nearest motion within the declared limits, joint by joint and quantity by quantity; the status is that of
/// check_request() for what was asked. A revolute position in fixed point goes to the nearer end along the circle.
/// NaN has no nearest number: it stays, and feedforward() refuses it; infinities become limits.
template <class S, class T>
[[nodiscard]] constexpr Request<S, T> clamped_request(const Positions<robot_of<S>, T>& q,
                                                      const Velocities<robot_of<S>, T>& qd,
                                                      const Accelerations<robot_of<S>, T>& qdd) {
  using For = detail::LimitsFor<S, T>;
  Request<S, T> kept{q, qd, qdd, check_request<S>(q, qd, qdd)};
  for (int i = 0; i < joint_count<S>; ++i) {
    const auto& l = For::joint(i);
    kept.q[i] = For::nearest_position(l, q[i]);
    kept.qd[i] = For::nearest(l.speed, qd[i]);
    kept.qdd[i] = For::nearest(l.acceleration, qdd[i]);
  }
  return kept;
}

namespace detail {
template <class S>
constexpr auto check_payload_declared() {
  static_assert(scene_of<S>::Robot::chain.payload_limit.declared,
                "axial: a run-time payload is checked against the robot's declared maximum; add "
                "axial::payload_limit(mass, com_reach, inertia) to its chain");
}
}  // namespace detail

/// Whether a run-time payload is within what the robot declares; NaN is not.
template <class S, class T>
[[nodiscard]] constexpr Status check_payload(const PayloadBody<T>& load) {
  detail::check_payload_declared<S>();
  Soundness<T> all;
  detail::collect_load<typename scene_of<S>::Robot>(all, load);
  return {all.is_load_beyond() ? Status::Code::payload_limit : Status::Code::ok, -1};
}

}  // namespace axial

#include <axial/options/end.hpp>
