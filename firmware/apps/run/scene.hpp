#pragma once
/// What acts on the robot of a run: gravity, rotors, and the friction and springs that its header declares; fixed point
/// leaves out what it does not offer.

#include <axial/axial.hpp>

#include <type_traits>

namespace axial::apps::run {

/// Whether a joint has friction, friction that fixed point does not offer, or a spring.
constexpr bool has_friction(const LinkParameters& p) {
  return p.viscous != 0.0 || p.coulomb_forward != 0.0 || p.coulomb_backward != 0.0 || p.static_friction != 0.0;
}
constexpr bool has_curved_friction(const LinkParameters& p) {
  return p.static_friction != 0.0 || p.smooth_speed != 0.0;
}
constexpr bool has_spring(const LinkParameters& p) { return p.spring_stiffness != 0.0; }

template <class Robot>
constexpr bool any_joint(bool (*has)(const LinkParameters&)) {
  for (const LinkParameters& link : Robot::chain.links)
    if (has(link)) return true;
  return false;
}

/// What of it a run in floating or fixed point computes.
template <class Robot, bool fixed>
inline constexpr bool with_friction = any_joint<Robot>(has_friction) &&
                                      !(fixed && any_joint<Robot>(has_curved_friction));
template <class Robot, bool fixed>
inline constexpr bool with_springs = any_joint<Robot>(has_spring) && !fixed;

/// The scene of a run. In floating point friction and springs that no joint has cost nothing.
template <class Robot, bool fixed>
using SceneOf =
    std::conditional_t<!fixed, Scene<Robot, Gravity, RotorInertia, Friction, JointSprings>,
                       std::conditional_t<with_friction<Robot, true>, Scene<Robot, Gravity, RotorInertia, Friction>,
                                          Scene<Robot, Gravity, RotorInertia>>>;

}  // namespace axial::apps::run
