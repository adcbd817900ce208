// Robots whose constants are all different and non-zero, for counting operations: only the twists are chosen.
#pragma once

#include <axial/axial.hpp>

namespace generic {

// Link i of a generic robot: no constant is 0, 1 or -1, none occurs twice.
constexpr axial::Link link(axial::Link l, int i, bool first) {
  const double k = 1.0 + 0.01 * i;
  const double x = 0.1 * k, y = 0.07 * k, z = 0.13 * k;
  return l.a(first ? 0.0 : 0.31 * k)
      .d(first ? 0.0 : 0.23 * k)
      .mass(2.0 * k + 0.013)
      .com(x, y, z)
      .inertia_com(0.31 * k, 0.27 * k, 0.23 * k, 0.011 * k, 0.017 * k, 0.019 * k);
}

template <int N>
constexpr axial::Chain<N> chain(double alpha_deg, bool prismatic_tip) {
  axial::Chain<N> c;
  for (int i = 0; i < N; ++i) {
    const bool prismatic = prismatic_tip && i + 1 == N;
    auto l = link(prismatic ? axial::prismatic().theta_deg(20.0) : axial::revolute(), i, i == 0);
    c.links[i] = l.alpha_deg(i == 0 ? 0.0 : alpha_deg).parameters();
  }
  return c;
}

/// N revolute joints (or the last one prismatic), every twist but the first the same; first a, d, alpha zero; gravity
/// along z. AlphaDeg 37 stands for a general twist.
template <int N, int AlphaDeg, bool PrismaticTip = false>
struct Robot {
  static constexpr auto chain = generic::chain<N>(AlphaDeg, PrismaticTip);
};

}  // namespace generic
