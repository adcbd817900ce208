// What the compiler says to who gives the calls of a loop velocities for positions.
#pragma once

#include <axial/control/gravity_compensation.hpp>
#include <axial/dynamics/role_checks.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {
using OfStateAndMotion = Order<void, role::Position, role::Velocity, role::Acceleration>;  ///< a state, q, qd, qdd
using OfStateAndPosition = Order<void, role::Position>;                                    ///< a state, q
}  // namespace detail

/// Refused, as the kernels' arguments are.
///@{
template <class S, class State, class... A, class = detail::IfOutOfOrder<detail::OfStateAndMotion, State, A...>>
[[nodiscard]] constexpr FeedforwardResult<S, float> feedforward(State&, const A&...) {
  static_assert(!detail::is_out_of_order<detail::OfStateAndMotion, State, A...>, AXIAL_ROLES_MIXED);
  return {};
}
template <class S, class State, class... A, class = detail::IfOutOfOrder<detail::OfStateAndPosition, State, A...>>
[[nodiscard]] constexpr FeedforwardResult<S, float> compensate_gravity(State&, const A&...) {
  static_assert(!detail::is_out_of_order<detail::OfStateAndPosition, State, A...>, AXIAL_ROLES_MIXED);
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfMotion, A...>>
[[nodiscard]] constexpr Status check_request(const A&...) {
  static_assert(!detail::is_out_of_order<detail::OfMotion, A...>, AXIAL_ROLES_MIXED);
  return {};
}
template <class S, class... A, class = detail::IfOutOfOrder<detail::OfMotion, A...>>
[[nodiscard]] constexpr Request<S, float> clamped_request(const A&...) {
  static_assert(!detail::is_out_of_order<detail::OfMotion, A...>, AXIAL_ROLES_MIXED);
  return {};
}
///@}

}  // namespace axial

#include <axial/options/end.hpp>
