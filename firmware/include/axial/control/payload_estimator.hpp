// Mass and first moment of a payload from the residuals of an observer that does not know of it: recursive least
// squares.
#pragma once

#include <axial/control/momentum_observer.hpp>
#include <axial/control/payload_columns.hpp>

namespace axial {

// A tuning is the observer's type with also, `static constexpr double`
//   deviation          of a residual, as a share of the joint's declared effort limit: sensors and model together
//   memory             s, after which a sample counts 1/e
//   mass_deviation     kg, moment_deviation kg m: with larger ones an estimate is not ready

/// Memory of an estimator, owned by the caller; start with `{}`, and again when the payload changes.
template <class S, class T>
struct PayloadState {
  detail::PayloadColumns<S, T> last{};                ///< columns of the previous sample
  detail::PayloadRow<T> lagged[joint_count<S>] = {};  ///< columns behind the observer's lag
  T information[4][4] = {}, moment[4] = {};           ///< of the normal equations: lower triangle, right-hand side
  bool ready = false;                                 ///< whether `last` is the previous sample's
};

/// What is known of a payload.
template <class T>
struct PayloadEstimate {
  T mass{};                ///< kg
  Vec3<T> first_moment{};  ///< kg m, about the last link's origin in its axes
  T variance[4] = {};      ///< of mass (kg^2), first moment about the tool point (kg^2 m^2), with the tuning's noise
  Status status{};         ///< not_ready: what was seen does not tell the payload's parameters apart well enough

  /// As the scene's Payload takes it: a body of no extent. Without a mass beyond 0 there is none.
  constexpr PayloadBody<T> body() const {
    const bool some = mass > T(Zero{});
    const T kg = select(some, mass, T(One{})), zero(Zero{});
    const T per_kg = select(some, reciprocal(kg), zero);
    return {select(some, mass, zero), per_kg * first_moment, {}};
  }
};

namespace detail {

// L D L^T of a symmetric 4x4 and the solution of its equations; pivots too small for the type are reported.
template <class T>
class Equations {
 public:
  constexpr explicit Equations(const T (&a)[4][4]) {
    const T smallest = NumberTraits<T>::constant(16.0) * std::numeric_limits<T>::epsilon();
    for (int j = 0; j < 4; ++j) {
      T d = a[j][j];
      for (int k = 0; k < j; ++k)
        d -= l_[j][k] * l_[j][k] * d_[k];
      const bool good = d > smallest * a[j][j];
      regular_ = regular_ & good;
      d_[j] = d, inverse_[j] = select(good, reciprocal(select(good, d, T(One{}))), T(Zero{}));
      for (int i = j + 1; i < 4; ++i) {
        T x = a[i][j];
        for (int k = 0; k < j; ++k)
          x -= l_[i][k] * l_[j][k] * d_[k];
        l_[i][j] = x * inverse_[j];
      }
    }
  }
  constexpr bool regular() const { return regular_; }
  constexpr void solve(T (&x)[4]) const {
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < i; ++k)
        x[i] -= l_[i][k] * x[k];
    for (int i = 4; i-- > 0;) {
      x[i] *= inverse_[i];
      for (int k = i + 1; k < 4; ++k)
        x[i] -= l_[k][i] * x[k];
    }
  }

 private:
  T l_[4][4] = {}, d_[4] = {}, inverse_[4] = {};
  bool regular_ = true;
};

// Information of one residual: 1 / deviation^2, and less for samples that the lag makes alike.
template <class S, class Tuning>
constexpr double sample_weight(int joint) {
  const double most = robot_of<S>::chain.links[joint].effort_limit;
  const double deviation = Tuning::deviation * (is_bounded(most) ? most : 1.0), share = residual_share<Tuning>();
  return share / ((2.0 - share) * deviation * deviation);
}
template <class S, class T, class Tuning>
struct SampleWeights {
  T of[joint_count<S>] = {};
  static constexpr SampleWeights chosen() {
    SampleWeights all;
    for (int i = 0; i < joint_count<S>; ++i)
      all.of[i] = NumberTraits<T>::constant(sample_weight<S, Tuning>(i));
    return all;
  }
};
template <class S, class T, class Tuning>
inline constexpr auto sample_weights = SampleWeights<S, T, Tuning>::chosen();

template <class T>
constexpr void add_row(T (&information)[4][4], T (&moment)[4], const PayloadRow<T>& y, const T& weight, const T& r) {
  for (int i = 0; i < 4; ++i) {
    const T scaled = weight * y.of[i];
    moment[i] += scaled * r;
    for (int j = 0; j <= i; ++j)
      information[i][j] += scaled * y.of[j];
  }
}

}  // namespace detail

