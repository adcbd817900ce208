// The calls of a control loop on arrays and braces.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/calls/arguments.hpp>
#include <axial/control/gravity_compensation.hpp>

#include <axial/options/begin.hpp>

namespace axial {

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
