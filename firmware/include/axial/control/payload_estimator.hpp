// Mass and first moment of a payload from the residuals of an observer that does not know of it: recursive least
// squares.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/control/payload_equations.hpp>
#include <axial/control/payload_sums.hpp>

#include <axial/options/begin.hpp>

namespace axial {

// A tuning is the observer's type with also, `static constexpr double`
//   deviation          of a residual, as a share of the joint's declared effort limit: sensors and model together
//   memory             s, after which a sample counts 1/e; in fixed point the nearest power of two of periods
//   mass_deviation     kg, moment_deviation kg m: with larger ones an estimate is not ready

namespace detail {

template <class T>
struct PayloadSumOf {
  using type = T;
};
template <class S, class T, class Tuning>
struct ResidualInput {
  using type = Joints<robot_of<S>, T>;
};

}  // namespace detail

/// Memory of an estimator, owned by the caller; start with `{}`, and again when the payload changes.
template <class S, class T>
struct PayloadState {
  using Sum = typename detail::PayloadSumOf<T>::type;  ///< a number, in fixed point 96 bits
  detail::PayloadColumns<S, T> last{};                 ///< columns of the previous sample
  detail::PayloadRow<T> lagged[joint_count<S>] = {};   ///< columns behind the observer's lag, as residuals of -1
  Sum information[4][4] = {}, moment[4] = {};          ///< of the normal equations: lower triangle, right-hand side
  bool ready = false;                                  ///< whether `last` is the previous sample's
};

namespace detail {

/// Rows of the sample `now` behind the observer's lag, and whether the sample is sound: numbers so small that no sum of
/// what was ever added can overflow.
template <class S, class T, class Tuning>
constexpr Status lag_columns(const PayloadState<S, T>& state, const PayloadColumns<S, T>& now,
                             const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd,
                             const typename ResidualInput<S, T, Tuning>::type& residual,
                             PayloadRow<T> (&lagged)[joint_count<S>]) {
  using Sums = PayloadSums<S, T, Tuning>;
  Soundness<T> all;
  typename Sums::Squares squares;
  for (int i = 0; i < joint_count<S>; ++i) {
    const auto& p = now.momentum[i].of;
    const auto& d = now.drift[i].of;
    const auto& p_last = state.last.momentum[i].of;
    const auto& d_last = state.last.drift[i].of;
    for (int k = 0; k < 4; ++k) {
      const T row = Sums::lagged(k, state.lagged[i].of[k], p[k], p_last[k], d[k], d_last[k]);
      squares.add(row);  // where it starts too: what is kept of this sample must not spoil the next
      lagged[i].of[k] = Sums::chosen(state.ready, row, state.lagged[i].of[k]);
    }
    squares.add(residual[i]);
    scene_of<S>::Robot::chain.links[i].type == JointType::revolute ? all.angle(q[i]) : all.number(q[i]);
    all.number(qd[i]);
  }
  all.number(squares.scaled());
  return all.status();
}

/// Forgets a little and adds a sample.
template <class S, class T, class Tuning>
constexpr void learn(PayloadState<S, T>& state, const PayloadRow<T> (&lagged)[joint_count<S>],
                     const typename ResidualInput<S, T, Tuning>::type& residual) {
  using Sums = PayloadSums<S, T, Tuning>;
  for (int i = 0; i < 4; ++i) {
    Sums::forget(state.moment[i]);
    for (int j = 0; j <= i; ++j)
      Sums::forget(state.information[i][j]);
  }
  for (int i = 0; i < joint_count<S>; ++i) {
    state.lagged[i] = lagged[i];
    Sums::add(state.information, state.moment, state.ready, i, lagged[i], residual[i]);
  }
}

}  // namespace detail

/// What is known of a payload. In fixed point T is Scaled; payload_words() makes words of it.
template <class T>
struct PayloadEstimate {
  T mass{};                ///< kg
  Vec3<T> first_moment{};  ///< kg m, about the last link's origin in its axes
  T variance[4] = {};      ///< of mass (kg^2), first moment about the tool point (kg^2 m^2), with the tuning's noise
  Status status{};         ///< not_ready: what was seen does not tell the payload's parameters apart well enough
                           ///< (nor where variances are not finite); not_finite: an overflow

