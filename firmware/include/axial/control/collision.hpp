// Collisions from the residuals of a momentum observer: thresholds, confirmation, hysteresis.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/control/momentum_observer.hpp>

#include <axial/options/begin.hpp>

namespace axial {

// A detector's tuning is the observer's type with also, `static constexpr`
//   double fraction      of the joint's declared effort limit: the part of the threshold that follows the drive
//   double uncertainty   N m or N that the model, the friction and the sensors may be wrong by, for every joint
//   double release       of the threshold, below which a residual counts as calm (hysteresis), in (0, 1]
//   int confirm, calm    samples in a row above the threshold that make a collision; calm ones that end it
// Time to detection of a step of effort x beyond threshold d: ln(x / (x - d)) / gain + confirm period.

/// Thresholds of the joints, N m or N; in fixed point raw, in the residual's format.
template <class S, class T, class Tuning>
struct CollisionThresholds {
  /// beyond the first a residual is a contact, below the second it is calm
  T enter[joint_count<S>] = {}, leave[joint_count<S>] = {};
};

/// Memory of a detector, owned by the caller; start with `{}`.
struct CollisionState {
  int above = 0, below = 0;  ///< samples in a row
  bool collision = false;    ///< confirmed, and not yet calm
};

/// What a detector says of a sample.
struct Collision {
  bool detected = false;  ///< confirmed and not yet calm
  int joint = -1;         ///< the outermost joint beyond its threshold now: the contact is there or farther out
  Status status{};        ///< not_finite: a residual is NaN or infinite, and the sample was left out
};

namespace detail {

/// Residuals as values: what they are compared with, and how.
template <class S, class T, class Tuning>
struct ResidualValue {
  /// `x` N m or N at joint i
  static constexpr T of(double x, int) { return NumberTraits<T>::constant(x); }
  /// Whether |x| > most; x is finite. Neither comparison depends on the other's answer, here and below: no branch.
  AXIAL_INLINE static constexpr bool beyond(const T& x, const T& most) { return !((x <= most) & (-x <= most)); }
};

template <class S, class T, class Tuning>
constexpr CollisionThresholds<S, T, Tuning> collision_thresholds() {
  static_assert(Tuning::fraction >= 0.0 && Tuning::uncertainty >= 0.0 && Tuning::release > 0.0 &&
                    Tuning::release <= 1.0 && Tuning::confirm >= 1 && Tuning::calm >= 1,
                "axial: a detector's fraction and uncertainty are not negative, its release is in (0, 1], its confirm "
                "and calm are 1 or more");
  CollisionThresholds<S, T, Tuning> all{};
  for (int i = 0; i < joint_count<S>; ++i) {
    const double most = scene_of<S>::Robot::chain.links[i].effort_limit;
    const double enter = (is_bounded(most) ? Tuning::fraction * most : 0.0) + Tuning::uncertainty;
    all.enter[i] = ResidualValue<S, T, Tuning>::of(enter, i);
    all.leave[i] = ResidualValue<S, T, Tuning>::of(Tuning::release * enter, i);
  }
  return all;
}

// Samples in a row, held at most so that nothing wraps.
constexpr int counted_on(int count, bool now, int most) {
  const int next = count + static_cast<int>(is_negative(count - most));
  return next & -static_cast<int>(now);
}

}  // namespace detail

/// The thresholds of a tuning, as a constant.
template <class S, class T, class Tuning>
inline constexpr auto collision_thresholds_of = detail::collision_thresholds<S, T, Tuning>();

/// One sample of the detector: a collision begins after `confirm` samples in a row in which some joint's residual is
/// beyond its threshold, and ends after `calm` samples in a row in which all are below `release` of it. A function of
/// the state and of the residuals alone; constant time. A sample with a residual that is NaN or infinite (observe()
/// leaves none) counts as neither: the memory stays, `detected` is what it was, and the status says not_finite.
template <class S, class T, class Tuning>
[[nodiscard]] constexpr Collision detect(CollisionState& state, const Residuals<S, T, Tuning>& residual) {
  using Value = detail::ResidualValue<S, T, Tuning>;
  constexpr const auto& threshold = collision_thresholds_of<S, T, Tuning>;
  bool any = false, loud = false;
  int joint = -1;
  Soundness<T> all;
  for (int i = 0; i < joint_count<S>; ++i) {
    const bool over = Value::beyond(residual[i], threshold.enter[i]);
    any = any | over, loud = loud | Value::beyond(residual[i], threshold.leave[i]);
    joint = select(over, i, joint);
    all.number(residual[i]);
  }
  const Status status = all.status();
  const bool sound = status.ok();
  state.above = select(sound, detail::counted_on(state.above, any, Tuning::confirm), state.above);
  state.below = select(sound, detail::counted_on(state.below, !loud, Tuning::calm), state.below);
  // Counts end there; equality, because a Cortex-M0 compares for order by a branch.
  const bool begins = state.above == Tuning::confirm, ends = state.below == Tuning::calm;
  state.collision = begins | (state.collision & !ends);
  return {state.collision, select(sound, joint, -1), status};
}

}  // namespace axial

#include <axial/options/end.hpp>
