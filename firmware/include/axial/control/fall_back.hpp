// What the drives exert when requests stop or were never good: no torque that nobody wants.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/control/controlled_stop.hpp>
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

/// What of a scene's inputs still holds when requests have stopped: loads, tools, gravity and the pairs of the
/// position. Motions of the base and of the water, and forces of the surroundings, are of their moment: a base at rest,
/// none.
template <class S, class T>
constexpr Inputs<S, T> lasting(Inputs<S, T> in) {
  using Scene = scene_of<S>;
  if constexpr (Scene::template has<BaseMotion> || Scene::template has<FloatingBase>) in.base_motion = {};
  if constexpr (Scene::template has<VelocityThroughWater>) in.velocity_through_water = {};
  if constexpr (Scene::template has<TipWrench>) in.tip_wrench = {};
  if constexpr (Scene::template has<ExternalWrenches>) in.wrenches = {};
  if constexpr (Scene::template has<BaseWrench>) in.base_wrench = {};
  return in;
}

/// Inputs of the last good request; a scene without any keeps no byte.
template <class S, class T, bool any = has_run_time_inputs<S, T>>
class KeptInputs {
 protected:
  constexpr void keep(const Inputs<S, T>& in) { in_ = lasting<S, T>(in); }
  /// Newer ones, at the position of those that are kept.
  constexpr void renew(Inputs<S, T> in) {
    if constexpr (scene_of<S>::template has<SineCosines>) in.turns = in_.turns;
    if (check_given<S, T>(in).ok()) keep(in);
  }
  [[nodiscard]] constexpr const Inputs<S, T>& kept() const { return in_; }

 private:
  Inputs<S, T> in_{};
};
template <class S, class T>
class KeptInputs<S, T, false> {
 protected:
  constexpr void keep(const Inputs<S, T>&) {}
  constexpr void renew(const Inputs<S, T>&) {}
  [[nodiscard]] constexpr Inputs<S, T> kept() const { return {}; }
};

}  // namespace detail

/// Stands between requests and drives; the caller's. It enables nothing itself: at every control tick the loop calls
/// advance(), exerts torque() and sets the drives' enable to enabled(). Where requests stop the torque fades into what
/// holds the arm; with a `Stop` (control/controlled_stop.hpp) the arm brakes to rest instead, and is held there.
/// Phases, times, and what is not claimed: doc/guides/safety.md.
template <class S, class T, class Stop = void>
class FallBack : detail::KeptInputs<S, T> {
  static constexpr bool brakes = !std::is_void_v<Stop>;
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
  /// its position q (rad or m). `in` as of that call: the load and gravity in it are what the arm is held with when
  /// requests stop; a wrench and the base's motion are not, for they are of that moment. False where the drives are
  /// disabled, and stay so until rearm().
  [[nodiscard]] constexpr bool follow(const Q& q, const Tau& tau, const Inputs<S, T>& in = no_inputs<S, T>()) {
    static_assert(!brakes,
                  "axial: a controlled stop begins with a motion; give follow() its Request<S, T> {q, qd, qdd}");
    if constexpr (!brakes) return take(q, tau, in);
    return false;
  }
  /// Likewise with a controlled stop: the whole motion, of which the stop begins. Of a loop with feedback the measured
  /// q and qd are the better ones.
  template <class Motion, class = std::enable_if_t<sizeof(Motion::qdd) != 0>>
  [[nodiscard]] constexpr bool follow(const Motion& motion, const Tau& tau,
                                      const Inputs<S, T>& in = no_inputs<S, T>()) {
    if constexpr (brakes)
      return take(Request<S, T>{motion.q, motion.qd, motion.qdd, {}}, tau, in);
    else
      return take(motion.q, tau, in);
  }

  /// No good request came yet, but the arm's position q (rad or m) is known, from a request that was refused for
  /// another reason or from encoders: the drives hold the arm there instead of letting it fall. A q that is not finite
  /// or outside the declared limits is no position; inputs that are none hold nothing. Once a request was good nothing
  /// happens: its torque stays until the clock runs out. True where holding begins.
  [[nodiscard]] constexpr bool hold_at(const Q& q, const Inputs<S, T>& in = no_inputs<S, T>()) {
    if (!detail::check_given<S, T>(in).ok()) return false;
    if (phase() != DrivePhase::idle || !check_position<S>(q).ok() || !find_hold(q, detail::lasting<S, T>(in)))
      return false;
    this->keep(in);
    if constexpr (brakes) path_.begin({q, {}, {}, {}});
    return phases_.hold();
  }