  /// The estimate as the scene's Payload takes it: a body of no extent. Without a mass beyond 0 there is none.
  [[nodiscard]] constexpr PayloadBody<T> body() const {
    const bool some = mass > T(Zero{});
    const T kg = select(some, mass, T(One{})), zero(Zero{});
    const T per_kg = select(some, reciprocal(kg), zero);
    return {select(some, mass, zero), per_kg * first_moment, {}};
  }
};

/// One sample: brings the payload's columns behind the observer's own lag and adds them and the residual to the normal
/// equations, weighted by the joints' deviations, older samples forgotten. A payload that the observer does not know
/// pushes back: residual = -(d(columns momentum)/dt - columns drift) (mass, first moment), so that no acceleration is
/// needed. Give it the residual that observe() left for the same q and qd, when that said ok; set `ready` to false
/// after a gap. An external contact is taken for payload: leave samples of collisions out. The payload's inertia about
/// the tool point is left out. In fixed point in integers; of a fixed-point observer you may also give a floating-point
/// estimator the residual as numbers. The first sample only starts it. A sample that is NaN or infinite, or overflows
/// on the way into the sums (not_finite), one of angles without exact sines (angle_range), and in fixed point one
/// beyond the declared limits (position_limit, speed_limit, with the joint) is left out: what was learnt stays, and the
/// next good sample starts anew from it. Constant time for good samples, 4x4 whatever the robot.
template <class S, class T, class Tuning>
[[nodiscard]] constexpr Status update_payload(PayloadState<S, T>& state, const Positions<robot_of<S>, T>& q,
                                              const Velocities<robot_of<S>, T>& qd,
                                              const typename detail::ResidualInput<S, T, Tuning>::type& residual) {
  static_assert(Tuning::deviation > 0.0 && Tuning::memory > 0.0, "axial: deviation and memory are positive");
  detail::check_weighing<T>();
  detail::check_weighed<scene_of<S>>();
  if constexpr (std::is_same_v<T, Fixed16>) {
    return {};
  } else {
    if (const Status outside = detail::LimitsFor<S, T>::check_state(q, qd); !outside.ok()) {
      state.ready = false;
      return outside;
    }
    const auto now = detail::payload_columns<S, T>(q, qd);
    detail::PayloadRow<T> lagged[joint_count<S>];
    const Status status = detail::lag_columns<S, T, Tuning>(state, now, q, qd, residual, lagged);
    if (!status.ok()) {
      state.last = {}, state.ready = false;
      return status;
    }
    detail::learn<S, T, Tuning>(state, lagged, residual);
    state.last = now, state.ready = true;
    return {};
  }
}

/// Least-squares estimate of the payload from what was weighed, and how sure it is. Constant time: one L D L^T of 4x4.
/// In fixed point in integers with an exponent each (Scaled), by the same source.
template <class Tuning, class S, class T>
[[nodiscard]] constexpr auto estimate(const PayloadState<S, T>& state) {
  using Sums = detail::PayloadSums<S, T, Tuning>;
  using X = typename Sums::Number;
  using N = NumberTraits<X>;
  X information[4][4] = {}, x[4] = {};
  for (int i = 0; i < 4; ++i) {
    x[i] = Sums::moment(state.moment[i], i);
    for (int j = 0; j <= i; ++j)
      information[i][j] = Sums::information(state.information[i][j], i, j);
  }
  const detail::Equations<X> equations(information);
  PayloadEstimate<X> result;
  equations.solve(x);
  constexpr const auto& tool = robot_of<S>::chain.tool.pose.position;
  const Vec3<X> at_tool{x[1], x[2], x[3]}, way{N::constant(tool[0]), N::constant(tool[1]), N::constant(tool[2])};
  result.mass = x[0], result.first_moment = at_tool + x[0] * way;
  bool sure = equations.regular();
  for (int i = 0; i < 4; ++i) {
    X unit[4] = {};
    unit[i] = X(One{});
    equations.solve(unit);
    result.variance[i] = unit[i];
    constexpr double mass = Tuning::mass_deviation, moment = Tuning::moment_deviation;
    const X most = select(i == 0, N::constant(mass * mass), N::constant(moment * moment));
    const bool positive = unit[i] > X(Zero{}), little = unit[i] <= most;
    sure = sure & positive & little;
  }
  Soundness<X> all;
  all.number(result.mass), all.number(result.first_moment.x), all.number(result.first_moment.y);
  all.number(result.first_moment.z);
  constexpr int not_ready = static_cast<int>(Status::Code::not_ready);
  result.status.code = static_cast<Status::Code>(select(sure, static_cast<int>(all.status().code), not_ready));
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
