// Feed-forward at two rates: the terms of the dynamics slowly, the products of velocities and accelerations fast.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/control/feedforward.hpp>
#include <axial/separation/separated_torque.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Memory of a two-rate feed-forward, owned by the caller; start with `{}`.
template <class S, class T>
struct TwoRateState {
  Separated<S, T> terms{};          ///< as last separated
  Positions<robot_of<S>, T> q{};    ///< where the terms were separated
  bool ready = false;               ///< whether they ever were
  FeedforwardState<S, T> output{};  ///< memory of the efforts
};

/// The slow part: separates the dynamics at q (rad or m), with the run-time inputs that the scene names. A q that is
/// not finite or outside the declared limits, a payload beyond the declared maximum and inputs that make a term not
/// finite (or whose sum of angles has no exact sines) leave the last good terms as they are; the status says which.
template <class S, class T>
[[nodiscard]] constexpr Status refresh(TwoRateState<S, T>& state, const Positions<robot_of<S>, T>& q,
                                       const Inputs<S, T>& in = no_inputs<S, T>()) {
  separation::check_separable<scene_of<S>, T>();
  if constexpr (scene_of<S>::template has<Payload>) detail::check_payload_declared<S>();
  if (const Status status = detail::check_all<S, T>(q, {}, {}, in); !status.ok()) return status;
  const auto terms = separate<S>(q, in);
  if (!terms.status.ok()) return terms.status;
  state.terms = terms, state.q = q, state.ready = true;
  return {};
}

/// The fast part: efforts (N m or N) for qd and qdd at the last refreshed q, within the declared effort limits; as
/// feedforward() does, it answers a bad request with the last safe output and a status. Before the first good refresh
/// that is no effort and `not_ready`. Error against feedforward(): doc/measurements/separation.md.
template <class S, class T>
[[nodiscard]] constexpr FeedforwardResult<S, T> two_rate_feedforward(TwoRateState<S, T>& state,
                                                                     const Velocities<robot_of<S>, T>& qd,
                                                                     const Accelerations<robot_of<S>, T>& qdd) {
  if (!state.ready) return {state.output.last_safe, {Status::Code::not_ready, -1}};
  if (const Status status = check_request<S>(state.q, qd, qdd); !status.ok()) return {state.output.last_safe, status};
  FeedforwardResult<S, T> result{state.output.last_safe, {}};
  auto tau = torque(state.terms, qd, qdd);
  detail::publish<S>(result, state.output, tau);
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
