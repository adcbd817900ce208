// States of robots whose joints share drives, in words, inside the limits of drives and of joints.
#pragma once

#include <gtest/gtest.h>
#include <axial/fixed.hpp>
#include <cmath>
#include <cstdlib>
#include <host_sim/figures/exhaustive/fixed_search.hpp>

namespace property {

/// Word i as a number.
template <class From>
double real(const From& from, int i) {
  return from[i].raw * axial::detail::power_of_two(-from.exponent(i));
}

/// Joints as drives take them, inside their limits too: rates are scaled back, slides by the drive that moves them, and
/// with `turns` turning joints likewise.
template <class R, class State>
void hold_joints(State& state, bool turns = false) {
  using namespace axial;
  constexpr const auto& g = detail::drive_matrix<R>;
  constexpr int drives = joint_count<R>, joints = link_count<R>;
  double speed = 1.0, acceleration = 1.0;
  for (int i = 0; i < joints; ++i) {
    const auto& limit = JointCoordinates<R>::chain.links[i];
    double q = g.offset[i], qd = 0.0, qdd = 0.0;
    for (int k = 0; k < drives; ++k)
      q += g.ratio[i][k] * real(state.q, k), qd += g.ratio[i][k] * real(state.qd, k),
          qdd += g.ratio[i][k] * real(state.qdd, k);
    speed = std::fmin(speed, limit.speed_limit / std::fabs(qd));
    acceleration = std::fmin(acceleration, limit.acceleration_limit / std::fabs(qdd));
    if (limit.type == JointType::revolute && !turns) continue;
    const int k = g.mover_of(i);
    const double to = std::fmin(limit.position_max, std::fmax(limit.position_min, q));
    state.q[k].raw += static_cast<std::int32_t>((to - q) / g.ratio[i][k] * detail::power_of_two(state.q.exponent(k)));
  }
  for (int k = 0; k < drives; ++k) {
    state.qd[k].raw = static_cast<decltype(state.qd[k].raw)>(state.qd[k].raw * speed);
    state.qdd[k].raw = static_cast<decltype(state.qdd[k].raw)>(state.qdd[k].raw * acceleration);
  }
}

/// States of each robot: AXIAL_UNTUNED_STATES asks for others.
inline int states_asked(int usual) {
  const char* asked = std::getenv("AXIAL_UNTUNED_STATES");
  return asked != nullptr ? std::atoi(asked) : usual;
}
/// Sees `states` drawn states of a robot and climbs to larger shares of each part's bounds: none is exceeded, nothing
/// overflows.
template <class State, class Robot>
void search_bounds(const char* name, Robot& robot, int states, unsigned seed, unsigned climbs) {
  exhaustive::Random random(seed);
  for (int k = 0; k < states; ++k)
    robot.see(exhaustive::next_state<State>(random, static_cast<std::uint64_t>(k % 4)));
  for (int part = 0; part < robot.parts; ++part)
    exhaustive::climb<State>(climbs + static_cast<unsigned>(part), states / 5, 3 * State::size,
                             [&](const State& state) {
                               robot.see(state);
                               return robot.share[part];
                             });
  std::printf("%s:", name);
  for (int part = 0; part < robot.parts; ++part) {
    std::printf(" %s %.2f", robot.names[part], robot.nearest[part]);
    EXPECT_LE(robot.nearest[part], 1.0) << name << " " << robot.names[part];
  }
  std::printf(" of the bounds\n");
  EXPECT_EQ(robot.overflows, 0U) << name;
}

}  // namespace property
