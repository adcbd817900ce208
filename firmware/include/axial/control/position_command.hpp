// Torque by drives that take positions alone: hobby servos and many bus drives.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/control/limits.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {
/// The number that a loop is described in; behind a sentence any, so that nothing more is said.
template <class T>
struct LoopNumber {
  static constexpr bool sound = std::is_floating_point_v<T>;
  using type = std::conditional_t<sound, T, double>;
  static_assert(sound,
                "axial: position_command() takes float or double; convert efforts and positions of fixed point first");
};
template <class S, class T>
using LoopValues = Joints<robot_of<S>, typename LoopNumber<T>::type>;
template <class S, class T>
constexpr LoopValues<S, T> unlimited_offsets() {
  LoopValues<S, T> offsets{};
  for (int i = 0; i < joint_count<S>; ++i)
    offsets[i] = (std::numeric_limits<typename LoopNumber<T>::type>::max)();
  return offsets;
}
}  // namespace detail

/// What a drive's own position loop makes of a command, joint by joint.
template <class S, class T>
struct PositionLoop {
  /// N m/rad or N/m at the joint, more than 0: what a command one radian or metre ahead of the joint exerts
  detail::LoopValues<S, T> stiffness{};
  /// rad or m, 0 or more: how far ahead of the desired position a command may be; unlimited until set
  detail::LoopValues<S, T> largest_offset = detail::unlimited_offsets<S, T>();
};

/// Memory of position_command(), owned by the caller; start with the measured positions, `{q}`.
template <class S, class T>
struct PositionCommandState {
  Positions<robot_of<S>, T> last{};  ///< rad or m, what the drives were told last
};

/// What the drives are told, and whether it is what was asked for.
template <class S, class T>
struct PositionCommand {
  Positions<robot_of<S>, T> q{};  ///< rad or m, within the declared limits
  Status status{};                ///< what was wrong, or limited, and with which joint
};

namespace detail {

// Everything that can be wrong with what a command is made of; positions are looked at before.
template <class S, class T>
constexpr Status check_loop(const PositionLoop<S, T>& loop, const EffortsOf<S, T>& tau) {
  for (int i = 0; i < joint_count<S>; ++i) {
    if (!is_finite(tau[i])) return {Status::Code::not_finite, i};
    if (!(loop.stiffness[i] > T(Zero{}) && loop.largest_offset[i] >= T(Zero{}))) return {Status::Code::input_limit, i};
  }
  return {};
}

// The nearest number of a range; true where that is another one. Neither way is branched on.
template <class T>
constexpr bool bring_inside(T& x, const T& low, const T& high) {
  const bool above = x > high, below = x < low;
  x = select(above, high, select(below, low, x));
  return above | below;
}

}  // namespace detail

/// The positions that make drives with a proportional loop exert efforts: q_desired + tau / k, joint by joint, with the
/// loop's stiffness k at the joint.
/// In: q_desired (rad or m), tau (N m or N) as inverse_dynamics() answers it, friction included where the scene names
/// it; a loop that also damps the measured speed by d takes tau + d qd. Out: rad or m, no farther than `largest_offset`
/// from the desired position, then inside the declared position limits; command_limit names the first joint for which
/// that changed the command.
/// A loop whose stiffness is k' and not k follows with an error of tau (1/k - 1/k'): a share k'/k - 1 of what it would
/// sag by, tau / k', without this. A stiffness that is right to 20 % takes three quarters of the sag away, and any k
/// above half of k' is better than none. An infinite k stands for a drive that does not sag.
/// A desired position that is not finite or outside the declared limits, an effort that is not finite (not_finite), a
/// stiffness that is not positive or a largest offset that is negative or NaN (input_limit) leave the drives at
/// `state.last`, and the status names the joint. The number of instructions does not depend on good inputs.
template <class S, class T>
[[nodiscard]] constexpr PositionCommand<S, T> position_command(PositionCommandState<S, T>& state,
                                                               const PositionLoop<S, T>& loop,
                                                               const Positions<robot_of<S>, T>& q_desired,
                                                               const EffortsOf<S, T>& tau) {
  if constexpr (!detail::LoopNumber<T>::sound) {
    return {};
  } else {
    Status status = check_position<S>(q_desired);
    if (status.ok()) status = detail::check_loop<S>(loop, tau);
    if (!status.ok()) return {state.last, status};
    int limited = -1;
    for (int i = 0; i < joint_count<S>; ++i) {
      const auto& reach = detail::LimitsFor<S, T>::joint(i);
      T offset = tau[i] / loop.stiffness[i];
      const bool ahead = detail::bring_inside(offset, T(-loop.largest_offset[i]), loop.largest_offset[i]);
      T command = q_desired[i] + offset;
      const bool outside = detail::bring_inside(command, reach.exact_min, reach.exact_max);
      limited = first_found(limited, ahead | outside, i);
      state.last[i] = command;
    }
    return {state.last, status_of_first(Status::Code::command_limit, limited)};
  }
}

}  // namespace axial

#include <axial/options/end.hpp>
