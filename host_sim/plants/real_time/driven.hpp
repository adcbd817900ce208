// Efforts of a robot's pick-and-place cycle, held from tick to tick.
#pragma once

#include <axial/axial.hpp>
#include <axial/simulation/integrators.hpp>
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

/// A tick of a course.
template <class R>
struct Planned {
  axial::Joints<R, double> q, qd, qdd;

  Planned(const Course& course, std::size_t k) {
    for (int i = 0; i < R::chain.size; ++i) {
      const auto joint = static_cast<std::size_t>(i);
      q[i] = course.q[k][joint], qd[i] = course.qd[k][joint], qdd[i] = course.qdd[k][joint];
    }
  }
};

template <class R>
Driven<R> driven_along(const Course& course) {
  Driven<R> result;
  axial::Joints<R, double> low, high;
  for (std::size_t k = 0; k < course.q.size(); ++k) {
    const auto [q, qd, qdd] = Planned<R>(course, k);
    for (int i = 0; i < R::chain.size; ++i) {
      low[i] = k == 0 || q[i] < low[i] ? q[i] : low[i], high[i] = k == 0 || q[i] > high[i] ? q[i] : high[i];
    }
    if (k == 0) result.start = q;
    result.efforts.push_back(axial::inverse_dynamics<Plant<R>>(q, qd, qdd));
  }
  for (int i = 0; i < R::chain.size; ++i)
    result.travel[i] = high[i] - low[i];
  return result;
}

/// As driven_along, by the torques of an arm that a controller keeps on its course, from a start at rest: torques of
/// the course alone leave it, and many an arm then comes to speeds that it does not declare. Boards have what the
/// controller asked for, and no controller.
template <class R>
Driven<R> driven_near(const Course& course) {
  constexpr double stiffness = 400.0, damping = 40.0;  // 1/s^2, 1/s: critical, of 20 rad/s
  Driven<R> result = driven_along<R>(course);
  axial::Motion<Plant<R>, double> x;
  x.q = result.start;
  for (std::size_t k = 0; k < course.q.size(); ++k) {
    const auto [q, qd, qdd] = Planned<R>(course, k);
    axial::Joints<R, double> asked;
    for (int i = 0; i < R::chain.size; ++i)
      asked[i] = qdd[i] + damping * (qd[i] - x.qd[i]) + stiffness * (q[i] - x.q[i]);
    result.efforts[k] = axial::inverse_dynamics<Plant<R>>(x.q, x.qd, asked);
    (void)axial::advance<axial::RungeKutta4>(x, tick, axial::Held<Plant<R>, double>{result.efforts[k], {}});
  }
  return result;
}

/// Along the robot's pick-and-place cycle.
template <class R>
Driven<R> driven(int ticks) {
  const auto& links = R::chain.links;
  return driven_along<R>(course_of(R::name, {links, links + R::chain.size}, ticks));
}

}  // namespace host_sim::real_time
