// External joint efforts by a generalised-momentum observer: no accelerations, no force sensor.
#pragma once

#include <axial/control/feedforward.hpp>
#include <axial/dynamics/momentum.hpp>
#include <axial/links/soundness.hpp>

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

/// Exponents of residuals, and the factors in 2^-31 that bring momenta, efforts and drifts there. Sums of the largest
/// words that those formats hold fit, so no input overflows.
template <class S, class Word, class Tuning>
struct ResidualFormats {
  static constexpr int size = joint_count<S>;
  int exponent[size] = {};
  std::int32_t momentum[size] = {}, effort[size] = {}, half_drift[size] = {};

  static constexpr ResidualFormats chosen() {
    static_assert(sizeof(Word) == 4, "axial: the momentum observer takes Fixed32, float or double");
    using T = Stored<Word>;
    constexpr Rounding rounding{32, true, false, 0.0};
    ResidualFormats all;
    for (int i = 0; i < size; ++i) {
      const int p = MomentaOf<S, T>::exponent(i), e = EffortsOf<S, T>::exponent(i);
      const int d = MomentumRatesOf<S, T>::exponent(i);
      const int own =
          rounding.exponent(power_of_two(32 - p) / Tuning::period + power_of_two(31 - e) + power_of_two(31 - d));
      all.exponent[i] = own;
      all.momentum[i] = factor(power_of_two(own - p) / Tuning::period);
      all.effort[i] = factor(power_of_two(own - e));
      all.half_drift[i] = factor(0.5 * power_of_two(own - d));
    }
    return all;
  }

 private:
  static constexpr std::int32_t factor(double x) {
    return static_cast<std::int32_t>(nearest_integer(x * power_of_two(31)));
  }
};
template <class S, class Word, class Tuning>
inline constexpr auto residual_formats = ResidualFormats<S, Word, Tuning>::chosen();

}  // namespace detail

/// External efforts as the observer sees them, N m or N, one a joint: positive where the environment pushes the joint
/// forwards. A plain number, in fixed point a word with its `exponent(i)`, which follows from the tuning too.
template <class S, class T, class Tuning>
struct Residuals : Joints<robot_of<S>, T> {};
/// In fixed point: value = raw 2^-exponent(i).
template <class S, class Word, class Tuning>
struct Residuals<S, Stored<Word>, Tuning> {
  static constexpr int size = joint_count<S>;  ///< number of joints
  Stored<Word> values[size];                   ///< from the base outwards
  /// of joint i's residual
  [[nodiscard]] static constexpr int exponent(int i) { return detail::residual_formats<S, Word, Tuning>.exponent[i]; }
  constexpr Stored<Word>& operator[](int i) { return values[i]; }  ///< residual of joint i; the index is not checked
  /// Residual of joint i; the index is not checked.
  constexpr const Stored<Word>& operator[](int i) const { return values[i]; }
};

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
    if (!magnitude_inside(tau[i], limits_for<S, T>().joints[i].effort))
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
template <class Formats>
AXIAL_INLINE constexpr std::int32_t next_residual(const Formats& f, int i, std::int32_t share, std::int32_t r,
                                                  std::int32_t p, std::int32_t p_last, std::int32_t tau,
                                                  std::int32_t drift, std::int32_t drift_last) {
  using integer::multiply;
  const std::int64_t known =
      multiply(tau, f.effort[i]) + multiply(drift, f.half_drift[i]) + multiply(drift_last, f.half_drift[i]);
  const std::int64_t change = multiply(p, f.momentum[i]) - multiply(p_last, f.momentum[i]);
  const auto e = static_cast<std::int32_t>((change - known + (std::int64_t{1} << 30)) >> 31);
  constexpr std::int32_t whole = 1 << 30;
  return static_cast<std::int32_t>((multiply(e, share) + multiply(r, whole - share) + (whole >> 1)) >> 30);
}

// Commits a sample, unless a residual would not be finite: then the next sample starts anew.
template <class S, class T, class Tuning>
constexpr Status update(ObserverState<S, T, Tuning>& state, const MomentumTerms<S, T>& now,
                        const EffortsOf<S, T>& tau) {
  const auto& p = now.momentum;
  const auto& p_last = state.last.momentum;
  const auto& d = now.drift;
  const auto& d_last = state.last.drift;
  Residuals<S, T, Tuning> residual = state.residual;
  Soundness<T> all;
  for (int i = 0; i < joint_count<S>; ++i) {
    auto& r = residual[i];
    if constexpr (is_stored_v<T>) {
      constexpr const auto& f = residual_formats<S, typename T::Word, Tuning>;
      constexpr auto share = static_cast<std::int32_t>(nearest_integer(residual_share<Tuning>() * power_of_two(30)));
      const std::int32_t next =
          next_residual(f, i, share, r.raw, p[i].raw, p_last[i].raw, tau[i].raw, d[i].raw, d_last[i].raw);
      const std::int32_t known = -static_cast<std::int32_t>(state.ready);
      r.raw = (next & known) | (r.raw & ~known);
    } else {
      // Looked at even where the observer starts: what is kept of this sample must not spoil the next.
      const T next = next_residual<Tuning>(r, p[i], p_last[i], tau[i], d[i], d_last[i]);
      all.number(next);
      r = select(state.ready, next, r);
    }
  }
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
/// observer at residual 0. Constant time for good samples. Fixed point: doc/observer.md.
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
