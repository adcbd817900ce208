// What a compiler says of a call whose arguments fit no function of that name: a value forgotten, of another robot,
// scene or number, a state that is another's, a header that is not included.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/scene/scene.hpp>
#include <axial/scene/status.hpp>

#include <axial/options/begin.hpp>

/// What is said of a call (macros: static_assert takes a literal only).
///@{
#define AXIAL_OF_ONE "; all of that robot or scene and of one number (float, double, fixed point), then its Inputs"
#define AXIAL_NO_SUCH_CALL(name, arguments) \
  "axial: no such call: " name "<Robot>(" arguments ") is what there is" AXIAL_OF_ONE
///@}

namespace axial {

namespace detail {
/// A call that was refused answers something of every kind, so that nothing more is said.
struct Refused {
  Status status{};
  float value{};
  template <class Any>
  constexpr operator Any() const {
    return {};
  }
  constexpr const float& operator[](int) const { return value; }
  constexpr const float& operator()(int, int) const { return value; }
};
/// Of a type that is no robot another sentence was said.
template <class S, class...>
inline constexpr bool is_offered = !std::is_void_v<S> && !names_robot<S>;
}  // namespace detail

/// Refused: an ellipsis is the worst match of all, so that these are called where nothing else can be. A robot that is
/// not named is void. Those of algorithms: calls/registry.hpp.
///@{
// clang-format off
template <class S = void, class... F> constexpr detail::Refused certified_forward_dynamics(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("certified_forward_dynamics", "q, qd, tau")); return {}; }
template <class S = void, class... F> constexpr detail::Refused inverse_dynamics_along(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("inverse_dynamics_along", "q, qd, qdd, direction")); return {}; }
template <class S = void, class... F> constexpr detail::Refused forward_dynamics_along(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("forward_dynamics_along", "q, qd, tau, direction")); return {}; }
template <class S = void, class... F> constexpr detail::Refused tool_mobility(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("tool_mobility", "q")); return {}; }
template <class S = void, class... F> constexpr detail::Refused feedforward(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("feedforward", "state, q, qd, qdd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused compensate_gravity(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("compensate_gravity", "state, q")); return {}; }
template <class S = void, class... F> constexpr detail::Refused track(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("track", "state, desired, measured, gains")); return {}; }
template <class S = void, class... F> constexpr detail::Refused refresh(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("refresh", "state, q")); return {}; }
template <class S = void, class... F> constexpr detail::Refused two_rate_feedforward(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("two_rate_feedforward", "state, qd, qdd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused observe(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("observe", "state, q, qd, tau")); return {}; }
template <class S = void, class... F> constexpr detail::Refused detect(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("detect", "state, residual")); return {}; }
template <class S = void, class... F> constexpr detail::Refused update_payload(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("update_payload", "state, q, qd, tau")); return {}; }
template <class S = void, class... F> constexpr detail::Refused limit_currents(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("limit_currents", "state, limits, tau")); return {}; }
template <class S = void, class... F> constexpr detail::Refused position_command(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("position_command", "state, loop, q_desired, tau")); return {}; }
template <class S = void, class... F> constexpr detail::Refused check_request(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("check_request", "q, qd, qdd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused clamped_request(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("clamped_request", "q, qd, qdd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused check_position(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("check_position", "q")); return {}; }
template <class S = void, class... F> constexpr detail::Refused check_payload(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("check_payload", "payload")); return {}; }
template <class S = void, class... F> constexpr detail::Refused check_finite(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("check_finite", "values")); return {}; }
template <class S = void, class... F> constexpr detail::Refused transpose_times(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("transpose_times", "jacobian, wrench")); return {}; }
template <class S = void, class... F> constexpr detail::Refused bias_acceleration(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("bias_acceleration", "jacobian, qd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused jacobian_rate(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("jacobian_rate", "jacobian, qd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused tool_velocity(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("tool_velocity", "jacobian, qd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused to_fixed_request(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("to_fixed_request", "q, qd, qdd")); return {}; }
template <class S = void, class... F> constexpr detail::Refused to_real(...) { static_assert(detail::is_offered<S, F...>, AXIAL_NO_SUCH_CALL("to_real", "values")); return {}; }
// clang-format on
///@}

}  // namespace axial

#include <axial/options/end.hpp>
