// What a kernel computes.
#pragma once

#include <firmware/apps/size/algorithms.hpp>

namespace errors {

enum class Job {
  torque,
  gravity,
  bias,
  mass_matrix,
  acceleration,
  pose,
  jacobian,
  torque_derivatives,
  acceleration_derivatives,
  motors
};

constexpr bool is_derivatives(Job job) {
  return job == Job::torque_derivatives || job == Job::acceleration_derivatives;
}
/// Whether results are vectors and matrices of several kinds.
constexpr bool has_blocks(Job job) { return is_derivatives(job) || job == Job::motors; }

/// The name by which errors are scaled (host_sim::error_scales).
constexpr const char* scaled_as(Job job) {
  return job == Job::mass_matrix                ? "mass_matrix"
         : job == Job::pose                     ? "forward_kinematics"
         : job == Job::jacobian                 ? "jacobian"
         : job == Job::torque_derivatives       ? "inverse_dynamics_derivatives"
         : job == Job::acceleration_derivatives ? "forward_dynamics_derivatives"
         : job == Job::motors                   ? "elastic_feedforward"
                                                : "joints";
}

namespace algorithms = axial::apps::size::algorithms;

template <class Algorithm>
inline constexpr Job job_of = Job::torque;
template <>
inline constexpr Job job_of<algorithms::gravity> = Job::gravity;
template <>
inline constexpr Job job_of<algorithms::bias> = Job::bias;
template <>
inline constexpr Job job_of<algorithms::mass_matrix> = Job::mass_matrix;
template <>
inline constexpr Job job_of<algorithms::forward_dynamics> = Job::acceleration;
template <class Route>
inline constexpr Job job_of<algorithms::forward_dynamics_by<Route>> = Job::acceleration;
template <>
inline constexpr Job job_of<algorithms::forward_kinematics> = Job::pose;
template <>
inline constexpr Job job_of<algorithms::jacobian> = Job::jacobian;
template <>
inline constexpr Job job_of<algorithms::inverse_dynamics_derivatives> = Job::torque_derivatives;
template <>
inline constexpr Job job_of<algorithms::forward_dynamics_derivatives> = Job::acceleration_derivatives;

template <>
inline constexpr Job job_of<algorithms::elastic_feedforward> = Job::motors;

/// The scene that a kernel runs: some algorithms name a route.
template <class Algorithm, class S>
struct SceneOfKernel {
  using type = S;
};
template <class Route, class S>
struct SceneOfKernel<algorithms::forward_dynamics_by<Route>, S> {
  using type = typename axial::apps::size::Tagged<S, Route>::type;
};

}  // namespace errors
