// The small arm behind springs, with what else an arm does in float: friction, stops, a payload, encoders.
#pragma once

#include <axial/simulation/end_stops.hpp>

#include "two_links.hpp"

namespace robots {

struct ElasticLinks : TwoLinks {
  static constexpr auto chain = [] {
    auto all = TwoLinks::chain;
    for (auto& link : all.links)
      link.rotor_inertia = 2e-5, link.gear = 100.0, link.stiffness = 3000.0;
    all.payload_limit = {1.0, 0.2, 0.02, true};
    return all;
  }();
  struct Mechanics {
    static constexpr bool elastic = true, friction = true, payload = true;
    static constexpr axial::EndStops stops{1e5, 30.0};
    static constexpr int encoder_bits = 17;
  };
};

}  // namespace robots
