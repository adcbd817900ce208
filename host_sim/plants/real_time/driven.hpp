// Efforts of a robot's pick-and-place cycle, held from tick to tick.
#pragma once

#include <axial/axial.hpp>
#include <firmware/apps/plant/input.hpp>

#include <string>
#include <vector>

namespace host_sim::real_time {

/// As boards have it.
///@{
template <class R>
using Plant = axial::apps::plant::SceneOf<R>;
constexpr double tick = axial::apps::plant::tick_s;
///@}

/// The first of a planned cycle: positions, velocities, accelerations a tick.
struct Course {
  std::vector<std::vector<double>> q, qd, qdd;
};
/// Throws std::runtime_error that says what is wrong with the robot's cycle.
Course course_of(const std::string& robot, const std::vector<axial::LinkParameters>& links, int ticks);

/// What drives a robot, open loop.
template <class R>
struct Driven {
  axial::Joints<R, double> start{}, travel{};     ///< rad or m
  std::vector<axial::Joints<R, double>> efforts;  ///< N m or N, a tick
};

template <class R>
Driven<R> driven_along(const Course& course) {
  Driven<R> result;
  axial::Joints<R, double> low, high;
  for (std::size_t k = 0; k < course.q.size(); ++k) {
    axial::Joints<R, double> q, qd, qdd;
    for (int i = 0; i < R::chain.size; ++i) {
      const auto joint = static_cast<std::size_t>(i);
      q[i] = course.q[k][joint], qd[i] = course.qd[k][joint], qdd[i] = course.qdd[k][joint];
      low[i] = k == 0 || q[i] < low[i] ? q[i] : low[i], high[i] = k == 0 || q[i] > high[i] ? q[i] : high[i];
    }
    if (k == 0) result.start = q;
    result.efforts.push_back(axial::inverse_dynamics<Plant<R>>(q, qd, qdd));
  }
  for (int i = 0; i < R::chain.size; ++i)
    result.travel[i] = high[i] - low[i];
  return result;
}

/// Along the robot's pick-and-place cycle.
template <class R>
Driven<R> driven(int ticks) {
  const auto& links = R::chain.links;
  return driven_along<R>(course_of(R::name, {links, links + R::chain.size}, ticks));
}

}  // namespace host_sim::real_time