  /// `ticks` control ticks have passed. Once the last good request is `patience` ticks old, what holds the arm there is
  /// found (the cost of a gravity torque, once) with the inputs of that request; where that is not a number the torque
  /// leaves along the ramp.
  constexpr void advance(std::uint32_t ticks) {
    const DrivePhase before = phase();
    if constexpr (brakes)
      stop(ticks);
    else
      phases_.advance(times_, ticks);
    const bool held_before = before != DrivePhase::running && (!brakes || before != DrivePhase::fading);
    const bool held = phase() != DrivePhase::running && (!brakes || phase() != DrivePhase::fading);
    if (held && !held_before && !find_hold(path_.motion().q, this->kept())) hold_ = {};
  }
  /// Likewise, where a load or gravity is known to have changed since the last good request: from now on `in`, unless
  /// something is wrong with it. What holds the arm already stays as it was found.
  constexpr void advance(std::uint32_t ticks, const Inputs<S, T>& in) {
    this->renew(in);
    advance(ticks);
  }

  /// The torque to exert (N m or N): of the last good request while that is young. Then acceleration and speed leave
  /// it, tau = ID(q, sqrt(s) qd, s qdd) for a share s that falls in equal steps from 1 to 0, friction and feedback by s
  /// too: in each joint a straight line to what holds the arm; then that. No effort where the drives are disabled. It
  /// is inside the declared limits wherever the last good torque was. With a controlled stop: the inverse dynamics of
  /// braking, within the declared efforts, until every joint rests.
  [[nodiscard]] constexpr Tau torque() const {
    if (!enabled()) return {};
    if (phase() == DrivePhase::running || (brakes && phase() == DrivePhase::fading)) return last_;
    const std::uint32_t share = phases_.share(times_);
    Tau tau{};
    for (int i = 0; i < joint_count<S>; ++i)
      tau[i] = detail::Blend<T>::of(hold_[i], last_[i], share);
    return tau;
  }

  /// Where a controlled stop wants the arm now: rad or m, rad/s or m/s, and what it accelerates by until the next tick.
  /// A loop that measures tracks it. While requests are young that is the last one's motion, as it goes on.
  [[nodiscard]] constexpr const Request<S, T>& wanted() const {
    static_assert(brakes, "axial: wanted() is of a fall-back with a controlled stop, FallBack<S, T, Stop>");
    return path_.motion();
  }

  /// Sets other times from now on; the present phase keeps its age.
  constexpr void set_times(const FallBackTimes& times) { times_ = times; }

  /// Somebody asks for disabled drives again: the next good request enables them. An arm that is held stays held.
  constexpr void rearm() { phases_.rearm(); }

 private:
  [[nodiscard]] constexpr bool find_hold(const Q& q, const Inputs<S, T>& in) {
    if (!detail::check_given<S, T>(in).ok()) return false;
    auto tau = detail::holding_torque<S>(q, in);
    if (!detail::all_finite<S>(tau)) return false;
    detail::clamp_efforts<S>(tau);
    hold_ = tau;
    return true;
  }
  template <class Motion>
  [[nodiscard]] constexpr bool take(const Motion& motion, const Tau& tau, const Inputs<S, T>& in) {
    if (!phases_.follow()) return false;
    path_.begin(motion);
    last_ = tau;
    this->keep(in);
    return true;
  }

  /// Ticks until every joint rests, one after the other, which are as many as the stop takes however late; then what
  /// brakes is found.
  constexpr void stop(std::uint32_t ticks) {
    const FallBackTimes until_rest{times_.patience, 0xFFFF, times_.hold};
    for (; ticks > 0 && (phase() == DrivePhase::running || phase() == DrivePhase::fading); --ticks) {
      phase() == DrivePhase::running ? path_.coast() : path_.brake();
      phases_.advance(until_rest, 1);
      if (!path_.is_moving()) phases_.rest();
    }
    if (phase() == DrivePhase::fading) {
      path_.plan();
      brake();
    }
    phases_.advance(until_rest, ticks);
  }
  constexpr void brake() {
    const auto& motion = path_.motion();
    auto in = this->kept();
    if constexpr (scene_of<S>::template has<SineCosines>) in.turns = sine_cosines<S>(motion.q);
    auto tau = inverse_dynamics<S>(motion.q, motion.qd, motion.qdd, in);
    if (!detail::all_finite<S>(tau)) return;
    detail::clamp_efforts<S>(tau);
    last_ = tau;
  }

  FallBackTimes times_{};
  DrivePhases phases_{};
  detail::Braking<S, T, Stop> path_{};
  Tau last_{}, hold_{};
};

}  // namespace axial

#include <axial/options/end.hpp>
