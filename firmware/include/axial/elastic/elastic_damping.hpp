// Feed-forward of elastic joints that are damped, too: the deflection lags behind its torque.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/elastic/elastic_feedforward.hpp>
#include <axial/scalar/select.hpp>
#include <axial/scalar/traits.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace elastic {

/// How a first-order lag moves on in one period, of which it is `x` >= 0 lags long: `kept` = e^-x of what it lacks,
/// less `added` = (1 - e^-x) / x of what was asked more since. Set-up, in double.
struct Lag {
  double kept = 0.0, added = 0.0;  ///< both 0 where there is no lag
  /// Shares for a period of x lags; x is infinite where there is no lag.
  constexpr explicit Lag(double x) {
    added = 1.0 / x;
    if (!(x < most)) return;
    added = 0.0;
    double share = x;
    int halvings = 0;
    for (; share > 0.5; ++halvings)
      share *= 0.5;
    double term = 1.0;
    for (int n = 1; n < 20; ++n) {  // e^-x and (1 - e^-x) / x, without cancellation for a short period
      added += term / n;
      kept += term;
      term *= -share / n;
    }
    for (; halvings > 0; --halvings)
      added *= 0.5 * (1.0 + kept), kept *= kept;
  }

 private:
  static constexpr double most = 700.0;
};

}  // namespace elastic

/// What damped joints remember from one call to the next, owned by the caller: of every joint how far the
/// deflection's acceleration is off that without damping. Two words and three constants per joint.
template <class S, class T>
class ElasticState {
  using Robot = robot_of<S>;
  static_assert(is_number_v<T> && std::numeric_limits<T>::is_iec559,
                "axial: ElasticState holds float or double; elastic joints have no formats in fixed point");

 public:
  /// For calls every `period` seconds (> 0) with `damping` D of every joint, N m s/rad or N s/m (>= 0, 0: none). Costs
  /// an exponential per joint in double: make it once, or constexpr.
  constexpr ElasticState(double period, const Joints<Robot, double>& damping) {
    for (int i = 0; i < Robot::chain.size; ++i) {
      const double lag = damping[i] / Robot::chain.links[i].stiffness;
      const elastic::Lag step(lag > 0.0 ? period / lag : std::numeric_limits<double>::infinity());
      lag_[i] = NumberTraits<T>::constant(lag);
      kept_[i] = NumberTraits<T>::constant(step.kept), added_[i] = NumberTraits<T>::constant(step.added);
    }
  }
  /// The next call begins a motion: its deflections move as they would without damping.
  constexpr void restart() { started_ = false; }

  /// Lag of joint i: D / K, s.
  [[nodiscard]] constexpr const T& lag(int i) const { return lag_[i]; }
  /// Acceleration of the deflection of joint i where without damping it would be `wanted`; remembers it, unless that
  /// is no number.
  [[nodiscard]] constexpr T acceleration(int i, const T& wanted) {
    const T lacks = select(started_, kept_[i] * lacks_[i] - added_[i] * (wanted - last_[i]), T(0));
    const bool finite = is_finite(wanted);
    lacks_[i] = select(finite, lacks, lacks_[i]), last_[i] = select(finite, wanted, last_[i]);
    return wanted + lacks;
  }
  constexpr void go_on() { started_ = true; }  ///< Every joint has had its call.

 private:
  Joints<Robot, T> lag_{}, kept_{}, added_{}, lacks_{}, last_{};
  bool started_ = false;
};

namespace elastic {

/// drive() of a damped joint: with y = tau_l / K and the lag r = D / K the deflection d obeys d + r d' = y, and
/// so do its derivatives. z = d'' comes from y'' through the lag; then d' = y' - r z and d = y - r d', without a
/// division by r.
template <class Motors, class I, class Tau, class V, class A, class State, class Result>
AXIAL_INLINE constexpr void drive_damped(const Motors& motors, I i, const Tau& tau, const V& qd, const A& qdd,
                                         State& state, Result& result) {
  using T = typename Motors::Scalar;
  auto motor = motors.link(i);
  auto c = compliance<Motors>(i);
  const T z = state.acceleration(i, T(c * twice(quadratic_of(tau))));
  const T rate = T(c * linear_of(tau)) - state.lag(i) * z;
  result.tau_l[i] = value_at_0(tau);
  result.theta[i] = result.theta[i] + (T(c * value_at_0(tau)) - state.lag(i) * rate);
  result.thetad[i] = qd + rate;
  result.tau_m[i] = motor.rotor() * (qdd + z) + value_at_0(tau) + friction_effort(motor, result.thetad[i]);
}

}  // namespace elastic

/// Feed-forward of elastic joints with dampers, tau_l = K (theta - q) + D (theta-d - q-d): as the function
/// without a state, and called once every period of the state. The deflection follows its torque through a stable
/// first-order lag D/K per joint, which is exact where the second derivative of tau_l changes evenly between two calls.
/// It begins as without damping, which is exact of a motion that begins at rest. A call with NaN answers NaN and leaves
/// the state as it was. Constant time; with D = 0 what the other function answers.
template <class S, class T>
[[nodiscard]] constexpr ElasticFeedforward<S, T> elastic_feedforward(
    ElasticState<S, T>& state, const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd,
    const Accelerations<robot_of<S>, T>& qdd, const Joints<robot_of<S>, T>& q3, const Joints<robot_of<S>, T>& q4,
    const Inputs<S, T>& in = no_inputs<S, T>()) {
  detail::check_elastic<S, T>();
  using Links = typename elastic::WithoutMotors<scene_of<S>>::type;
  const auto motors = links_of<S, T, FullParameters>();
  ElasticFeedforward<S, T> result{};
  result.theta = q;
  execute<derivatives::InTime>(links_of<Links, T, BaseParameters>(), in, q, qd, qdd, q3, q4,
                               [&](auto i, const auto& effort) AXIAL_INLINE {
                                 elastic::drive_damped(motors, i, effort, qd[i], qdd[i], state, result);
                               });
  state.go_on();
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
