// Hostile words: states of which some or all numbers are beyond what a robot declares, and what double says of them.
#pragma once

#include <axial/axial.hpp>
#include <axial/fixed.hpp>

#include "hostile.hpp"

namespace property {

/// A word at random, an end of its range, or a unit beyond or inside a limit.
inline std::int64_t hostile_word(exhaustive::Random& random, const exhaustive::Span& span) {
  constexpr std::int64_t ends[] = {INT32_MIN, INT32_MAX, 0, -1, 1, 1 << 30, -(1 << 30), INT32_MIN + 1};
  const std::int64_t beyond = random.between(1, 3),
                     edge = random.between(0, 1) == 0 ? span.low - beyond : span.high + beyond;
  switch (random.between(0, 3)) {
    case 0:
      return static_cast<std::int32_t>(random.bits());
    case 1:
      return ends[random.between(0, 7)];
    case 2:
      return edge < INT32_MIN ? INT32_MIN : edge > INT32_MAX ? INT32_MAX : edge;
    default:
      return random.between(0, 1) == 0 ? span.low : span.high;
  }
}

/// An angle within its joint's limits, of a state's number k; of what is none, `inside`.
template <class State>
std::int64_t within_limits(exhaustive::Random& random, int k, std::int64_t inside) {
  if (k >= State::size || !State::turns(k)) return inside;
  const auto& link = State::Robot::chain.links[k];
  const double part = static_cast<double>(random.between(1, 999999)) * 1e-6;
  const double angle = link.position_min + part * (link.position_max - link.position_min);
  return static_cast<std::int32_t>(
      std::llround(std::remainder(angle, 6.283185307179586) * axial::detail::bam_per_radian));
}

/// State number `index`: all words hostile, all inside, one hostile among those inside, or some.
template <class State>
State hostile_state(exhaustive::Random& random, std::uint64_t index) {
  State state;
  const std::int64_t one = random.between(0, State::quantities - 1);
  for (int k = 0; k < State::quantities; ++k) {
    const auto span = State::span(k);
    const std::int64_t any = random.between(span.low, span.high), hostile = hostile_word(random, span);
    const std::int64_t inside = index % 8 < 4 ? any : within_limits<State>(random, k, any);
    const bool chosen = index % 4 == 0 || (index % 4 == 1 && k == one) || (index % 4 == 2 && random.between(0, 3) == 0);
    state.set(k, chosen ? hostile : inside);
  }
  return state;
}

/// What is outside the declared limits of a state, by real numbers; a unit beyond a limit or inside it may be either.
template <class S>
struct Expected {
  axial::Status::Code surely = axial::Status::Code::ok;  ///< of the first joint, where nothing before is doubtful
  int joint = -1;
  bool doubtful = false;  ///< whether something is within a unit of a limit
  bool may_wrap = false;  ///< whether a speed or a slide is not surely inside

  template <class State>
  explicit Expected(const State& state) {
    constexpr double turn = 6.283185307179586;
    using R = axial::robot_of<S>;
    for (int i = 0; i < R::chain.size; ++i) {
      const auto& link = R::chain.links[i];
      const bool turns = State::turns(i);
      const double unit = turns ? turn * 0x1p-32 : axial::detail::power_of_two(-state.q.exponent(i));
      double q = state.q[i].raw * unit;
      if (turns) q += turn * std::ceil((link.position_min - unit - q) / turn);
      const bool any = turns && link.position_max - link.position_min >= turn;
      see(any ? 0.0 : q, any ? -1.0 : link.position_min, any ? 1.0 : link.position_max, unit, i,
          axial::Status::Code::position_limit, !turns);
      const double step = axial::detail::power_of_two(-state.qd.exponent(i));
      see(state.qd[i].raw * step, -link.speed_limit, link.speed_limit, step, i, axial::Status::Code::speed_limit, true);
    }
  }

