// The errors of one robot: the kernels' own source in each number system against quadruple precision.
#pragma once

#include <axial/axial.hpp>
#include <axial/error_bound.hpp>
#include <firmware/apps/number_systems.hpp>
#include <firmware/apps/states.hpp>
#include <host_sim/numbers/errors.hpp>
#include <oracle/from_axial.hpp>
#include <oracle/recursive.hpp>
#include <robots/scara.hpp>

#include <algorithm>
#include <cmath>

namespace numbers {

using oracle::quad;
using Vector = oracle::Vector<quad>;

/// What is compared: a torque, and what it is called where its error is certified.
struct InverseDynamics {
  static constexpr const char* name = "inverse_dynamics";
  template <class S, class T, class Q, class V, class A>
  static auto torque(const Q& q, const V& qd, const A& qdd) {
    return axial::inverse_dynamics<S, T>(q, qd, qdd);
  }
  static constexpr auto certified = axial::algorithm::inverse_dynamics;
};
struct ClosedForm {
  static constexpr const char* name = "closed_form";
  template <class S, class T, class Q, class V, class A>
  static auto torque(const Q& q, const V& qd, const A& qdd) {
    return axial::closed_form::scara_torque<S, T>(q, qd, qdd);
  }
  static constexpr auto certified = axial::algorithm::closed_form;
};

/// A joint value of any number system as it is: an integer times a power of two, or an angle, or a number.
template <class Values>
quad exact(const Values& values, int i) {
  using Value = std::decay_t<decltype(values[i])>;
  if constexpr (axial::is_stored_v<Value>)
    return quad(values[i].raw) * quad(std::ldexp(1.0, -Values::exponent(i)));
  else
    return quad(values[i]);
}
template <class Robot, class Values>
quad exact_position(const Values& values, int i) {
  using Value = std::decay_t<decltype(values[i])>;
  if constexpr (axial::is_stored_v<Value>)
    if (Robot::chain.links[i].type == axial::JointType::revolute)
      return quad(values[i].raw) * oracle::right_angle<quad>() / quad(0x1p30);
  return exact(values, i);
}

/// Largest torque and error of every joint, as they come.
template <int N>
class Errors {
 public:
  void add(int i, quad exact, quad difference) {
    const double error = static_cast<double>(difference);
    largest_[i] = std::max(largest_[i], std::fabs(static_cast<double>(exact)));
    worst_[i] = std::max(worst_[i], std::fabs(error));
    squares_[i] += error * error;
  }
  /// The largest over the joints.
  double worst() const { return over_joints(worst_); }
  double relative(const double (&bounds)[N]) const { return over_joints(bounds); }
  double rms(int states) const {
    double sum = 0.0;
    for (int i = 0; i < N; ++i)
      sum += squares_[i] / (largest_[i] * largest_[i]);
    return std::sqrt(sum / (N * states));
  }

 private:
  double over_joints(const double (&values)[N]) const {
    double result = 0.0;
    for (int i = 0; i < N; ++i)
      result = std::max(result, values[i] / largest_[i]);
    return result;
  }
  double largest_[N] = {}, worst_[N] = {}, squares_[N] = {};
};

/// Robot R. Speeds, accelerations and slides are drawn from what 16 bits hold, so every system is given the same ones;
/// an angle is a float, in fixed point the nearest 32-bit angle, and the reference turns by the angle that was given.
template <class R>
class RobotErrors {
 public:
  RobotErrors() {
    axial::apps::Random random(seed);
    for (State& state : states_)
      state = drawn(random);
    fill<float>(&State::torque_of_floats);
    fill<axial::Fixed32>(&State::torque_of_integers);
  }
  std::vector<Row> rows() const {
    std::vector<Row> result;
    add_systems<InverseDynamics>(result);
    if constexpr (std::is_same_v<R, ::robots::Scara>) add_systems<ClosedForm>(result);
    return result;
  }

 private:
  static constexpr int joints = R::chain.size, count = 5000;
  static constexpr std::uint32_t seed = 0x20160401;
  struct State {
    axial::apps::MotionState<R, float> motion;
    Vector torque_of_floats, torque_of_integers;
  };
  std::vector<State> states_ = std::vector<State>(count);
  oracle::Chain<quad> chain_ = oracle::of_robot<quad, R>();

  static State drawn(axial::apps::Random& random) {
    using namespace axial;
    State state{};
    auto& m = state.motion = apps::next_state<R, float>(random);
    const auto qd = apps::nearest<Velocities<R, Fixed16>>(m.qd);
    const auto qdd = apps::nearest<Accelerations<R, Fixed16>>(m.qdd);
    auto slides = apps::nearest_positions<R, Fixed32>(m.q);
    for (int i = 0; i < joints; ++i) {
      m.qd[i] = static_cast<float>(exact(qd, i)), m.qdd[i] = static_cast<float>(exact(qdd, i));
      slides[i].raw &= ~0xffff;
      if (R::chain.links[i].type == JointType::prismatic) m.q[i] = static_cast<float>(exact(slides, i));
    }
    return state;
  }
  // The torque that numbers T should give.
  template <class T>
  void fill(Vector State::*torque) {
    for (State& state : states_) {
      const auto given = axial::apps::nearest_positions<R, T>(state.motion.q);
      Vector q, qd, qdd;
      for (int i = 0; i < joints; ++i) {
        q.push_back(exact_position<R>(given, i));
        qd.push_back(exact(state.motion.qd, i)), qdd.push_back(exact(state.motion.qdd, i));
      }
      state.*torque = oracle::recursive_inverse_dynamics(chain_, q, qd, qdd);
    }
  }

  template <class Algorithm>
  void add_systems(std::vector<Row>& result) const {
    using namespace axial::apps::number_systems;
    add<Algorithm, as_fixed16>("fixed16", result);
    add<Algorithm, as_fixed32_down>("fixed32_down", result);
    add<Algorithm, as_fixed32>("fixed32", result);
    add<Algorithm, as_fixed32_high>("fixed32_high", result);
    add<Algorithm, as_float>("float", result);
    add<Algorithm, as_double>("double", result);
  }

  template <class Robot, class... Tags>
  using Bare = axial::Scene<Robot, axial::Gravity, axial::RotorInertia, Tags...>;

  template <class Algorithm, class System>
  void add(const char* scalar, std::vector<Row>& result) const {
    using Scene = typename System::template scene<Bare, R>;
    using T = typename System::Number;
    using namespace axial::apps;
    Errors<joints> errors;
    for (const State& state : states_) {
      const auto tau = Algorithm::template torque<Scene, T>(nearest_positions<R, T>(state.motion.q),
                                                            nearest<axial::Velocities<R, T>>(state.motion.qd),
                                                            nearest<axial::Accelerations<R, T>>(state.motion.qdd));
      const Vector& wanted = axial::is_stored_v<T> ? state.torque_of_integers : state.torque_of_floats;
      for (int i = 0; i < joints; ++i)
        errors.add(i, wanted[static_cast<std::size_t>(i)], exact(tau, i) - wanted[static_cast<std::size_t>(i)]);
    }
    result.push_back({R::name, Algorithm::name, scalar, count, errors.worst(), errors.rms(count),
                      certified<Algorithm, Scene, T>(errors)});
  }

  template <class Algorithm, class Scene, class T>
  static std::optional<double> certified(const Errors<joints>& errors) {
    if constexpr (axial::is_stored_v<T>) {
      return errors.relative(axial::error_bound<Scene, T>(Algorithm::certified).of);
    } else {
      return {};
    }
  }
};

}  // namespace numbers
