// Efforts that change no faster than declared: the last stage before the drives.
#pragma once

#include <axial/control/limits.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

/// How an effort moves towards another in one step.
template <class T>
struct Step {
  /// No limit at all.
  static constexpr T unlimited() { return (std::numeric_limits<T>::max)(); }
  /// `target` as far as `step` from `last` allows; true where it allows less. A step that is negative or NaN allows no
  /// change.
  static constexpr bool limit(T& target, const T& last, const T& step) {
    const T most = select(step >= T(Zero{}), step, T(Zero{})), low = last - most, high = last + most;
    const bool up = target > high, down = target < low;
    target = select(up, high, select(down, low, target));
    return up | down;
  }
};

template <class S, class T>
constexpr EffortsOf<S, T> unlimited_steps() {
  EffortsOf<S, T> steps{};
  for (int i = 0; i < joint_count<S>; ++i)
    steps[i] = Step<T>::unlimited();
  return steps;
}

}  // namespace detail

/// Efforts on their way to the drives, none of which changes by more than its `step` from one call to the next. The
/// caller's; where something else exerts efforts in between (a FallBack), set `last` to what it exerts.
template <class S, class T>
struct EffortRamp {
  EffortsOf<S, T> last{};                                  ///< N m or N, answered last; at the start none
  EffortsOf<S, T> step = detail::unlimited_steps<S, T>();  ///< N m or N, at most per call; unlimited until set

  /// The nearest efforts to `tau` (finite, N m or N) that the steps allow, which are `last` from now on. The status
  /// names the first joint that was limited. Each is exact to a rounding. Constant time.
  [[nodiscard]] constexpr Status limit(EffortsOf<S, T>& tau) {
    int joint = -1;
    for (int i = 0; i < joint_count<S>; ++i)
      joint = first_found(joint, detail::Step<T>::limit(tau[i], last[i], step[i]), i);
    last = tau;
    return status_of_first(Status::Code::effort_rate, joint);
  }
};

}  // namespace axial

#include <axial/options/end.hpp>
