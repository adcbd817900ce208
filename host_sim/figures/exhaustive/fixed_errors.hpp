// Errors of fixed point and of float on the same states, each against double at its own inputs; and what is certified.
#pragma once

#include <host_sim/figures/exhaustive/fixed_kernels.hpp>
#include <host_sim/figures/exhaustive/fixed_search.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <array>
#include <cmath>

namespace exhaustive {

/// Worst of one joint over a set of states, in N m, N, rad/s^2 or m/s^2.
struct JointError {
  double fixed = 0.0, in_float = 0.0, largest = 0.0;
};
template <class R>
using JointErrors = std::array<JointError, R::chain.size>;

/// The same kernel in floating point.
template <class S, class T>
struct FloatingState {
  axial::Joints<axial::robot_of<S>, T> q, qd, qdd, tau;
};
template <class S, class T, class From>
FloatingState<S, T> converted(const From& from) {
  FloatingState<S, T> to{};
  for (int i = 0; i < axial::robot_of<S>::chain.size; ++i) {
    to.q[i] = static_cast<T>(from.q[i]), to.qd[i] = static_cast<T>(from.qd[i]);
    to.qdd[i] = static_cast<T>(from.qdd[i]), to.tau[i] = static_cast<T>(from.tau[i]);
  }
  return to;
}
template <class S, class T>
FloatingState<S, double> exact_state(const FixedState<S, T>& s) {
  using R = axial::robot_of<S>;
  return {in_double<R, T>(s.q), in_double<R>(s.qd), in_double<R>(s.qdd), in_double<R>(s.tau)};
}
template <class S, class T>
auto floating(const InverseDynamics<S, axial::Fixed32>&, const FloatingState<S, T>& s) {
  return axial::inverse_dynamics<S>(s.q, s.qd, s.qdd);
}
template <class S, class T>
auto floating(const InverseDynamics<S, axial::Fixed16>&, const FloatingState<S, T>& s) {
  return axial::inverse_dynamics<S>(s.q, s.qd, s.qdd);
}
template <class S, class T>
auto floating(const ClosedForm<S, axial::Fixed32>&, const FloatingState<S, T>& s) {
  return axial::closed_form::scara_torque<S>(s.q, s.qd, s.qdd);
}
template <class S, class T>
auto floating(const ForwardDynamics<S, axial::Fixed32>&, const FloatingState<S, T>& s) {
  return axial::forward_dynamics<S>(s.q, s.qd, s.tau);
}

/// Error of one result, joint by joint.
template <class Kernel, class S, class T>
std::array<double, axial::robot_of<S>::chain.size> error_at(const FixedState<S, T>& state,
                                                            JointErrors<axial::robot_of<S>>* all) {
  constexpr int size = axial::robot_of<S>::chain.size;
  const auto exact = exact_state(state);
  const auto reference = floating(Kernel{}, exact);
  const auto result = Kernel::run(state);
  std::array<double, size> error{};
  for (int i = 0; i < size; ++i) {
    error[static_cast<std::size_t>(i)] =
        std::fabs(result[i].raw * axial::detail::power_of_two(-result.exponent(i)) - reference[i]);
    if (all != nullptr) {
      JointError& joint = (*all)[static_cast<std::size_t>(i)];
      host_sim::note_size(joint.fixed, error[static_cast<std::size_t>(i)]);
      host_sim::note_size(joint.largest, reference[i]);
    }
  }
  return error;
}

/// Over `states` states inside the limits, efforts among them.
template <template <class, class> class Kernel, class S, class T>
JointErrors<axial::robot_of<S>> errors(std::uint64_t states, std::uint64_t seed) {
  using R = axial::robot_of<S>;
  Random random(seed);
  JointErrors<R> all{};
  for (std::uint64_t k = 0; k < states; ++k) {
    auto state = next_state<FixedState<S, T>>(random, 0);
    error_at<Kernel<S, T>>(state, &all);
    const auto rounded = converted<S, float>(exact_state(state));
    const auto reference = floating(Kernel<S, T>{}, converted<S, double>(rounded));
    const auto result = floating(Kernel<S, T>{}, rounded);
    for (int i = 0; i < R::chain.size; ++i) {
      JointError& joint = all[static_cast<std::size_t>(i)];
      host_sim::note_size(joint.in_float, static_cast<double>(result[i]) - reference[i]);
    }
  }
  return all;
}

/// How many times better than float: the worst joints of each compared, relative to the joint's largest value.
template <class All>
double gain_over_float(const All& all) {
  double fixed = 0.0, in_float = 0.0;
  for (const JointError& joint : all) {
    if (joint.largest <= 0.0) continue;
    host_sim::note_size(fixed, joint.fixed / joint.largest);
    host_sim::note_size(in_float, joint.in_float / joint.largest);
  }
  return in_float / fixed;
}

/// The certified error of inverse dynamics of joint i.
template <class S, class T>
double certified(int i) {
  using Scene = axial::scene_of<S>;
  using Arithmetic = axial::detail::ArithmeticOf<Scene, typename T::Word>;
  constexpr const auto& ranges =
      axial::detail::ranges_of<Scene, axial::detail::with_rotors<Scene, axial::BaseParameters>, Arithmetic,
                               axial::recursion::NewtonEuler>;
  return ranges.range[i].joint_effort.error;
}

/// The largest error over certified error that a search finds.
template <class S, class T>
double adversary(int joint, int steps, std::uint64_t seed) {
  const double bound = certified<S, T>(joint);
  return climb<FixedState<S, T>>(seed, steps, 3 * FixedState<S, T>::size, [&](const FixedState<S, T>& state) {
    return error_at<InverseDynamics<S, T>, S, T>(state, nullptr)[static_cast<std::size_t>(joint)] / bound;
  });
}

}  // namespace exhaustive
