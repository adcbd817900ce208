// Robots whose joints share drives and that declare what fixed point asks for: one by hand, others by numbers alone.
#pragma once

#include <axial/robot/chain.hpp>
#include <cstdint>

namespace property {

/// A belt with a ratio that no word holds, an offset, a slide that follows a turn.
struct Followers {
  static constexpr const char* name = "followers";
  // A line a group of values.
  // clang-format off
  static constexpr auto chain = axial::chain(axial::gravity(1.0, -2.0, -9.0),
      axial::revolute().mass(4).com(0.1, 0.02, 0.05).inertia_com(0.2, 0.25, 0.3, 0.01, 0.0, 0.02).rotor_inertia(5e-4, 20)
          .viscous(0.5).coulomb(0.25).effort_limit(90).position_limits(-3, 3).speed_limit(3).acceleration_limit(20),
      axial::revolute().alpha_deg(-90).a(0.2).mass(2).com(0.1, 0, 0.01).inertia_com(0.05, 0.06, 0.07).mimic(0, -0.3, 0.25),
      axial::prismatic().alpha(0.7).d(0.1).mass(1.5).com(0.02, 0.1, 0).inertia_com(0.02, 0.03, 0.04).mimic(1, 0.125, -0.5),
      axial::revolute().parent(0).alpha_deg(90).a(0.3).mass(1).com(0.1, 0.01, 0.05).inertia_com(0.01, 0.01, 0.005)
          .rotor_inertia(1e-4, 40).viscous(0.125).driven_by(0, 0.75).driven_by(3, 2.0).speed_limit(6).effort_limit(30)
          .drive_limits(-20, 40, 5, 40));
  // clang-format on
};

/// Number k of a robot that numbers alone describe, from -1 to 1.
constexpr double drawn_number(int robot, int k) {
  std::uint32_t x = std::uint32_t(robot) * 2654435761U + std::uint32_t(k) * 40503U + 12345U;
  for (int i = 0; i < 4; ++i)
    x = (x ^ (x >> 15)) * 2246822519U;
  return double(x >> 8) / 8388608.0 - 1.0;
}

/// What no robot says: links, a tree and couplings from numbers alone; some drives without a rotor.
template <int Number>
struct Coupled {
  static constexpr const char* name = "coupled";
  static constexpr int n = 3 + Number % 2;
  static constexpr double number(int k) { return drawn_number(Number, k); }
  /// A square from `low` to `high`.
  static constexpr double size(int k, double low, double high) { return low + (high - low) * number(k) * number(k); }
  static constexpr auto link(int i) {
    const int at = 50 * i;
    const double m = size(at, 0.2, 6.0), r = size(at + 1, 0.03, 0.2), j = m * r * r;
    auto one = axial::revolute()
                   .a(0.4 * number(at + 2))
                   .alpha(3.0 * number(at + 3))
                   .mass(m)
                   .com(0.1 * number(at + 4), 0.1 * number(at + 5), 0.1 * number(at + 6))
                   .inertia_com(j, size(at + 7, 0.5, 1.4) * j, size(at + 8, 0.6, 1.4) * j)
                   .rotor_inertia(number(at + 9) > -0.3 ? size(at + 10, 1e-5, 2e-4) : 0.0, 40.0)
                   .viscous(0.1)
                   .coulomb(0.2)
                   .effort_limit(size(at + 11, 5.0, 60.0))
                   .drive_limits(-4.0, 4.0, size(at + 12, 1.0, 6.0), size(at + 13, 5.0, 40.0));
    for (int k = 0; k < i; ++k)
      if (number(at + 20 + k) > -0.3) one = one.driven_by(k, 1.5 * number(at + 30 + k));
    return one.driven_by(i, number(at + 40) > 0.0 ? 0.7 : -1.3);
  }
  static constexpr auto chain = [] {
    if constexpr (n == 3)
      return axial::chain(axial::gravity(1.0, -3.0, -9.0), link(0), link(1), link(2));
    else
      return axial::chain(axial::gravity(1.0, -3.0, -9.0), link(0), link(1), link(2).parent(0), link(3));
  }();
};

}  // namespace property
