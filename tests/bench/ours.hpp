// The library as a contender. Included only by translation units that are compiled for this machine.
#pragma once

#include <axial/axial.hpp>
#include <bench/contender.hpp>
#include <type_traits>

namespace bench {

template <Algorithm A>
using Choice = std::integral_constant<Algorithm, A>;

// One call, not inlined into the loop over the states: a control loop makes one call, too. The last argument is an
// acceleration or, for forward dynamics, an effort.
template <class S>
struct OfRobot {
  template <class V>
  [[gnu::noinline]] static V call(Choice<Algorithm::inverse_dynamics>, const V& q, const V& qd, const V& x) {
    return axial::inverse_dynamics<S>(q, qd, x);
  }
  template <class V>
  [[gnu::noinline]] static V call(Choice<Algorithm::gravity>, const V& q, const V&, const V&) {
    return axial::gravity_torque<S>(q);
  }
  template <class V>
  [[gnu::noinline]] static V call(Choice<Algorithm::bias>, const V& q, const V& qd, const V&) {
    return axial::bias_torque<S>(q, qd);
  }
  template <class V>
  [[gnu::noinline]] static auto call(Choice<Algorithm::mass_matrix>, const V& q, const V&, const V&) {
    return axial::mass_matrix<S>(q);
  }
  template <class V>
  [[gnu::noinline]] static auto call(Choice<Algorithm::forward_dynamics>, const V& q, const V& qd, const V& x) {
    return axial::forward_dynamics<S>(q, qd, x);
  }
  template <class V>
  [[gnu::noinline]] static auto call(Choice<Algorithm::inverse_dynamics_derivatives>, const V& q, const V& qd,
                                     const V& x) {
    return axial::inverse_dynamics_derivatives<S>(q, qd, x);
  }
  template <class V>
  [[gnu::noinline]] static auto call(Choice<Algorithm::forward_dynamics_derivatives>, const V& q, const V& qd,
                                     const V& x) {
    return axial::forward_dynamics_derivatives<S>(q, qd, x);
  }
};

/// Caller: a static or dynamic object with call(Choice<A>, q, qd, x).
template <class S, class T, Algorithm A, class Caller>
class Ours : public Contender {
  using Values = axial::Joints<axial::robot_of<S>, T>;
  using Result = decltype(std::declval<const Caller&>().call(Choice<A>{}, Values{}, Values{}, Values{}));
  struct State {
    Values q, qd, x;
  };

 public:
  explicit Ours(const States& states, Caller caller = {})
      : caller_(static_cast<Caller&&>(caller)), results_(std::size_t(states.count)) {
    for (int k = 0; k < states.count; ++k)
      states_.push_back({values(states, states.q, k), values(states, states.qd, k),
                         values(states, is_forward(A) ? states.tau : states.qdd, k)});
  }

  void run(int first, int count) override {
    const auto begin = static_cast<std::size_t>(first), end = begin + static_cast<std::size_t>(count);
    for (std::size_t k = begin; k < end; ++k)
      results_[k] = caller_.call(Choice<A>{}, states_[k].q, states_[k].qd, states_[k].x);
  }
  std::vector<double> result(int state) override {
    const State& s = states_[std::size_t(state)];
    return flat(caller_.call(Choice<A>{}, s.q, s.qd, s.x));
  }

 private:
  static Values values(const States& states, const std::vector<double>& all, int state) {
    Values result{};
    for (int i = 0; i < states.joints; ++i)
      result[i] = static_cast<T>(all[std::size_t(state * states.joints + i)]);
    return result;
  }
  static std::vector<double> flat(const Result& result) {
    std::vector<double> list;
    for (int i = 0; i < Values::size; ++i)
      if constexpr (A == Algorithm::mass_matrix)
        for (int j = 0; j < Values::size; ++j)
          list.push_back(static_cast<double>(result(i, j)));
      else
        list.push_back(static_cast<double>(values(result)[i]));
    return list;
  }
  static const auto& values(const Result& result) {
    if constexpr (A == Algorithm::inverse_dynamics_derivatives)
      return result.tau;
    else if constexpr (A == Algorithm::forward_dynamics_derivatives)
      return result.qdd;
    else
      return result;
  }

  Caller caller_;
  std::vector<State> states_;
  std::vector<Result> results_;
};

template <class S, class Feature>
struct Named;
template <class Robot, class... Features, class Feature>
struct Named<axial::Scene<Robot, Features...>, Feature> {
  using type = axial::Scene<Robot, Features..., Feature>;
};

/// Forward dynamics by the route that a feature names.
template <class S, class Route, class T>
std::unique_ptr<Contender> make_route(const States& states) {
  using Scene = typename Named<S, Route>::type;
  return std::make_unique<Ours<Scene, T, Algorithm::forward_dynamics, OfRobot<Scene>>>(states);
}

/// All results of either.
template <class S, class T>
std::unique_ptr<Contender> make_derivatives(Algorithm algorithm, const States& states) {
  if (is_forward(algorithm))
    return std::make_unique<Ours<S, T, Algorithm::forward_dynamics_derivatives, OfRobot<S>>>(states);
  return std::make_unique<Ours<S, T, Algorithm::inverse_dynamics_derivatives, OfRobot<S>>>(states);
}

/// S is a scene.
template <class S, class T>
std::unique_ptr<Contender> make_ours(Algorithm algorithm, const States& states) {
  switch (algorithm) {
    case Algorithm::inverse_dynamics:
      return std::make_unique<Ours<S, T, Algorithm::inverse_dynamics, OfRobot<S>>>(states);
    case Algorithm::gravity:
      return std::make_unique<Ours<S, T, Algorithm::gravity, OfRobot<S>>>(states);
    case Algorithm::bias:
      return std::make_unique<Ours<S, T, Algorithm::bias, OfRobot<S>>>(states);
    case Algorithm::mass_matrix:
      return std::make_unique<Ours<S, T, Algorithm::mass_matrix, OfRobot<S>>>(states);
    case Algorithm::articulated_body:
      return make_route<S, axial::ArticulatedBody, T>(states);
    case Algorithm::split_articulated_body:
      return make_route<S, axial::SplitArticulatedBody, T>(states);
    case Algorithm::composite_body:
      return make_route<S, axial::CompositeBody, T>(states);
    default:
      return std::make_unique<Ours<S, T, Algorithm::forward_dynamics, OfRobot<S>>>(states);
  }
}

}  // namespace bench
