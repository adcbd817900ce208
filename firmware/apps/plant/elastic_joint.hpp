#pragma once
/// An elastic joint as two of a rigid chain (Spong 1987): one of the motor, which carries the rotor, friction and no
/// mass, and behind it, about the same axis, one of the deflection q - theta with the spring.

#include <axial/robot/chain.hpp>

namespace axial::apps::plant {

constexpr bool is_elastic(const LinkParameters& link) { return link.stiffness < LinkParameters::unlimited; }

constexpr LinkParameters motor_of(const LinkParameters& link) {
  LinkParameters motor = link;
  motor.mass = 0.0, motor.stiffness = LinkParameters::unlimited;
  for (double& c : motor.com)
    c = 0.0;
  for (double& i : motor.inertia_com)
    i = 0.0;
  return motor;
}

/// `damping` of the spring, N m s/rad or N s/m.
constexpr LinkParameters body_of(const LinkParameters& link, double damping = 0.0) {
  LinkParameters body;
  body.type = link.type, body.mass = link.mass, body.spring_stiffness = link.stiffness, body.viscous = damping;
  for (int k = 0; k < 3; ++k)
    body.com[k] = link.com[k];
  for (int k = 0; k < 6; ++k)
    body.inertia_com[k] = link.inertia_com[k];
  return body;
}

}  // namespace axial::apps::plant
