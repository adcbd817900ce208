// End stops: a spring and a damper beyond each declared position limit.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/scalar/select.hpp>
#include <axial/simulation/integrators.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// What a joint meets at its position limits: N m/rad and N m s/rad, on slides N/m and N s/m. The damper acts in the
/// stop alone, and neither ever pulls.
struct EndStops {
  double stiffness = 0.0;  ///< N m/rad or N/m
  double damping = 0.0;    ///< N m s/rad or N s/m
};

/// A drive, and stops at the position limits that the robot declares, where joints share drives at those of each drive
/// (drive_limits()); one without limits has none. The drive is only referred to. It tells an implicit method how stiff
/// it is while a joint is in a stop, so that LinearlyImplicitEuler and StickingEuler take any step: a joint by itself
/// leaves a stop no faster than it came, v' = v (1 - k s) / (1 + k + d), where k = h^2 K/M, d = h D/M and s of its last
/// step, of 1, lies in the stop. For an explicit method ask step_limit() with the same stiffness first.
template <class S, class T, class Drive>
class WithEndStops {
 public:
  static_assert(!detail::is_word<T>,
                "axial: end stops in fixed point are those of axial/fixed/simulation/sticking.hpp; include it");

  /// `drive` as advance() takes it
  constexpr WithEndStops(const Drive& drive, const EndStops& stops)
      : drive_(drive), stiffness_(T(stops.stiffness)), damping_(T(stops.damping)) {}

  /// The drive's efforts, and those of the stops.
  template <class Where>
  constexpr void operator()(const Where& at, EffortsOf<S, T>& tau, Inputs<S, T>& in, DriveStiffness<S, T>& told) const {
    if constexpr (detail::tells_stiffness<Drive, S, T>)
      drive_(at, tau, in, told);
    else
      drive_(at, tau, in);
    for (int i = 0; i < joint_count<S>; ++i)
      stop(limits.low[i], limits.high[i], at.q[i], at.qd[i], tau[i], told.stiffness[i], told.damping[i]);
  }

 private:
  struct Limits {
    T low[joint_count<S>] = {}, high[joint_count<S>] = {};
    constexpr Limits() {
      for (int i = 0; i < joint_count<S>; ++i) {
        const LinkParameters& link = scene_of<S>::Robot::chain.links[i];
        low[i] = static_cast<T>(link.position_min), high[i] = static_cast<T>(link.position_max);
      }
    }
  };
  static constexpr Limits limits{};

  constexpr void stop(const T& low, const T& high, const T& q, const T& qd, T& tau, T& stiffness, T& damping) const {
    const T beyond = select(q > high, T(q - high), select(q < low, T(q - low), T(0)));
    const T push = stiffness_ * beyond + damping_ * qd;
    const bool meets = push * beyond > T(0);
    tau = tau - select(meets, push, T(0));
    stiffness = stiffness + select(meets, stiffness_, T(0)), damping = damping + select(meets, damping_, T(0));
  }

  const Drive& drive_;
  T stiffness_, damping_;
};

}  // namespace axial

#include <axial/options/end.hpp>
