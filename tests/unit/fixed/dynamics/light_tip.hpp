// A joint with every limit, and an arm of such joints that words hardly resolve, for tests of certified answers.
#pragma once

#include <axial/robot/chain.hpp>

/// A revolute with a cube-like body of `mass` (kg) and `size` (m) beside its axis; its limits are those of a quick arm.
inline constexpr axial::Link joint(double mass, double size) {
  const double j = mass * size * size / 6.0;
  return axial::revolute()
      .mass(mass)
      .com(0.5 * size, 0.0, 0.1 * size)
      .inertia_com(j, j, j)
      .position_limits(-2.0, 2.0)
      .speed_limit(2.0)
      .acceleration_limit(32.0)
      .effort_limit(64.0);
}

/// A tip of a gram on links of kilograms.
struct LightTip {
  static constexpr auto chain = axial::chain(axial::gravity(0.0, -9.81, 0.0), joint(4.0, 0.4), joint(2.0, 0.3).a(0.4),
                                             joint(1e-3, 0.01).a(0.3).alpha_deg(70));
};
