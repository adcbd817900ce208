// A robot's motions by one method over one kind of numbers, against double.
#pragma once

#include <axial/fixed.hpp>
#include <axial/fixed/simulation/integrators.hpp>
#include <host_sim/plants/real_time/driven.hpp>
#include <host_sim/plants/real_time/rows.hpp>
#include <host_sim/plants/simulation/models.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <algorithm>
#include <cmath>

namespace host_sim::real_time {

/// Joint values of numbers T from double, and back.
///@{
template <class Values, class R>
Values in_numbers(const axial::Joints<R, double>& x) {
  if constexpr (std::is_same_v<std::decay_t<decltype(Values{}[0])>, axial::Fixed32>) {
    return axial::to_fixed<Values>(x).values;
  } else {
    Values result;
    for (int i = 0; i < Values::size; ++i)
      result[i] = static_cast<std::decay_t<decltype(result[i])>>(x[i]);
    return result;
  }
}
template <class R, class X>
axial::Joints<R, double> in_double(const X& x) {
  if constexpr (std::is_same_v<std::decay_t<decltype(X{}[0])>, axial::Fixed32>) {
    return axial::to_real<double>(x);
  } else {
    axial::Joints<R, double> result;
    for (int i = 0; i < R::chain.size; ++i)
      result[i] = static_cast<double>(x[i]);
    return result;
  }
}
///@}

/// A motion X of a robot R.
template <class R, class X>
class Motions {
  using S = Plant<R>;
  using T = typename X::Scalar;

 public:
  /// Where the robot is after each tick of efforts, `steps` steps a tick. Sets `made` false where one was not made.
  template <class Method>
  static std::vector<axial::Joints<R, double>> driven(const Driven<R>& motion, int steps, bool& made) {
    X x = at(motion.start);
    std::vector<axial::Joints<R, double>> way;
    for (const auto& efforts : motion.efforts) {
      const axial::Held<S, T> held{in_numbers<axial::EffortsOf<S, T>>(efforts), {}};
      for (int k = 0; k < steps; ++k)
        (void)axial::advance<Method>(x, step(tick / steps), held);
      way.push_back(in_double<R>(x.q));
    }
    made = x.steps == motion.efforts.size() * static_cast<std::size_t>(steps);
    return way;
  }
  /// The largest change of energy in a swing from `start`, J; looked at every tenth of a second.
  template <class Method>
  static double energy_drift(const axial::Joints<R, double>& start, double seconds, bool& made) {
    X x = at(start);
    const double first = energy(x);
    double drift = 0.0;
    const long steps = std::lround(seconds / tick);
    for (long k = 1; k <= steps; ++k) {
      (void)axial::advance<Method>(x, step(tick), axial::Held<S, T>{});  // it hangs beyond its joints' ranges
      if (k % 100 == 0) host_sim::note_size(drift, energy(x) - first);
    }
    made = x.steps == static_cast<std::uint64_t>(steps);
    return drift;
  }
  /// J, of a motion.
  static double energy(const X& x) {
    static const simulation::Model model = simulation::robot_model(R::name);
    const auto own_q = in_double<R>(x.q), own_qd = in_double<R>(x.qd);
    simulation::Values<double> q{}, qd{};
    for (int i = 0; i < R::chain.size; ++i)
      q[i] = own_q[i], qd[i] = own_qd[i];
    return simulation::energy(model, q, qd);
  }
  static X at(const axial::Joints<R, double>& q) {
    X x;
    x.q = in_numbers<axial::Positions<R, T>>(q);
    if constexpr (std::is_same_v<T, axial::Fixed32>)
      for (int i = 0; i < R::chain.size; ++i)  // an arm may hang beyond its joints' ranges
        if (R::chain.links[i].type == axial::JointType::revolute) x.q[i].raw = axial::detail::to_angle(q[i]);
    return x;
  }

