// What the SCARA's closed form depends on, and what the robot must be for it.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/links/link_constants.hpp>
#include <axial/scene/scene.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace closed_form {
namespace detail {

/// Everything that the torque depends on. Arms are measured along the links' x axes from their joints.
struct ScaraConstants {
  double shoulder = 0.0;  ///< part of A11 that does not depend on theta2, kg m^2
  double elbow = 0.0;     ///< A22 without its rotor, kg m^2
  double elbow_rotor = 0.0;
  double swing = 0.0;   ///< k a1 a2 of the paper: A12 = elbow + swing cos(theta2), kg m^2
  double lift = 0.0;    ///< A33, kg
  double weight = 0.0;  ///< G3, N
  double sense = 1.0;   ///< +1: axis 2 along axis 1, -1: against it
};

template <class Robot>
constexpr auto check_scara() {
  constexpr auto& c = Robot::chain;
  static_assert(c.size == 3, "axial: closed_form::scara needs three joints: revolute, revolute, prismatic (RRP)");
  if constexpr (c.size == 3) {
    static_assert(c.links[0].type == JointType::revolute && c.links[1].type == JointType::revolute &&
                      c.links[2].type == JointType::prismatic,
                  "axial: closed_form::scara needs three joints: revolute, revolute, prismatic (RRP)");
    static_assert(c.parent(0) == -1 && c.parent(1) == 0 && c.parent(2) == 1,
                  "axial: closed_form::scara needs a serial chain; remove parent()");
    static_assert(c.links[0].alpha.sin == 0.0 && c.links[1].alpha.sin == 0.0 && c.links[2].alpha.sin == 0.0,
                  "axial: closed_form::scara needs parallel axes: alpha_deg(0) or alpha_deg(180); otherwise use "
                  "inverse_dynamics");
    static_assert(c.links[0].com[1] == 0.0 && c.links[1].com[1] == 0.0 && c.links[2].com[1] == 0.0,
                  "axial: closed_form::scara needs centres of mass on the links' x axes: com(x, 0, z); otherwise use "
                  "inverse_dynamics");
    static_assert(c.links[2].theta.sin == 0.0,
                  "axial: closed_form::scara needs theta_deg(0) or theta_deg(180) in the prismatic link; otherwise use "
                  "inverse_dynamics");
    static_assert(c.gravity.x == 0.0 && c.gravity.y == 0.0,
                  "axial: closed_form::scara needs gravity along the axes; otherwise use inverse_dynamics");
  }
}

/// Lagrange's equations of the RRP arm with parallel axes.
template <class S>
constexpr ScaraConstants scara_constants() {
  using Scene = scene_of<S>;
  constexpr auto& c = Scene::Robot::chain;
  const auto l1 = link_constants(c.links[0], -1), l2 = link_constants(c.links[1], 0),
             l3 = link_constants(c.links[2], 1);
  constexpr bool rotors = Scene::template has<RotorInertia>, falls = Scene::template has<Gravity>;
  const double a1 = l2.a, arm3 = l3.a + l3.cos_theta * c.links[2].com[0];
  ScaraConstants k;
  k.elbow = l2.jzz + l3.mass * arm3 * arm3 + c.links[2].inertia_com[2];
  k.elbow_rotor = rotors ? l2.rotor : 0.0;
  k.swing = a1 * (l2.hx + l3.mass * arm3);
  k.shoulder = l1.jzz + (l2.mass + l3.mass) * a1 * a1 + k.elbow + (rotors ? l1.rotor : 0.0);
  k.lift = l3.mass + (rotors ? l3.rotor : 0.0);
  k.weight = falls ? -l3.mass * c.gravity.z * l1.cos_alpha * l2.cos_alpha * l3.cos_alpha : 0.0;
  k.sense = l2.cos_alpha;
  return k;
}

}  // namespace detail
}  // namespace closed_form
}  // namespace axial

#include <axial/options/end.hpp>
