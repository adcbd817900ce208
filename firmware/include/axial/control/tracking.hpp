// One safe call for a control loop: feed-forward and feedback together, gravity compensation where something is wrong.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/control/gravity_compensation.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A motion as sensors see it, and what was wrong with it on its way.
template <class S, class T>
struct MeasuredMotion {
  Positions<robot_of<S>, T> q{};    ///< rad or m
  Velocities<robot_of<S>, T> qd{};  ///< rad/s or m/s
  Status status{};                  ///< as a conversion left it; a bad one makes it a bad measurement
};

/// Feedback of a tracking error, joint by joint; 0 or more. Fixed point: to_fixed_gains() makes them.
template <class S, class T>
struct TrackingGains {
  Joints<robot_of<S>, T> stiffness{};  ///< N m/rad or N/m
  Joints<robot_of<S>, T> damping{};    ///< N m s/rad or N s/m
};

namespace detail {

/// What feedback adds to an effort.
template <class S, class T>
struct Feedback {
  using Gains = TrackingGains<S, T>;
  /// Whether joint i's gains are what gains can be.
  static constexpr bool sound(const Gains& gains, int i) {
    return gains.stiffness[i] >= T(Zero{}) && gains.damping[i] >= T(Zero{});
  }
  /// tau + stiffness (q_d - q) + damping (qd_d - qd) of joint i.
  static constexpr T add(const T& tau, int i, const Request<S, T>& desired, const MeasuredMotion<S, T>& measured,
                         const Gains& gains) {
    return tau + gains.stiffness[i] * (desired.q[i] - measured.q[i]) +
           gains.damping[i] * (desired.qd[i] - measured.qd[i]);
  }
};

// Everything that can be wrong with a tick before anything is computed; the measurement is looked at before.
template <class S, class T>
constexpr Status check_tracking(const Request<S, T>& desired, const TrackingGains<S, T>& gains) {
  if (!desired.status.ok()) return desired.status;
  for (int i = 0; i < joint_count<S>; ++i)
    if (!Feedback<S, T>::sound(gains, i)) return {Status::Code::input_limit, i};
  return check_request<S>(desired.q, desired.qd, desired.qdd);
}

template <class S, class T>
constexpr Status check_measured(const MeasuredMotion<S, T>& measured, const Inputs<S, T>& in) {
  return measured.status.ok() ? check_all<S, T>(measured.q, measured.qd, {}, in) : measured.status;
}

// Feed-forward and feedback, clamped once; `tau` stays as it was where they are not finite.
template <class S, class T>
constexpr Status follow(EffortsOf<S, T>& tau, const Request<S, T>& desired, const MeasuredMotion<S, T>& measured,
                        const TrackingGains<S, T>& gains, const Inputs<S, T>& in) {
  auto sum = inverse_dynamics<S>(desired.q, desired.qd, desired.qdd, in);
  for (int i = 0; i < joint_count<S>; ++i)
    sum[i] = Feedback<S, T>::add(sum[i], i, desired, measured, gains);
  if (!all_finite<S>(sum)) return {Status::Code::not_finite, -1};
  tau = sum;
  return clamp_efforts<S>(tau);
}

}  // namespace detail

/// The torque of one control tick: tau = ID(q_d, qd_d, qdd_d) + stiffness (q_d - q) + damping (qd_d - qd), feed-forward
/// and feedback clamped once to the declared efforts; none changes by more than `state.output.step` per call.
/// In: the desired motion, the measured one, gains; `in` as of inverse_dynamics(). A fixed-point angle's error is taken
/// along the arc that the limits allow, or the short way round where they allow every angle.
/// Where the measurement, an input, the request or a gain is not finite, outside the declared limits (input_limit: a
/// negative gain), or carries a bad status, or the sum overflows, the answer is what compensates gravity where the arm
/// was last seen well, at the same rate, and a status; status.met() tells whether the motion is followed. Before the
/// first good measurement that is no effort. A request that clamped_request() brought inside is followed only where the
/// caller clears its status.
/// Cost: inverse dynamics and a gravity torque. The number of instructions does not depend on good inputs; bad ones
/// take fewer. When calls stop, a FallBack acts: doc/guides/safety.md; doc/guides/gravity_compensation.md.
template <class S, class T>
[[nodiscard]] constexpr FeedforwardResult<S, T> track(SafeLoopState<S, T>& state, const Request<S, T>& desired,
                                                      const MeasuredMotion<S, T>& measured,
                                                      const TrackingGains<S, T>& gains,
                                                      const Inputs<S, T>& in = no_inputs<S, T>()) {
  Status status = detail::check_measured<S>(measured, in);
  if (status.ok()) status = detail::carry_at<S>(state, measured.q, in);
  auto tau = state.hold;
  if (status.met()) status = detail::check_tracking<S>(desired, gains);
  if (status.ok()) status = detail::follow<S>(tau, desired, measured, gains, in);
  return detail::answer<S>(state, tau, status);
}

}  // namespace axial

#include <axial/options/end.hpp>
