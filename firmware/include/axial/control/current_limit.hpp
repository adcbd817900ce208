// Currents that a motor's winding stands: an I^2 t limit, by a thermal model of first order.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/control/limits.hpp>
#include <axial/scalar/math.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

/// 1 - exp(-y) for y >= 0, to some roundings; meant for constants: it loops.
constexpr double decayed(double y) {
  if (!(y < 50.0)) return y >= 50.0 ? 1.0 : y;
  int halvings = 0;
  for (; y > 0.03125; y *= 0.5)
    ++halvings;
  double sum = 0.0;
  for (int k = 9; k > 0; --k)
    sum = y / k * (1.0 - sum);
  for (; halvings > 0; --halvings)
    sum = sum * (2.0 - sum);
  return sum;
}

/// The y >= 0 of which decayed(y) is `share`, 0 < share < 1: Newton's iteration from below, which is monotone.
constexpr double time_to_decay(double share) {
  double y = 0.0;
  for (double next = share; next > y;) {
    y = next;
    next = y + (share - decayed(y)) / (1.0 - decayed(y));
  }
  return y;
}

}  // namespace detail

/// What the maker of a drive says of it, by name: continuous_current and peak_current, the torque constant, and
/// time_constant_s or peak_time_s.
class DriveRating {
  template <class Change>
  [[nodiscard]] constexpr DriveRating with(Change change) const {
    DriveRating changed = *this;
    change(changed);
    return changed;
  }  // before its uses: clang needs it for constants

 public:
  /// Current that the winding stands for ever, A.
  [[nodiscard]] constexpr DriveRating continuous_current(double amperes) const {
    return with([&](auto& r) { r.continuous_ = amperes; });
  }
  /// Largest current, A; the continuous one or more.
  [[nodiscard]] constexpr DriveRating peak_current(double amperes) const {
    return with([&](auto& r) { r.peak_ = amperes; });
  }
  /// Thermal time constant of the winding, s.
  [[nodiscard]] constexpr DriveRating time_constant_s(double seconds) const {
    return with([&](auto& r) { r.time_constant_ = seconds; });
  }
  /// How long a cold winding stands the peak current, s: another way to say its time constant, -t / ln(1 - (Ic/Ip)^2).
  [[nodiscard]] constexpr DriveRating peak_time_s(double seconds) const {
    return with([&](auto& r) { r.peak_time_ = seconds; });
  }
  /// Effort at the joint for a current: the motor's torque constant, N m/A or N/A, times motor turns per joint turn
  /// (for a slide rad/m), times the gear's efficiency.
  [[nodiscard]] constexpr DriveRating torque_constant(double newton_metres_per_ampere, double gear = 1.0,
                                                      double efficiency = 1.0) const {
    return with([&](auto& r) { r.effort_constant_ = newton_metres_per_ampere * gear * efficiency; });
  }
  /// Share of the heat that the winding stands, from which on the limit falls; 0.8 until named, less than 1.
  [[nodiscard]] constexpr DriveRating fold_back(double share) const {
    return with([&](auto& r) { r.fold_back_ = share; });
  }

  /// N m or N at the joint
  [[nodiscard]] constexpr double continuous_effort() const { return effort_constant_ * continuous_; }
  /// peak over continuous current; 0 where there is none
  [[nodiscard]] constexpr double peak_ratio() const { return continuous_ > 0.0 ? peak_ / continuous_ : 0.0; }
  /// heat at which the limit begins to fall, as a share of what the winding stands
  [[nodiscard]] constexpr double fold_back() const { return fold_back_; }
  /// s, given or from the time that a cold winding stands the peak; NaN where neither or both are given
  [[nodiscard]] constexpr double time_constant() const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (time_constant_ > 0.0) return peak_time_ > 0.0 ? none : time_constant_;
    return peak_time_ > 0.0 && peak_ratio() > 1.0
               ? peak_time_ / detail::time_to_decay(1.0 / peak_ratio() / peak_ratio())
               : none;
  }

 private:
  double continuous_ = 0.0, peak_ = 0.0, time_constant_ = 0.0, peak_time_ = 0.0, effort_constant_ = 0.0,
         fold_back_ = 0.8;
};

/// Ratings of the drives as a loop computes with them; current_limits() makes them.
template <class S, class T>
struct CurrentLimits {
  /// Constants of one drive; all 0, and no effort is let through, where its rating means nothing.
  struct Joint {
    T continuous{};          ///< N m or N, what the winding stands for ever
    T beyond{};              ///< N m or N, by how much the peak is more
    T inverse_continuous{};  ///< 1/(N m) or 1/N
    T inverse_margin{};      ///< 1 / (1 - heat at the beginning of the fall)
    T gain{};                ///< 1 - exp(-period / time constant)
    T steepest_change{};     ///< N m or N, by how much the limit changes from one call to the next, at most
  };
  Joint joints[joint_count<S>] = {};  ///< from the base outwards
  Status status{};                    ///< input_limit: the first joint whose rating means nothing
};

/// Heat of the windings, owned by the caller: 1 is what each stands, as it gets by its continuous current for ever.
/// Starts hot, for nobody knows what was done before a reset; set 0 for windings that are known to be cold.
template <class S, class T>
struct WindingHeat {
  T heat[joint_count<S>];       ///< as a share of what the winding stands
  T rest[joint_count<S>] = {};  ///< what `heat` is too coarse to hold
  EffortsOf<S, T> last{};       ///< N m or N, let through last

