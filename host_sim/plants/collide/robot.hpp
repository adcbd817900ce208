// The Panda with friction, as the plant has it and as the observer knows it.
#pragma once

#include <robots/panda.hpp>

namespace host_sim::collide {

/// What a plant differs in from its model.
struct Mismatch {
  double inertial = 0.0;  ///< masses, centres of mass, inertias: times 1 + this and 1 - this, in turns
  double friction = 0.0;  ///< viscous and Coulomb friction, likewise
  bool smooth = false;    ///< Coulomb friction falls to 0 at rest, as a plant to be integrated needs
};

/// Assumed: no published friction of this arm is viscous and Coulomb. Arm: 0.5 N m and 0.5 N m s; wrist: 0.15 and 0.1.
constexpr auto panda_with_friction(const Mismatch& off) {
  auto chain = robots::Panda::chain;
  for (int i = 0; i < chain.size; ++i) {
    auto& link = chain.links[i];
    const double sign = i % 2 == 0 ? 1.0 : -1.0, inertial = 1.0 + sign * off.inertial;
    link.mass *= inertial;
    for (double& x : link.com)
      x *= 1.0 - 0.5 * sign * off.inertial;
    for (double& x : link.inertia_com)
      x *= inertial;
    const double dry = (i < 4 ? 0.5 : 0.15) * (1.0 - sign * off.friction);
    link.viscous = (i < 4 ? 0.5 : 0.1) * (1.0 + sign * off.friction);
    link.coulomb_forward = dry, link.coulomb_backward = -dry;
    if (off.smooth) link.smooth_speed = 0.05;
  }
  return chain;
}

/// What the firmware knows.
struct Known {
  static constexpr const char* name = "panda";
  static constexpr auto chain = panda_with_friction({});
};
/// What moves: 1 % other inertial parameters, 10 % other friction.
struct Moving {
  static constexpr const char* name = "panda";
  static constexpr auto chain = panda_with_friction({0.01, 0.1, true});
};

}  // namespace host_sim::collide
