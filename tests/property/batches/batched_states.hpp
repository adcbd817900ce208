// Two states, drawn, one by one and as lanes of a batch.
#pragma once

#include <axial/batch.hpp>
#include <oracle/random_chain.hpp>

#include <property/support.hpp>

namespace property {

/// Positions, speeds and a third quantity of robot R.
template <class R>
struct BatchedStates {
  using V = axial::Batch<double, 2>;
  static constexpr int size = axial::joint_count<R>;
  axial::Joints<R, V> x[3] = {};
  axial::Joints<R, double> lanes[2][3] = {};

  explicit BatchedStates(unsigned seed) {
    oracle::RandomChains random(seed);
    for (auto& lane : lanes)
      for (auto& quantity : lane)
        quantity = joints<R, double>(random.vector(size, 2.0));
    for (int quantity = 0; quantity < 3; ++quantity)
      for (int k = 0; k < size; ++k)
        x[quantity][k] = V::of([&](int lane) { return lanes[lane][quantity][k]; });
  }
};

}  // namespace property
