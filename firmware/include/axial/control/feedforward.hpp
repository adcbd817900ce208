// Feed-forward torque: what a control loop embeds.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/control/limits.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Memory of a feed-forward, owned by the caller; start with `{}`: the first safe output is no effort.
template <class S, class T>
struct FeedforwardState {
  static_assert(detail::names_robot<S>, AXIAL_A_ROBOT_IS);
  EffortsOf<S, T> last_safe{};  ///< N m or N, answered where a request is refused
};

/// Efforts to apply, and whether the request was met.
template <class S, class T>
struct FeedforwardResult {
  EffortsOf<S, T> tau{};  ///< N m or N, within the declared effort limits
  Status status{};        ///< what was wrong with the request, and with which joint
};

namespace detail {

// Keeps efforts inside the declared ones; names the first joint that was clamped.
template <class S, class T>
constexpr Status clamp_efforts(EffortsOf<S, T>& tau) {
  int joint = -1;
  for (int i = joint_count<S>; i-- > 0;) {
    const int outside = LimitsFor<S, T>::clamp(LimitsFor<S, T>::joint(i).effort, tau[i]);
    joint = (joint & ~outside) | (i & outside);
  }
  return status_of_first(Status::Code::effort_limit, joint);
}

template <class S, class T>
constexpr bool all_finite(const EffortsOf<S, T>& tau) {
  for (int i = 0; i < joint_count<S>; ++i)
    if (!is_finite(tau[i])) return false;
  return true;
}

// Everything about run-time inputs that can be wrong before anything is computed.
template <class S, class T>
constexpr Status check_given(const Inputs<S, T>& in) {
  if constexpr (scene_of<S>::template has<Payload>) check_payload_declared<S>();
  return LimitsFor<S, T>::check_inputs(in);
}
// Everything about a request.
template <class S, class T>
constexpr Status check_all(const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd,
                           const Accelerations<robot_of<S>, T>& qdd, const Inputs<S, T>& in) {
  if (const Status given = check_given<S>(in); !given.ok()) return given;
  return check_request<S>(q, qd, qdd);
}

// Sets what the request asks for, unless it is not finite: then the result stays the last safe output.
template <class S, class T>
constexpr void publish(FeedforwardResult<S, T>& result, FeedforwardState<S, T>& state, EffortsOf<S, T>& tau) {
  if (!all_finite<S>(tau)) {
    result.status = {Status::Code::not_finite, -1};
    return;
  }
  result.status = clamp_efforts<S>(tau);
  result.tau = state.last_safe = tau;
}

}  // namespace detail

/// Feed-forward torque for a desired motion, safe against bad requests.
/// In: desired q (rad or m), qd, qdd; `in` carries the run-time inputs that the scene names; friction is added
/// where it names Friction. Out: efforts (N m or N) inside the declared effort limits.
/// A request that is not finite or outside the declared limits, a payload beyond the declared maximum (which the robot
/// must declare: axial::payload_limit), and run-time inputs that make the result not finite, give the last safe output
/// and a status that names the joint or the payload; an effort beyond its limit is clamped and reported. A request that
/// is to be followed as far as the limits go passes through clamped_request() first.
/// Fixed point: the same, on raw words (Positions<Robot, Fixed32> ...); fixed/control/border.hpp brings real numbers
/// there and back, and says what was wrong with them.
template <class S, class T>
[[nodiscard]] constexpr FeedforwardResult<S, T> feedforward(FeedforwardState<S, T>& state,
                                                            const Positions<robot_of<S>, T>& q,
                                                            const Velocities<robot_of<S>, T>& qd,
                                                            const Accelerations<robot_of<S>, T>& qdd,
                                                            const Inputs<S, T>& in = no_inputs<S, T>()) {
  if constexpr (scene_of<S>::template has<Payload>) detail::check_payload_declared<S>();
  FeedforwardResult<S, T> result{state.last_safe, detail::check_all<S, T>(q, qd, qdd, in)};
  if (!result.status.ok()) return result;
  auto tau = inverse_dynamics<S>(q, qd, qdd, in);
  detail::publish<S>(result, state, tau);
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
