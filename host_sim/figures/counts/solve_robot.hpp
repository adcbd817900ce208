// What solve.hpp declares, for the source of a robot.
#pragma once

#include <axial/transmissions/shared_drives.hpp>
#include <host_sim/figures/counts/float_or_double.hpp>
#include <host_sim/figures/counts/forms.hpp>
#include <host_sim/figures/counts/solve.hpp>

namespace counts {

template <class R>
axial::Joints<R, FloatOrDouble> joints(const std::vector<double>& values) {
  axial::Joints<R, FloatOrDouble> result{};
  for (int i = 0; i < axial::joint_count<R>; ++i)
    result[i] = FloatOrDouble::constant(values[static_cast<std::size_t>(i)]);
  return result;
}

template <class S>
std::vector<double> solve(const std::vector<double>& q, const std::vector<double>& qd, const std::vector<double>& tau) {
  using R = axial::robot_of<S>;
  const auto qdd = axial::forward_dynamics<S>(joints<R>(q), joints<R>(qd), joints<R>(tau));
  std::vector<double> result;
  for (const FloatOrDouble& x : qdd.values)
    result.push_back(x.value());
  return result;
}

template <class R>
std::vector<Solve> solves_of_robot() {
  std::vector<Solve> result;
  for_each_form<R>([&](auto form) { result.push_back(solve<typename decltype(form)::Scene>); });
  return result;
}

}  // namespace counts