  constexpr WindingHeat() : heat{} {
    for (T& h : heat)
      h = T(One{});
  }
};

namespace detail {

// True where a rating means something and its limit never lets the heat pass 1 from one call to the next.
constexpr bool is_sound(const DriveRating& r, double gain) {
  const double ratio = r.peak_ratio(), margin = 1.0 - r.fold_back();
  const bool positive = r.continuous_effort() > 0.0 && ratio >= 1.0 && gain > 0.0;
  const bool folds = r.fold_back() >= 0.0 && margin > 0.0;
  const bool finite = is_finite(r.continuous_effort()) && is_finite(ratio);
  return positive && folds && finite && gain * (1.0 + (ratio * ratio - 1.0) / margin) <= 1.0;
}

template <class S, class T>
constexpr typename CurrentLimits<S, T>::Joint current_limit_of(const DriveRating& r, double gain) {
  using N = NumberTraits<T>;
  // Lower by some roundings of T, so that none of them lets the heat pass 1.
  const double continuous = r.continuous_effort() * (1.0 - 8.0 * static_cast<double>(N::epsilon()));
  const double ratio = r.peak_ratio(), margin = 1.0 - r.fold_back(), beyond = continuous * (ratio - 1.0);
  const double warming = ratio * ratio - r.fold_back(), cooling = 1.0;  // at most, where the limit follows the heat
  return {N::constant(continuous),
          N::constant(beyond),
          N::constant(1.0 / continuous),
          N::constant(1.0 / margin),
          N::constant(gain),
          N::constant(beyond / margin * gain * (warming > cooling ? warming : cooling))};
}

}  // namespace detail

/// Limits of a robot's drives, one rating per joint, for limit_currents() called every `period` seconds. Meant for a
/// constant: `static constexpr auto limits = axial::current_limits<Robot, float>({a, b, c}, 1e-3);` with a
/// static_assert on its status. input_limit names the first joint whose rating is not positive or not finite, whose
/// peak is below the continuous current, that has neither or both of time constant and peak time, or whose winding is
/// too fast for the period (its heat could pass 1 within one).
template <class S, class T, int N>
[[nodiscard]] constexpr CurrentLimits<S, T> current_limits(const DriveRating (&ratings)[N], double period) {
  static_assert(std::is_floating_point_v<T>,
                "axial: current limits are in float or double; convert efforts of fixed point first");
  static_assert(N == joint_count<S>, "axial: current_limits() takes one rating per joint, from the base outwards");
  CurrentLimits<S, T> limits{};
  for (int i = N; i-- > 0;) {
    const double gain = period > 0.0 ? detail::decayed(period / ratings[i].time_constant()) : 0.0;
    if (!detail::is_sound(ratings[i], gain))
      limits.status = {Status::Code::input_limit, i};
    else if constexpr (std::is_floating_point_v<T>)
      limits.joints[i] = detail::current_limit_of<S, T>(ratings[i], gain);
  }
  return limits;
}

/// Effort (N m or N) that the heat h of a winding allows: the peak below the beginning of the fall, from there in a
/// straight line to the continuous effort at h = 1, and beyond.
template <class L, class T>
[[nodiscard]] constexpr T allowed_effort(const L& limit, const T& h) {
  const T zero(Zero{}), one(One{}), room = (one - h) * limit.inverse_margin;
  return limit.continuous + limit.beyond * select(room > one, one, select(room > zero, room, zero));
}

/// Limits efforts on their way to the drives to what their windings stand, and warms those by what is let through. The
/// heat h of a winding follows dh/dt = ((i/i_c)^2 - h) / time constant, exactly for a current i that is constant over
/// the period; i is the effort over the torque constant. Call it once per period, last.
/// In and out: `tau`, N m or N. The status names the first joint that was limited (current_limit; met()). An effort
/// that is not finite (not_finite) leaves the last ones, as far as the windings stand them, and the status names it.
/// The modelled heat never passes 1, whatever is asked for; from 1 the limit is the continuous effort. From one call to
/// the next a limit changes by at most `steepest_change`: so an effort changes by no more than that or than its request
/// does. Behind track(), set its state's `output.last` to the answer, so that its ramp starts where the drives are.
/// The model has the winding alone: the ambient that continuous_current was told for, iron and housing at rest.
/// The number of instructions does not depend on finite efforts.
template <class S, class T>
[[nodiscard]] constexpr Status limit_currents(WindingHeat<S, T>& state, const CurrentLimits<S, T>& limits,
                                              EffortsOf<S, T>& tau) {
  int bad = -1, limited = -1;
  for (int i = 0; i < joint_count<S>; ++i)
    bad = first_found(bad, !is_finite(tau[i]), i);
  if (bad >= 0) tau = state.last;
  for (int i = 0; i < joint_count<S>; ++i) {
    const auto& limit = limits.joints[i];
    const int outside = detail::LimitsFor<S, T>::clamp(allowed_effort(limit, state.heat[i]), tau[i]);
    limited = first_found(limited, outside != 0, i);
    const T share = tau[i] * limit.inverse_continuous, h = state.heat[i];
    // Kahan's sum: a winding of minutes warms by less than a rounding of h in a millisecond.
    const T change = limit.gain * (share * share - h) + state.rest[i];
    state.heat[i] = h + change;
    state.rest[i] = change - (state.heat[i] - h);
  }
  state.last = tau;
  if (bad >= 0) return {Status::Code::not_finite, bad};
  return status_of_first(Status::Code::current_limit, limited);
}

}  // namespace axial

#include <axial/options/end.hpp>
