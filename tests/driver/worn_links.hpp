// The small arm with what an arm does in fixed point: friction that sticks, stops, a payload, play, noise, late
// encoders.
#pragma once

#include <axial/simulation/end_stops.hpp>

#include "two_links.hpp"

namespace robots {

struct WornLinks : TwoLinks {
  static constexpr auto chain = [] {
    auto all = TwoLinks::chain;
    all.payload_limit = {1.0, 0.2, 0.02, true};
    return all;
  }();
  struct Mechanics {
    static constexpr bool friction = true, payload = true;
    static constexpr axial::EndStops stops{1e5, 30.0};
    static constexpr double backlash[] = {0.0, 1e-3}, torque_noise[] = {0.2, 0.05};
    static constexpr int encoder_bits = 17, encoder_delay = 1;
  };
};

}  // namespace robots
