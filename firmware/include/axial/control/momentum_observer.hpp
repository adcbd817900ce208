// External joint efforts by a generalised-momentum observer: no accelerations, no force sensor.
#pragma once
#include <axial/scalar/language.hpp>

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

/// Says which tuning makes no observer.
template <class Tuning>
constexpr auto check_tuning() {
  static_assert(Tuning::period > 0.0 && Tuning::period < 1e6, "axial: an observer's period is positive, in seconds");
  static_assert(Tuning::gain > 0.0 && Tuning::gain < 1e9, "axial: an observer's gain is positive, in 1/s");
}
/// Share of a new sample in the residual: the implicit step of dr/dt = gain (e - r), in (0, 1) for any gain and period.
template <class Tuning>
constexpr double residual_share() {
  check_tuning<Tuning>();
  return Tuning::gain * Tuning::period / (1.0 + Tuning::gain * Tuning::period);
}

}  // namespace detail

/// External efforts as the observer sees them, N m or N, one per joint: positive where the environment pushes the joint
/// forwards. A plain number, in fixed point a word with its `exponent(i)`, which follows from the tuning too.
template <class S, class T, class Tuning>
struct Residuals : Joints<robot_of<S>, T> {};
namespace detail {

/// The payload that an observer's last momenta hold; a scene without any keeps no byte.
template <class S, class T, bool any = scene_of<S>::template has<Payload>>
class ObservedLoad {
 public:
  /// Takes the sample's payload; true where it is, bit for bit, the one before. No branch.
  constexpr bool same(const Inputs<S, T>& in) {
    const auto &a = in.payload, &b = load_;
    const auto &j = a.inertia_com, &k = b.inertia_com;
    const bool same = is_same(a.mass, b.mass) & is_same(a.com.x, b.com.x) & is_same(a.com.y, b.com.y) &
                      is_same(a.com.z, b.com.z) & is_same(j.xx, k.xx) & is_same(j.yy, k.yy) & is_same(j.zz, k.zz) &
                      is_same(j.xy, k.xy) & is_same(j.xz, k.xz) & is_same(j.yz, k.yz);
    load_ = a;
    return same;
  }

 private:
  static constexpr int is_same(const T& x, const T& y) {
    using Bits = typename BitsOf<T>::type;
    return __builtin_bit_cast(Bits, x) == __builtin_bit_cast(Bits, y);
  }
  PayloadBody<T> load_{};
};
template <class S, class T>
class ObservedLoad<S, T, false> {
 public:
  constexpr bool same(const Inputs<S, T>&) { return true; }
};

}  // namespace detail

/// Memory of an observer, owned by the caller; start with `{}`. After a gap in the samples set `ready` to false, as
/// observe() does after a bad one: the next call starts anew and keeps the residual.
template <class S, class T, class Tuning>
struct ObserverState : detail::ObservedLoad<S, T> {
  Residuals<S, T, Tuning> residual{};  ///< N m or N, external efforts
  MomentumTerms<S, T> last{};          ///< terms of the sample before
  bool ready = false;                  ///< whether `last` is the previous sample's
};

namespace detail {

/// Says which numbers have no observer.
template <class T>
constexpr auto check_observed() {
  static_assert(!std::is_same_v<T, Fixed16>, "axial: the momentum observer takes Fixed32, float or double");
}

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
/// starts anew from it, for the momentum's change over the gap belongs to no one sample. So does the first sample with
/// another payload than the one before: a load that is picked up or put down at speed is no contact, and whatever
/// pushes meanwhile is seen from the next sample on; change_load() loses none. The first sample starts the observer at
/// residual 0. Constant time for good samples. Fixed point: doc/guides/observer.md.
template <class S, class T, class Tuning>
[[nodiscard]] constexpr Status observe(ObserverState<S, T, Tuning>& state, const Positions<robot_of<S>, T>& q,
                                       const Velocities<robot_of<S>, T>& qd, const EffortsOf<S, T>& tau,
                                       const Inputs<S, T>& in = no_inputs<S, T>()) {
  detail::check_observed<T>();
  detail::check_tuning<Tuning>();
  if constexpr (scene_of<S>::template has<Payload>) detail::check_payload_declared<S>();
  momentum::check_momenta<scene_of<S>, detail::is_word<T>>();
  if constexpr (std::is_same_v<T, Fixed16>) {
    return {};
  } else {
    const Status status = detail::check_sample<S, T>(q, qd, tau, in);
    if (!status.ok()) {
      state.ready = false;
      return status;
    }
    auto now = momentum_terms<S>(q, qd, in);
    now.status = {};  // of a sample that is checked it says nothing new
    const bool same = state.same(in);
    state.ready = state.ready & same;  // momenta of another load are no last ones
    return detail::update(state, now, tau);
  }
}

/// The load changes now, to that of `in`, at the last sample's q (rad or m) and qd: between two calls of observe(). So
/// no sample is lost, which matters where a load changes again and again (it is poured, or drawn off); the residual is
/// continuous, and what pushes at that moment is seen. Status and constant time as of observe().
template <class S, class T, class Tuning>
[[nodiscard]] constexpr Status change_load(ObserverState<S, T, Tuning>& state, const Positions<robot_of<S>, T>& q,
                                           const Velocities<robot_of<S>, T>& qd, const Inputs<S, T>& in) {
  static_assert(scene_of<S>::template has<Payload>, "axial: a load changes where the scene names Payload");
  if (const Status status = detail::check_all<S, T>(q, qd, {}, in); !status.ok()) return status;
  auto now = momentum_terms<S>(q, qd, in);
  now.status = {};
  (void)state.same(in);
  state.last = now;
  return {};
}

}  // namespace axial

#include <axial/options/end.hpp>
