// External joint efforts by a generalised-momentum observer: no accelerations, no force sensor.
#pragma once

#include <axial/control/feedforward.hpp>
#include <axial/dynamics/momentum.hpp>
#include <axial/links/soundness.hpp>

#include <axial/options/begin.hpp>

namespace axial {

// A tuning is a type of the caller's with `static constexpr double`
//   period   s, between two calls
//   gain     1/s, bandwidth of the residual: it follows a step with the time constant 1/gain
// struct Tuning { static constexpr double period = 1e-3, gain = 200.0; };

namespace detail {

/// Share of a new sample in the residual: the implicit step of dr/dt = gain (e - r), in (0, 1) for any gain and period.
template <class Tuning>
constexpr double residual_share() {
  static_assert(Tuning::period > 0.0 && Tuning::period < 1e6, "axial: an observer's period is positive, in seconds");
  static_assert(Tuning::gain > 0.0 && Tuning::gain < 1e9, "axial: an observer's gain is positive, in 1/s");
  return Tuning::gain * Tuning::period / (1.0 + Tuning::gain * Tuning::period);
}

}  // namespace detail

/// External efforts as the observer sees them, N m or N, one per joint: positive where the environment pushes the joint
/// forwards. A plain number, in fixed point a word with its `exponent(i)`, which follows from the tuning too.
template <class S, class T, class Tuning>
struct Residuals : Joints<robot_of<S>, T> {};
/// Memory of an observer, owned by the caller; start with `{}`. After a gap in the samples set `ready` to false, as
/// observe() does after a bad one: the next call starts anew and keeps the residual.
template <class S, class T, class Tuning>
struct ObserverState {
  Residuals<S, T, Tuning> residual{};  ///< N m or N, external efforts
  MomentumTerms<S, T> last{};          ///< terms of the sample before
  bool ready = false;                  ///< whether `last` is the previous sample's
};

namespace detail {

template <class S, class T>
constexpr Status check_sample(const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd,
                              const EffortsOf<S, T>& tau, const Inputs<S, T>& in) {
  if (const Status status = check_all<S, T>(q, qd, {}, in); !status.ok()) return status;
  for (int i = 0; i < joint_count<S>; ++i)
    if (!LimitsFor<S, T>::allows(LimitsFor<S, T>::joint(i).effort, tau[i]))
      return {is_finite(tau[i]) ? Status::Code::effort_limit : Status::Code::not_finite, i};
  return {};
}

// r + share (e - r) with e the mean external effort since the last sample.
template <class Tuning, class T>
AXIAL_INLINE constexpr T next_residual(const T& r, const T& p, const T& p_last, const T& tau, const T& drift,
                                       const T& drift_last) {
  using N = NumberTraits<T>;
  const T e = N::constant(1.0 / Tuning::period) * (p - p_last) - tau - N::constant(0.5) * (drift + drift_last);
  return r + N::constant(residual_share<Tuning>()) * (e - r);
}
/// How a joint's residual moves on by one sample.
template <class S, class T, class Tuning>
struct ResidualStep {
  using Terms = MomentumTerms<S, T>;
  /// `r` of joint i. Looked at even where the observer starts: what is kept of this sample must not spoil the next.
  static constexpr void take(Soundness<T>& all, T& r, int i, bool ready, const Terms& now, const Terms& last,
                             const EffortsOf<S, T>& tau) {
    const T next = next_residual<Tuning>(r, now.momentum[i], last.momentum[i], tau[i], now.drift[i], last.drift[i]);
    all.number(next);
    r = select(ready, next, r);
  }
};

// Commits a sample, unless a residual would not be finite: then the next sample starts anew.
template <class S, class T, class Tuning>
constexpr Status update(ObserverState<S, T, Tuning>& state, const MomentumTerms<S, T>& now,
                        const EffortsOf<S, T>& tau) {
  Residuals<S, T, Tuning> residual = state.residual;
  Soundness<T> all;
  for (int i = 0; i < joint_count<S>; ++i)
    ResidualStep<S, T, Tuning>::take(all, residual[i], i, state.ready, now, state.last, tau);
  const Status status = all.status();
  state.ready = status.ok();
  if (!status.ok()) {
    state.last = {};
    return status;
  }
  state.residual = residual, state.last = now;
  return {};
}

}  // namespace detail

/// One sample of a generalised-momentum observer: state.residual becomes the external joint effort behind a first-order
/// lag of 1/gain. Source: De Luca and Mattone 2003; De Luca, Albu-Schaeffer, Haddadin and Hirzinger 2006, eq. (9):
/// r = K (p - p0 - integral (tau + C^T qd - g - friction + r) dt); here as its difference equation
/// r += share (e - r), e = (p - p_last)/period - tau - (drift + drift_last)/2, share = gain period/(1 + gain period):
/// stable for every gain and period, and nothing accumulates.
/// In: q (rad or m) and qd as measured now, tau (N m or N, at the joint) as applied since the last call; `in` as of
/// inverse_dynamics(). The scene says what is known: gravity, rotors, friction, a payload, a wrench.
/// A sample that is not finite or outside the declared limits (effort_limit: of tau), or so large that a residual
/// overflows (not_finite, joint -1), says so and is left out: the residual stays what it was, and the next good sample
/// starts anew from it, for the momentum's change over the gap belongs to no one sample. The first sample starts the
/// observer at residual 0. Constant time for good samples. Fixed point: doc/guides/observer.md.
template <class S, class T, class Tuning>
[[nodiscard]] constexpr Status observe(ObserverState<S, T, Tuning>& state, const Positions<robot_of<S>, T>& q,
                                       const Velocities<robot_of<S>, T>& qd, const EffortsOf<S, T>& tau,
                                       const Inputs<S, T>& in = {}) {
  const Status status = detail::check_sample<S, T>(q, qd, tau, in);
  if (!status.ok()) {
    state.ready = false;
    return status;
  }
  auto now = momentum_terms<S>(q, qd, in);
  now.status = {};  // of a sample that is checked it says nothing new
  return detail::update(state, now, tau);
}

}  // namespace axial

#include <axial/options/end.hpp>
