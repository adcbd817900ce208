// The Panda (panda.hpp) at the limits of RoboPrec's published comparison: +-0.5 rad/s and +-1 rad/s^2 on every joint.
// All else is the Panda's, the joint ranges too.
#pragma once

#include <robots/panda.hpp>

namespace robots {

/// A chain with other limits of speed (rad/s, m/s) and acceleration (rad/s^2, m/s^2), the same for all joints.
template <int N>
constexpr axial::Chain<N> limited(axial::Chain<N> chain, double speed, double acceleration) {
  for (auto& link : chain.links)
    link.speed_limit = speed, link.acceleration_limit = acceleration;
  return chain;
}

/// The Panda at +-0.5 rad/s and +-1 rad/s^2.
struct PandaSlow {
  static constexpr const char* name = "panda_slow";               ///< on the command line, in files and in JSON
  static constexpr auto chain = limited(Panda::chain, 0.5, 1.0);  ///< panda::chain but for the limits
};

}  // namespace robots