 private:
  void see(double x, double low, double high, double unit, int i, axial::Status::Code code, bool wraps) {
    const bool out = x < low - unit || x > high + unit, in = x > low + unit && x < high - unit;
    if (out && !doubtful && surely == axial::Status::Code::ok) surely = code, joint = i;
    doubtful = doubtful || (!out && !in && surely == axial::Status::Code::ok);
    may_wrap = may_wrap || (wraps && out);
  }
};

template <class R>
using Exact = axial::Scene<R, axial::Gravity, axial::RotorInertia, axial::ArticulatedBody>;
template <class R, class... Tags>
using Fixed = axial::Scene<R, axial::Gravity, axial::RotorInertia, Tags...>;
template <class S>
using HostileState = exhaustive::FixedState<S, axial::Fixed32>;

/// Whether efforts are declared ones.
template <class State>
bool are_declared(const State& state) {
  for (int k = 3 * State::size; k < 4 * State::size; ++k) {
    const auto span = State::span(k);
    if (state.get(k) < span.low || state.get(k) > span.high) return false;
  }
  return true;
}

/// What is beyond limits is named, as it is of a request.
template <class S, class State>
void check_limits(const State& state, const Expected<S>& expected, const axial::Status& status, std::uint64_t k,
                  Wrong& wrong) {
  using namespace axial;
  using Code = Status::Code;
  const bool limit = status.code == Code::position_limit || status.code == Code::speed_limit;
  if (!expected.doubtful) {
    const bool named =
        expected.surely == Code::ok ? !limit : status.code == expected.surely && status.joint == expected.joint;
    wrong.note(named, "forward dynamics' status", k, static_cast<int>(status.code), static_cast<int>(expected.surely));
  }
  const Status asked = check_request<S>(state.q, state.qd, Accelerations<robot_of<S>, Fixed32>{});
  const bool same = asked.ok() ? !limit : status.code == asked.code && status.joint == asked.joint;
  wrong.note(same, "a request's status", k, static_cast<int>(status.code), static_cast<int>(asked.code));
}

/// A matrix of derivatives: entries are within their bounds, or the largest word says that nothing is known. Beyond
/// the limits of `formats` they are 0.
template <class Words, class Numbers>
void check_slopes(const Words& words, const Words& bounds, const Numbers& exact, bool beyond, bool ok, std::uint64_t k,
                  Wrong& wrong) {
  double largest = 0.0;
  for (int i = 0; i < Words::size; ++i)
    for (int j = 0; j < Words::size; ++j)
      largest = std::fmax(largest, std::fabs(exact(i, j)));
  for (int i = 0; i < Words::size; ++i)
    for (int j = 0; j < Words::size; ++j) {
      const bool known = bounds(i, j).raw != INT32_MAX;
      wrong.note(known || !ok, "an answer with ok has bounds", k, words(i, j).raw, bounds(i, j).raw);
      if (!known) wrong.note(words(i, j).raw == 0, "what is not known is 0", k, words(i, j).raw, 0.0);
      wrong.note(!known || !beyond, "derivatives beyond the limits", k, words(i, j).raw, 0.0);
      const double unit = axial::detail::power_of_two(-words.exponent(i, j)), seen = words(i, j).raw * unit;
      const double within = bounds(i, j).raw * unit + 1e-11 * largest + 1e-12;
      wrong.note(!known || std::fabs(seen - exact(i, j)) <= within, "a derivative", k, seen, exact(i, j));
    }
}

/// Derivatives of forward dynamics: whatever the words, each is within its bound or has none.
template <class S, class State>
void check_forward_derivatives(const State& state, const Expected<S>& expected, std::uint64_t k, Wrong& wrong) {
  using namespace axial;
  using R = robot_of<S>;
  const auto fixed = certified_forward_dynamics_derivatives<S>(state.q, state.qd, state.tau);
  check_limits<S>(state, expected, fixed.qdd.status, k, wrong);
  const bool beyond = expected.may_wrap, ok = fixed.qdd.status.ok();
  const auto exact = forward_dynamics_derivatives<Fixed<R>>(
      exhaustive::in_double<R>(state.q), exhaustive::in_double<R>(state.qd), exhaustive::in_double<R>(state.tau));
  check_slopes(fixed.M_inverse, fixed.bound.M_inverse, exact.M_inverse, beyond, ok, k, wrong);
  check_slopes(fixed.dqdd_dq, fixed.bound.dqdd_dq, exact.dqdd_dq, beyond, ok, k, wrong);
  check_slopes(fixed.dqdd_dqd, fixed.bound.dqdd_dqd, exact.dqdd_dqd, beyond, ok, k, wrong);
}

/// Forward dynamics: what is answered with ok, and what is answered beside a turning joint's position_limit, is right;
/// what is beyond limits is named.
template <class S, class State>
void check_forward(const State& state, const Expected<S>& expected, std::uint64_t k, Wrong& wrong) {
  using namespace axial;
  using Code = Status::Code;
  using R = robot_of<S>;
  constexpr auto bound = error_bound<Fixed<R>>(algorithm::forward_dynamics);
  constexpr bool split = !S::template has<ArticulatedBody>;
  const auto fixed = forward_dynamics<S>(state.q, state.qd, state.tau);
  const Status status = fixed.status;
  check_limits<S>(state, expected, status, k, wrong);
  if (expected.may_wrap) {
    for (int i = 0; i < R::chain.size; ++i)
      wrong.note(fixed[i].raw == 0, "forward dynamics beyond the limits", k, fixed[i].raw, 0.0);
    return;
  }
  if (!status.ok() && status.code != Code::rescaled && status.code != Code::acceleration_limit) return;
  const auto exact = forward_dynamics<Exact<R>>(exhaustive::in_double<R>(state.q), exhaustive::in_double<R>(state.qd),
                                                exhaustive::in_double<R>(state.tau));
  const auto seen = exhaustive::in_double<R>(fixed);
  // Certified for declared efforts; halved up to five times beyond them. The classical form has no bound of its own.
  const bool beyond = status.code == Code::acceleration_limit && !are_declared<State>(state);
  const double times = beyond || status.code == Code::rescaled ? 33.0 : 1.0;
  for (int i = 0; i < R::chain.size; ++i) {
    const double range = 0x1p31 * detail::power_of_two(-fixed.exponent(i));
    const double most = split ? times * bound[i] : range * 0x1p-10;
    wrong.note(std::fabs(seen[i] - exact[i]) <= most + 1e-9 * range, split ? "forward dynamics" : "the classical form",
               k, seen[i], exact[i]);
  }
}

/// Feed-forward: what is met is the torque, held within the declared efforts; what is not leaves the last safe one.
template <class S, class State>
void check_feedforward(const State& state, std::uint64_t k, axial::FeedforwardState<S, axial::Fixed32>& memory,
                       Wrong& wrong) {
  using namespace axial;
  using R = robot_of<S>;
  constexpr auto bound = error_bound<S>(algorithm::inverse_dynamics);
  const auto last = memory.last_safe;
  const auto answer = feedforward<S>(memory, state.q, state.qd, state.qdd);
  const bool met = answer.status.ok() || answer.status.code == Status::Code::effort_limit;
  const auto seen = exhaustive::in_double<R>(answer.tau);
  if (!met) {
    for (int i = 0; i < R::chain.size; ++i)
      wrong.note(answer.tau[i].raw == last[i].raw, "a refused request", k, answer.tau[i].raw, last[i].raw);
    return;
  }
  const auto exact = inverse_dynamics<Fixed<R>>(exhaustive::in_double<R>(state.q), exhaustive::in_double<R>(state.qd),
                                                exhaustive::in_double<R>(state.qdd));
  for (int i = 0; i < R::chain.size; ++i) {
    const double most = R::chain.links[i].effort_limit, unit = detail::power_of_two(-answer.tau.exponent(i));
    const double held = exact[i] > most ? most : exact[i] < -most ? -most : exact[i];
    wrong.note(std::fabs(seen[i] - held) <= bound[i] + unit, "feed-forward", k, seen[i], held);
  }
}

}  // namespace property
