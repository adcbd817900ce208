// The algorithms on arrays and braces, and what is said of arguments that do not fit or are out of order.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/calls/arguments.hpp>
#include <axial/calls/registry.hpp>
#include <axial/control/gravity_compensation.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// The algorithms of the same names where arrays, or braces, with a number for each joint stand for joint values, all
/// or some. Braces are of float; of another scalar: inverse_dynamics<Arm, double>({...}, ...). Values that say what
/// they are (JointPositions, JointVelocities, JointAccelerations) stand where they belong. Over a model likewise.
///@{
AXIAL_ALGORITHMS(AXIAL_ON_ARRAYS)
AXIAL_ALGORITHMS_OF_CHOICE(AXIAL_OF_CHOICE_ON_ARRAYS)
AXIAL_ON_ARRAYS(torque_rates, 4, Higher, TorqueRate, )
AXIAL_OVER_A_MODEL_ON_ARRAYS(torque_rates, 4, Higher, TorqueRate, )
AXIAL_OF_A_JOINT_ON_ARRAYS(joint_torque, 3, Motion)
AXIAL_OF_A_JOINT_ON_ARRAYS(gravity_torque, 1, Position)
AXIAL_ALGORITHMS_OVER_MODELS(AXIAL_OVER_A_MODEL_ON_ARRAYS)
AXIAL_ALGORITHMS_OF_CHOICE(AXIAL_OF_CHOICE_OVER_A_MODEL_ON_ARRAYS)
/// Refuses in fixed point efforts of another scene too: their formats are that scene's.
template <class S, class Q, class Qd, class X, class T, class... In,
          class = std::enable_if_t<!std::is_same_v<X, subject_of<S, T>>>>
[[nodiscard]] constexpr Accelerations<robot_of<S>, float> forward_dynamics(const Q&, const Qd&,
                                                                           const Joints<X, T, role::Effort>&,
                                                                           const In&...) {
  static_assert(std::is_same_v<X, subject_of<S, T>>,
                "axial: these efforts are in the formats of another scene; declare them as EffortsOf<Scene, Number>");
  return {};
}
///@}

namespace detail {
template <class, class>
using StatusOfACheck = Status;
}  // namespace detail

/// feedforward, compensate_gravity, checks and the nearest request where arrays, or braces, stand for joint values: of
/// the state's scalar, or where there is none of one. Values that say what they are stand where they belong.
///@{
AXIAL_OF_A_STATE_ON_ARRAYS(feedforward, 3, Motion, FeedforwardState, FeedforwardResult)
AXIAL_OF_A_STATE_ON_ARRAYS(compensate_gravity, 1, Position, SafeLoopState, FeedforwardResult)
AXIAL_ON_ARRAYS(check_request, 3, Motion, detail::StatusOfACheck, )
AXIAL_ON_ARRAYS(check_position, 1, Position, detail::StatusOfACheck, )
AXIAL_ON_ARRAYS(clamped_request, 3, Motion, Request, )
///@}

}  // namespace axial

#include <axial/options/end.hpp>
