// Checked gravity compensation: an arm that a hand can guide, and what tracking falls back to.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/control/effort_ramp.hpp>
#include <axial/control/feedforward.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Memory of compensate_gravity() and track(), owned by the caller; start with `{}`. Both may use the same, so that a
/// loop changes between them without a step. Set `output.step` for a limited rate.
template <class S, class T>
struct SafeLoopState {
  static_assert(detail::names_robot<S>, AXIAL_A_ROBOT_IS);
  static_assert(detail::says_gravity<S>(), AXIAL_GRAVITY_IS);
  EffortsOf<S, T> hold{};     ///< N m or N, what carries the arm at its last good position
  EffortRamp<S, T> output{};  ///< what was answered, and by how much it may change
};

namespace detail {

// Finds what carries the arm at a position that was checked; what is not finite leaves the last good one.
template <class S, class T>
constexpr Status carry_at(SafeLoopState<S, T>& state, const Positions<robot_of<S>, T>& q, const Inputs<S, T>& in) {
  auto tau = holding_torque<S>(q, in);
  if (!all_finite<S>(tau)) return {Status::Code::not_finite, -1};
  const Status status = clamp_efforts<S>(tau);
  state.hold = tau;
  return status;
}

// Answers with `tau` as fast as the output may change; what was wrong before is told first.
template <class S, class T>
constexpr FeedforwardResult<S, T> answer(SafeLoopState<S, T>& state, const EffortsOf<S, T>& tau, const Status& status) {
  FeedforwardResult<S, T> result{tau, status};
  const Status limited = state.output.limit(result.tau);
  result.status.code =
      static_cast<Status::Code>(select(status.ok(), static_cast<int>(limited.code), static_cast<int>(status.code)));
  result.status.joint = select(status.ok(), limited.joint, status.joint);
  return result;
}

}  // namespace detail

/// Gravity compensation for hand guiding, safe against bad measurements: call it once per control tick.
/// In: measured q (rad or m); `in` carries what the scene names: the payload in hand (mounted_payload() brings it from
/// the tool's frame), gravity of a tilted base. Out: efforts (N m or N) that hold the arm still, springs included,
/// inside the declared effort limits; none changes by more than `state.output.step` per call.
/// A position or input that is not finite or outside the declared limits gives what carries the arm at the last good
/// position (no effort before the first) and a status; an effort that was clamped (effort_limit) or slowed
/// (effort_rate) is reported. status.met() tells the two apart. Friction is not compensated: a hand feels it, and it
/// damps. The number of instructions does not depend on good inputs; bad ones take fewer.
/// doc/guides/gravity_compensation.md.
template <class S, class T>
[[nodiscard]] constexpr FeedforwardResult<S, T> compensate_gravity(SafeLoopState<S, T>& state,
                                                                   const Positions<robot_of<S>, T>& q,
                                                                   const Inputs<S, T>& in = no_inputs<S, T>()) {
  Status status = detail::check_given<S>(in);
  if (status.ok()) status = check_position<S>(q);
  if (status.ok()) status = detail::carry_at<S>(state, q, in);
  return detail::answer<S>(state, state.hold, status);
}

}  // namespace axial

#include <axial/options/end.hpp>
