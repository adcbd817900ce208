// Scenarios of tests/cases as robots that the compiler knows, with limits declared just beyond them: what fixed point
// asks for. Each limit is the next power of two.
#pragma once

#include <axial/axial.hpp>

namespace stability::declared {

constexpr double as_float(double x) { return static_cast<double>(static_cast<float>(x)); }
constexpr double power_of_two(int exponent) {
  double result = 1.0;
  for (int i = 0; i < exponent; ++i)
    result *= 2.0;
  for (int i = 0; i > exponent; --i)
    result /= 2.0;
  return result;
}

/// The limits of a robot, the same for all of its joints.
struct Limits {
  double position, speed, acceleration, effort;
};
constexpr axial::Link within(const Limits& l, const axial::Link& link) {
  return link.position_limits(-l.position, l.position)
      .speed_limit(l.speed)
      .acceleration_limit(l.acceleration)
      .effort_limit(l.effort);
}

/// A body whose inertia a kilogram is given.
constexpr axial::Link slender(const axial::Link& link, double mass, double along, double across) {
  return link.mass(mass).inertia_com(as_float(mass * along), as_float(mass * across), as_float(mass * across));
}

/// The nominal arm. A specification derived from this changes the masses (the last link is a tip where `tip` > 0, its
/// centre so many m out), the rotors or the limits.
struct Nominal {
  static constexpr double masses[] = {8.0, 6.0, 4.0, 2.0, 1.0, 0.5};
  static constexpr double tip = 0.0, rotor = 0.0;
  static constexpr Limits limits{2.0, 2.0, 32.0, 64.0};
};

template <class Spec>
struct Arm {
  static constexpr axial::Link link(int i) {
    constexpr double a[] = {0.0, 0.0625, 0.4375, 0.0625, 0.0, 0.0}, d[] = {0.5, 0.0, 0.125, 0.4375, 0.0, 0.125};
    constexpr int quarters[] = {0, 1, 0, 1, -1, 1};
    constexpr double slim = as_float(1.0 / 384.0), wide = as_float(5.0 / 768.0);
    const auto joint = axial::revolute().alpha_deg(90 * quarters[i]).a(a[i]).d(d[i]);
    const auto driven = within(Spec::limits, Spec::rotor > 0.0 ? joint.rotor_inertia(Spec::rotor, 1.0) : joint);
    const double m = Spec::masses[i], across = m * Spec::tip * Spec::tip;
    if (i == 5 && Spec::tip > 0.0)
      return driven.mass(m).com(0.0, 0.0, Spec::tip).inertia_com(across, across, across / 2);
    return slender(driven.com(0.0625, -0.03125, 0.125), m, slim, wide);
  }
  static constexpr auto chain =
      axial::chain(axial::gravity(0.0, 0.0, -9.8125), link(0), link(1), link(2), link(3), link(4), link(5));
};

struct HeavyTip : Nominal {
  static constexpr double light = power_of_two(-10), masses[] = {light, light, light, light, light, 1.0};
  static constexpr double tip = 0.125;
  static constexpr Limits limits{2.0, 2.0, 256.0, 8.0};
};
struct LightTip : Nominal {
  static constexpr double masses[] = {8.0, 6.0, 4.0, 2.0, 1.0, power_of_two(-10)};
  static constexpr double tip = 0.015625;
};
struct LargeRotors : Nominal {
  static constexpr double rotor = 1024.0;
  static constexpr Limits limits{2.0, 2.0, 0.0625, 64.0};
};
struct Fast : Nominal {
  static constexpr Limits limits{2.0, 64.0, 8192.0, 1024.0};
};

/// The wrist of ST6 with rotors; without, nothing bounds the middle joint's inertia from below.
constexpr axial::Link wrist_link(int quarters) {
  const auto joint = axial::revolute().alpha_deg(90 * quarters).rotor_inertia(power_of_two(-10), 1.0);
  return within({2.0, 2.0, 16.0, 16.0}, joint);
}
struct Wrist {
  static constexpr auto chain = axial::chain(axial::gravity(0.0, -9.8125, 0.0), wrist_link(0), wrist_link(-1),
                                             wrist_link(-1).mass(1.0).com(0.5, 0.25, 0.0).inertia_com(1.0, 1.0, 1.0));
};

/// ST1: ten rods, straight.
constexpr axial::Link rod(double a) {
  const double across = as_float(1.0 / 12.0);
  const auto joint = axial::revolute().a(a).mass(1.0).com(0.5, 0.0, 0.0);
  return within({2.0, 2.0, 16.0, 512.0}, joint.inertia_com(power_of_two(-10), across, across));
}
struct Rods {
  static constexpr auto chain = axial::chain(axial::gravity(0.0, -9.8125, 0.0), rod(0.0), rod(1.0), rod(1.0), rod(1.0),
                                             rod(1.0), rod(1.0), rod(1.0), rod(1.0), rod(1.0), rod(1.0));
};

}  // namespace stability::declared
