// States inside a robot's declared limits, in words and as what they stand for.
#pragma once

#include <axial/fixed.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace property {

using namespace axial;

inline constexpr double turn = 4294967296.0, two_pi = 6.283185307179586476925;

inline double real(Fixed32 x, int exponent) { return std::ldexp(static_cast<double>(x.raw), -exponent); }
inline Fixed32 word(double x, int exponent) {
  return {static_cast<std::int32_t>(std::llround(std::ldexp(x, exponent)))};
}

/// Sets a word and the number that it stands for.
inline void put(Fixed32& fixed, double& number, double x, int exponent) {
  fixed = word(x, exponent);
  number = real(fixed, exponent);
}

/// A random state inside a robot's limits, in words and as what they stand for.
template <class R>
struct FixedState {
  static constexpr int size = joint_count<R>;
  Positions<R, Fixed32> q{};
  Velocities<R, Fixed32> qd{};
  Accelerations<R, Fixed32> qdd{};
  Joints<R, double> q_real{}, qd_real{}, qdd_real{};

  template <class Generator>
  explicit FixedState(Generator& generator) {
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int i = 0; i < size; ++i) {
      const LinkParameters& link = R::chain.links[i];
      if (link.type == JointType::revolute) {
        q[i].raw = static_cast<std::int32_t>(any(generator) * 2147483647.0);
        q_real[i] = q[i].raw * (two_pi / turn);
      } else {
        const double middle = 0.5 * (link.position_min + link.position_max);
        put(q[i], q_real[i], middle + any(generator) * (link.position_max - middle), q.exponent(i));
      }
      put(qd[i], qd_real[i], any(generator) * link.speed_limit, qd.exponent(i));
      put(qdd[i], qdd_real[i], any(generator) * link.acceleration_limit, qdd.exponent(i));
    }
  }
};

}  // namespace property
