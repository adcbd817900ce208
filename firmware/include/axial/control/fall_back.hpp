// What the drives exert when requests stop or were never good: no torque that nobody wants.
#pragma once

#include <axial/control/drive_phase.hpp>
#include <axial/control/feedforward.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

/// How two efforts are blended.
template <class T>
struct Blend {
  /// `to`, and the share (in 2^-16) of what leads from it to `from`.
  static constexpr T of(const T& to, const T& from, std::uint32_t share) {
    return to + (from - to) * (static_cast<T>(static_cast<std::int32_t>(share)) * T(1.0 / 65536.0));
  }
};

}  // namespace detail

/// Stands between requests and drives; the caller's. It enables nothing itself: at every control tick the loop calls
/// advance(), exerts torque() and sets the drives' enable to enabled(). Phases, times, and what is not claimed:
/// doc/guides/safety.md.
template <class S, class T>
class FallBack {
  using Q = Positions<robot_of<S>, T>;
  using Tau = EffortsOf<S, T>;

 public:
  constexpr FallBack() = default;
  /// A fall-back with times other than the default ones.
  constexpr explicit FallBack(const FallBackTimes& times) : times_(times) {}

  [[nodiscard]] AXIAL_INLINE constexpr DrivePhase phase() const {
    return phases_.phase();
  }  ///< what the drives are doing
  [[nodiscard]] AXIAL_INLINE constexpr bool enabled() const {
    return phases_.enabled();
  }  ///< whether they are to be enabled

  /// A good request: from now on its torque `tau` (N m or N, as feedforward() gave it, with what a feedback adds) at
  /// its position q (rad or m). False where the drives are disabled, and stay so until rearm().
  [[nodiscard]] constexpr bool follow(const Q& q, const Tau& tau) {
    if (!phases_.follow()) return false;
    q_ = q;
    last_ = tau;
    return true;
  }

  /// No good request came yet, but the arm's position q (rad or m) is known, from a request that was refused for
  /// another reason or from encoders: the drives hold the arm there instead of letting it fall. A q that is not finite
  /// or outside the declared limits is no position. Once a request was good nothing happens: its torque stays until the
  /// clock runs out. True where holding begins.
  [[nodiscard]] constexpr bool hold_at(const Q& q, const Inputs<S, T>& in = {}) {
    if (phase() != DrivePhase::idle || !check_position<S>(q).ok() || !find_hold(q, in)) return false;
    return phases_.hold();
  }

  /// `ticks` control ticks have passed. Once the last good request is `patience` ticks old, what holds the arm there is
  /// found (the cost of a gravity torque, once) with the inputs as they are then; where that is not a number the torque
  /// leaves along the ramp.
  constexpr void advance(std::uint32_t ticks, const Inputs<S, T>& in = {}) {
    const bool ran = phase() == DrivePhase::running;
    phases_.advance(times_, ticks);
    if (ran && phase() != DrivePhase::running && !find_hold(q_, in)) hold_ = {};
  }

  /// The torque to exert (N m or N): of the last good request while that is young. Then acceleration and speed leave
  /// it, tau = ID(q, sqrt(s) qd, s qdd) for a share s that falls in equal steps from 1 to 0, friction and feedback by s
  /// too: in each joint a straight line to what holds the arm; then that. No effort where the drives are disabled. It
  /// is inside the declared limits wherever the last good torque was.
  [[nodiscard]] constexpr Tau torque() const {
    if (!enabled()) return {};
    if (phase() == DrivePhase::running) return last_;
    const std::uint32_t share = phases_.share(times_);
    Tau tau{};
    for (int i = 0; i < joint_count<S>; ++i)
      tau[i] = detail::Blend<T>::of(hold_[i], last_[i], share);
    return tau;
  }

  /// Sets other times from now on; the present phase keeps its age.
  constexpr void set_times(const FallBackTimes& times) { times_ = times; }

  /// Somebody asks for disabled drives again: the next good request enables them. An arm that is held stays held.
  constexpr void rearm() { phases_.rearm(); }

 private:
  [[nodiscard]] constexpr bool find_hold(const Q& q, const Inputs<S, T>& in) {
    auto tau = gravity_torque<S>(q, in);
    if (!detail::all_finite<S>(tau)) return false;
    detail::clamp_efforts<S>(tau);
    hold_ = tau;
    return true;
  }

  FallBackTimes times_{};
  DrivePhases phases_{};
  Q q_{};
  Tau last_{}, hold_{};
};

}  // namespace axial

#include <axial/options/end.hpp>