/// One sample: brings the payload's columns behind the observer's own lag and adds them and the residual to the normal
/// equations, weighted by the joints' deviations, older samples forgotten. A payload that the observer does not know
/// pushes back: residual = -(d(columns momentum)/dt - columns drift) (mass, first moment), so that no acceleration is
/// needed. Give it the residual that observe() left for the same q and qd; call it for good samples only, and set
/// `ready` to false after a gap. An external contact is taken for payload: leave samples of collisions out.
/// The payload's inertia about the tool point is left out. In float or double; of a fixed-point observer give the
/// residual as numbers. The first sample only starts it. Constant time, 4x4 whatever the robot.
template <class S, class T, class Tuning>
constexpr void weigh(PayloadState<S, T>& state, const Positions<robot_of<S>, T>& q,
                     const Velocities<robot_of<S>, T>& qd, const Joints<robot_of<S>, T>& residual) {
  static_assert(!is_stored_v<T>, "axial: the payload estimator takes float or double");
  static_assert(Tuning::deviation > 0.0 && Tuning::memory > 0.0, "axial: deviation and memory are positive");
  using N = NumberTraits<T>;
  constexpr T rate = N::constant(1.0 / Tuning::period), half = N::constant(0.5);
  constexpr T share = N::constant(detail::residual_share<Tuning>());
  constexpr T kept = N::constant(Tuning::memory / (Tuning::memory + Tuning::period));
  const auto now = detail::payload_columns<S, T>(q, qd);
  const T used = select(state.ready, T(One{}), T(Zero{}));
  for (auto& row : state.information)
    for (T& x : row)
      x *= kept;
  for (T& x : state.moment)
    x *= kept;
  for (int i = 0; i < joint_count<S>; ++i) {
    auto& lagged = state.lagged[i];
    for (int k = 0; k < 4; ++k) {
      const T e = rate * (state.last.momentum[i].of[k] - now.momentum[i].of[k]) +
                  half * (now.drift[i].of[k] + state.last.drift[i].of[k]);
      lagged.of[k] += used * share * (e - lagged.of[k]);
    }
    detail::add_row(state.information, state.moment, lagged, used * detail::sample_weights<S, T, Tuning>.of[i],
                    residual[i]);
  }
  state.last = now, state.ready = true;
}

/// Least-squares estimate of the payload from what was weighed, and how sure it is. Constant time: one L D L^T of 4x4.
template <class Tuning, class S, class T>
constexpr PayloadEstimate<T> estimate(const PayloadState<S, T>& state) {
  const detail::Equations<T> equations(state.information);
  PayloadEstimate<T> result;
  T x[4] = {state.moment[0], state.moment[1], state.moment[2], state.moment[3]};
  equations.solve(x);
  constexpr const auto& tool = robot_of<S>::chain.tool.pose.position;
  using N = NumberTraits<T>;
  const Vec3<T> at_tool{x[1], x[2], x[3]}, way{N::constant(tool[0]), N::constant(tool[1]), N::constant(tool[2])};
  result.mass = x[0], result.first_moment = at_tool + x[0] * way;
  bool sure = equations.regular();
  for (int i = 0; i < 4; ++i) {
    T unit[4] = {};
    unit[i] = T(One{});
    equations.solve(unit);
    result.variance[i] = unit[i];
    constexpr double mass = Tuning::mass_deviation, moment = Tuning::moment_deviation;
    const T most = NumberTraits<T>::constant(i == 0 ? mass * mass : moment * moment);
    sure = sure & (unit[i] > T(Zero{})) & (unit[i] <= most);
  }
  result.status.code = sure ? Status::Code::ok : Status::Code::not_ready;
  return result;
}

}  // namespace axial
