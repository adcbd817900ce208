// The closed form of SCARA dynamics, terms separated. An oracle for the recursions, and the cheapest SCARA torque.
#pragma once

#include <axial/model/link_constants.hpp>
#include <axial/model/separated.hpp>
#include <axial/scalar/rounding.hpp>

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
constexpr void check_scara() {
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

/// The constants as numbers T, and the one sine-cosine pair that they meet.
template <class S, class T>
struct ScaraTerms {
  static constexpr ScaraConstants k = (check_scara<robot_of<S>>(), scara_constants<S>());
  static constexpr auto shoulder = literal<T>([] { return k.shoulder; });
  static constexpr auto elbow = literal<T>([] { return k.elbow; });
  static constexpr auto elbow_alone = literal<T>([] { return k.elbow + k.elbow_rotor; });
  static constexpr auto swing = literal<T>([] { return k.swing; });
  static constexpr auto lift = literal<T>([] { return k.lift; });
  static constexpr auto weight = literal<T>([] { return k.weight; });
  static constexpr auto sense = literal<T>([] { return k.sense; });

  /// swing (sin, cos) of theta2 with its offset, exact for quarter turns.
  static constexpr SinCos<T> swing_at(const T& q2) {
    constexpr auto c = literal<T>([] { return robot_of<S>::chain.links[1].theta.cos; });
    constexpr auto s = literal<T>([] { return robot_of<S>::chain.links[1].theta.sin; });
    const auto pair = sincos(q2);
    return {swing * (c * pair.sin + s * pair.cos), swing * (c * pair.cos - s * pair.sin)};
  }
};

}  // namespace detail

/// Separated dynamics of a SCARA: RRP with parallel axes and centres of mass on the links' x axes, the slender rods of
/// the paper among them. Source: Djuric et al. 2016, eqs. (82) to (92), with its misprints mended
/// (doc/scara_errata.md). In: q (rad, rad, m). Out: A, B, C, G. For another robot it does not compile and says why.
template <class S, class T>
constexpr Separated<robot_of<S>, T> scara(const Positions<robot_of<S>, T>& q) {
  using K = detail::ScaraTerms<S, T>;
  const auto swing = K::swing_at(q[1]);
  const auto a12 = K::sense * (K::elbow + swing.cos);
  Separated<robot_of<S>, T> s{};
  s.A[0][0] = K::shoulder + (swing.cos + swing.cos);
  s.A[0][1] = s.A[1][0] = a12;
  s.A[1][1] = K::elbow_alone;
  s.A[2][2] = K::lift;
  s.B[0][0] = -(swing.sin + swing.sin);
  s.C[0][1] = -(K::sense * swing.sin);
  s.C[1][0] = swing.sin;
  s.G[2] = K::weight;
  return s;
}

/// Torque of the same robots: 11M 10A and one sine-cosine pair. In: q (rad, rad, m), qd, qdd. Out: N m, N m, N.
template <class S, class T>
constexpr EffortsOf<S, T> scara_torque(const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd,
                                               const Accelerations<robot_of<S>, T>& qdd) {
  using K = detail::ScaraTerms<S, T>;
  const auto swing = K::swing_at(q[1]);
  const auto a11 = K::shoulder + (swing.cos + swing.cos);
  const auto a12 = K::sense * (K::elbow + swing.cos);
  const auto velocity = qd[1] * (qd[0] + qd[0] + K::sense * qd[1]);
  return {a11 * qdd[0] + a12 * qdd[1] - swing.sin * velocity,
          a12 * qdd[0] + K::elbow_alone * qdd[1] + swing.sin * (qd[0] * qd[0]), K::lift * qdd[2] + K::weight};
}

}  // namespace closed_form
}  // namespace axial
