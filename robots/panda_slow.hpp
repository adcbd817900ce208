// The Panda (panda.hpp) at the limits of RoboPrec's published comparison: +-0.5 rad/s and +-1 rad/s^2 on every joint.
// All else is the Panda's, the joint ranges too.
#pragma once

#include <robots/panda.hpp>

namespace robots {

template <int N>
constexpr axial::Chain<N> limited(axial::Chain<N> chain, double speed, double acceleration) {
  for (auto& link : chain.links)
    link.speed_limit = speed, link.acceleration_limit = acceleration;
  return chain;
}

struct PandaSlow {
  static constexpr const char* name = "panda_slow";
  static constexpr auto chain = limited(Panda::chain, 0.5, 1.0);
};

}  // namespace robots