 private:
  static auto step(double seconds) {
    if constexpr (std::is_same_v<T, axial::Fixed32>)
      return axial::FixedStep(seconds);
    else
      return static_cast<T>(seconds);
  }
};

template <class R>
using InDouble = Motions<R, axial::Motion<Plant<R>, double>>;

/// What a driven motion makes of a small error at its start, of any joint, over travel: rounding grows as much. A
/// property of the motion, no method's and no number system's.
template <class R>
double growth_of(const Driven<R>& motion) {
  constexpr double small = 1e-9;  // of travel
  bool made = true;
  const auto end = InDouble<R>::template driven<axial::RungeKutta4>(motion, 1, made).back();
  double most = 0.0;
  for (int j = 0; j < R::chain.size; ++j) {
    Driven<R> other = motion;
    other.start[j] += small * motion.travel[j];
    const auto off = InDouble<R>::template driven<axial::RungeKutta4>(other, 1, made).back();
    for (int i = 0; i < R::chain.size; ++i)
      host_sim::note_size(most, (off[i] - end[i]) / (small * motion.travel[i]));
  }
  return most;
}

inline std::string name_of(axial::RungeKutta4) { return "runge_kutta_4"; }
inline std::string name_of(axial::SemiImplicitEuler) { return "semi_implicit"; }

/// The second of a cycle.
template <class R>
struct DrivenSecond {
  Driven<R> motion = driven<R>(1000);
  std::vector<axial::Joints<R, double>> reference = [this] {  ///< after each tick
    bool made = true;
    return InDouble<R>::template driven<axial::RungeKutta4>(motion, 10, made);
  }();

  template <class X, class Method>
  Row row(const std::string& scalar, int steps, double gate) const {
    Row row{R::name, scalar, name_of(Method{}), "pick-and-place, 1 s", tick / steps};
    const auto way = Motions<R, X>::template driven<Method>(motion, steps, row.made);
    for (int i = 0; i < R::chain.size; ++i)
      host_sim::note_size(row.error, (way.back()[i] - reference.back()[i]) / motion.travel[i]);
    row.gate = gate;
    return row;
  }
  /// Every number by a method; gates of float with compensated sums, and of words.
  template <class Method>
  void add(std::vector<Row>& rows, int steps, double float_gate, double fixed_gate) const {
    using S = Plant<R>;
    const double none = std::numeric_limits<double>::infinity();
    rows.push_back(row<axial::Motion<S, double>, Method>("double", steps, none));
    rows.push_back(row<axial::Motion<S, float>, Method>("float", steps, none));
    rows.push_back(row<axial::CompensatedMotion<S, float>, Method>("float, compensated", steps, float_gate));
    rows.push_back(row<axial::Motion<S, axial::Fixed32>, Method>("fixed32", steps, fixed_gate));
  }
};

/// Where an arm hangs: where a motion with dampers ends.
template <class R>
axial::Joints<R, double> hanging(axial::Joints<R, double> q) {
  auto x = InDouble<R>::at(q);
  const auto damped = [](const auto& at, auto& tau, auto&) {
    for (int i = 0; i < R::chain.size; ++i)
      tau[i] = -10.0 * at.qd[i];
  };
  for (int k = 0; k < 60'000; ++k)
    (void)axial::advance<axial::RungeKutta4>(x, 1e-3, damped);
  return x.q;
}

/// A minute's free swing from `start`, about where the arm hangs: from there by 0.15 rad, joints one against the next.
template <class R>
struct FreeMinute {
  axial::Joints<R, double> rest, start = [this] {
    auto q = rest;
    for (int i = 0; i < R::chain.size; ++i)
      q[i] += i % 2 == 0 ? 0.15 : -0.15;
    return q;
  }();
  double swings = InDouble<R>::energy(InDouble<R>::at(start)) - InDouble<R>::energy(InDouble<R>::at(rest));  ///< J

  template <class X>
  Row row(const std::string& scalar, double gate) const {
    Row row{R::name, scalar, name_of(axial::RungeKutta4{}), "free swing, 60 s", tick};
    row.energy_drift = Motions<R, X>::template energy_drift<axial::RungeKutta4>(start, 60.0, row.made) / swings;
    row.gate = gate;
    return row;
  }
  void add(std::vector<Row>& rows, double gate) const {
    using S = Plant<R>;
    rows.push_back(row<axial::Motion<S, double>>("double", gate));
    rows.push_back(row<axial::Motion<S, float>>("float", std::numeric_limits<double>::infinity()));
    rows.push_back(row<axial::CompensatedMotion<S, float>>("float, compensated", gate));
    rows.push_back(row<axial::Motion<S, axial::Fixed32>>("fixed32", gate));
  }
};

}  // namespace host_sim::real_time
