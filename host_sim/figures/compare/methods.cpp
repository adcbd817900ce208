#include <host_sim/figures/compare/joint_errors.hpp>
#include <host_sim/figures/compare/methods.hpp>

#include <axial/axial.hpp>
#include <oracle/from_axial.hpp>
#include <oracle/lagrange.hpp>
#include <oracle/random_chain.hpp>
#include <robots/robots.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace compare {
namespace {

constexpr int states = 300;
constexpr unsigned seed = 2016;

struct NewtonEuler {
  static constexpr const char* name = "newton_euler";
  template <class R, class T, class J>
  static auto torque(const J& q, const J& qd, const J& qdd) {
    return axial::inverse_dynamics<R, T>(q, qd, qdd);
  }
};
struct Separation {
  static constexpr const char* name = "separation";
  template <class R, class T, class J>
  static auto torque(const J& q, const J& qd, const J& qdd) {
    return axial::torque(axial::separate<R, T>(q), qd, qdd);
  }
};
struct ClosedForm {
  static constexpr const char* name = "closed_form";
  template <class R, class T, class J>
  static auto torque(const J& q, const J& qd, const J& qdd) {
    return axial::closed_form::scara_torque<R, T>(q, qd, qdd);
  }
};

template <class R, class T>
axial::Joints<R, T> joints(const std::vector<double>& values) {
  axial::Joints<R, T> result{};
  for (std::size_t i = 0; i < values.size(); ++i)
    result[static_cast<int>(i)] = static_cast<T>(values[i]);
  return result;
}

struct State {
  oracle::Vector<double> q, qd, qdd;  // floats
  oracle::Vector<oracle::quad> tau;
};

template <class R>
std::vector<State> seeded_states() {
  const auto chain = oracle::of_robot<oracle::quad, R>();
  const auto exactly = [](const oracle::Vector<double>& v) { return oracle::Vector<oracle::quad>(v.begin(), v.end()); };
  oracle::RandomChains random(seed);
  std::vector<State> all(states);
  for (State& s : all) {
    for (const auto& link : R::chain.links) {
      s.q.push_back(random.uniform(link.position_min, link.position_max));
      s.qd.push_back(random.uniform(-link.speed_limit, link.speed_limit));
      s.qdd.push_back(random.uniform(-link.acceleration_limit, link.acceleration_limit));
    }
    s.tau = oracle::inverse_dynamics(chain, exactly(s.q), exactly(s.qd), exactly(s.qdd));
  }
  return all;
}

template <class R, class T, class Method>
MethodError error_of(const std::vector<State>& all, const char* scalar) {
  JointErrors errors(R::chain.size);
  for (const State& s : all) {
    const auto tau = Method::template torque<R, T>(joints<R, T>(s.q), joints<R, T>(s.qd), joints<R, T>(s.qdd));
    for (int i = 0; i < R::chain.size; ++i)
      errors.add(i, oracle::quad(tau[i]), s.tau[static_cast<std::size_t>(i)]);
  }
  return {R::name, Method::name, scalar, errors.worst(), errors.rms()};
}

template <class R, class Method>
void add_errors(std::vector<MethodError>& result, const std::vector<State>& all) {
  result.push_back(error_of<R, float, Method>(all, "float"));
  result.push_back(error_of<R, double, Method>(all, "double"));
}

template <class R>
std::vector<MethodError> errors_of_methods() {
  const auto all = seeded_states<R>();
  std::vector<MethodError> result;
  add_errors<R, NewtonEuler>(result, all);
  add_errors<R, Separation>(result, all);
  if constexpr (std::is_same_v<R, robots::Scara>) add_errors<R, ClosedForm>(result, all);
  return result;
}

// The terms are those of the set-point `ahead` of the refresh.
template <class R>
JointErrors errors_of_rate(const host_sim::Trajectory& trajectory, std::size_t ticks, std::size_t ahead) {
  JointErrors errors(R::chain.size);
  axial::Separated<R, double> terms{};
  for (std::size_t k = 0; k < trajectory.size(); ++k) {
    const auto& point = trajectory[k];
    const auto q = joints<R, double>(point.q), qd = joints<R, double>(point.qd), qdd = joints<R, double>(point.qdd);
    if (k % ticks == 0)
      terms = axial::separate<R>(joints<R, double>(trajectory[std::min(k + ahead, trajectory.size() - 1)].q));
    const auto full = axial::inverse_dynamics<R>(q, qd, qdd), held = axial::torque(terms, qd, qdd);
    for (int i = 0; i < R::chain.size; ++i)
      errors.add(i, held[i], full[i]);
  }
  return errors;
}

template <class R>
std::vector<TwoRateError> errors_of_rates(const host_sim::Trajectory& trajectory) {
  std::vector<TwoRateError> result;
  for (std::size_t ticks = 1; ticks <= 64; ticks *= 2) {
    const JointErrors now = errors_of_rate<R>(trajectory, ticks, 0);
    const JointErrors ahead = errors_of_rate<R>(trajectory, ticks, ticks / 2);
    result.push_back({R::name, static_cast<int>(ticks), now.worst(), now.rms(), ahead.worst()});
  }
  return result;
}

template <class F>
void for_each_robot(const F& f) {
  f(robots::Scara{}), f(robots::ScaraRrpr{}), f(robots::Puma560{}), f(robots::Panda{});
}
template <class Result, class F>
Result of_robot(const std::string& name, const F& f) {
  Result result;
  bool found = false;
  for_each_robot([&](auto robot) {
    if (name == decltype(robot)::name) result = f(robot), found = true;
  });
  if (!found) throw std::invalid_argument("no comparison of robot " + name);
  return result;
}

}  // namespace

std::vector<MethodError> method_errors(const std::string& robot) {
  return of_robot<std::vector<MethodError>>(robot, [](auto r) { return errors_of_methods<decltype(r)>(); });
}
std::vector<TwoRateError> two_rate_errors(const std::string& robot, const host_sim::Trajectory& trajectory) {
  return of_robot<std::vector<TwoRateError>>(robot, [&](auto r) { return errors_of_rates<decltype(r)>(trajectory); });
}
std::vector<std::string> robots() {
  std::vector<std::string> names;
  for_each_robot([&](auto robot) { names.emplace_back(decltype(robot)::name); });
  return names;
}

}  // namespace compare
