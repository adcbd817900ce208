// The closed form of SCARA dynamics, terms separated. An oracle for the recursions, and the cheapest SCARA torque.
// What it depends on, and what the robot must be for it.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/links/link_constants.hpp>
#include <axial/links/link_view.hpp>
#include <axial/links/plain_values.hpp>
#include <axial/links/separated_terms.hpp>
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

/// Whether what follows can be computed: joints enough, whatever else was said.
template <class Robot>
constexpr bool check_scara() {
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
  return c.size == 3;
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

/// How the closed form rounds, and reads and writes joint values: as they are.
template <class S, class T>
struct ScaraRounding : Plain, PlainValues<scene_of<S>, T> {
  using Scalar = T;
  /// A sine or cosine of a sum of angles.
  template <class X, class Y>
  AXIAL_INLINE static constexpr auto turn(const X& x, const Y& y) {
    return turned(x + y);
  }
};

/// The constants as numbers (in fixed point as literals), and the one sine-cosine pair that they meet. `Rounder` says
/// how numbers are rounded, read and written.
template <class S, class Rounder>
struct ScaraTerms : Rounder {
  using Scalar = typename Rounder::Scalar;
  static constexpr ScaraConstants k = (check_scara<robot_of<S>>(), scara_constants<S>());
  static constexpr auto shoulder = literal<Scalar>([] { return k.shoulder; });
  static constexpr auto elbow = literal<Scalar>([] { return k.elbow; });
  static constexpr auto elbow_alone = literal<Scalar>([] { return k.elbow + k.elbow_rotor; });
  static constexpr auto swing = literal<Scalar>([] { return k.swing; });
  static constexpr auto lift = literal<Scalar>([] { return k.lift; });
  static constexpr auto weight = literal<Scalar>([] { return k.weight; });
  static constexpr auto sense = literal<Scalar>([] { return k.sense; });

  /// swing (sin, cos) of theta2 with its offset, exact for quarter turns.
  template <class Q>
  AXIAL_INLINE constexpr auto swing_at(const Q& q2) const {
    constexpr auto c = literal<Scalar>([] { return robot_of<S>::chain.links[1].theta.cos; });
    constexpr auto s = literal<Scalar>([] { return robot_of<S>::chain.links[1].theta.sin; });
    const auto pair = sincos(q2);
    const auto sine = this->sum(quantity::RotationalInertia{}, swing * this->turn(c * pair.sin, s * pair.cos));
    const auto cosine = this->sum(quantity::RotationalInertia{}, swing * this->turn(c * pair.cos, -(s * pair.sin)));
    return SinCos<std::decay_t<decltype(sine)>>{sine, cosine};
  }
  /// A11 and A12 (which A21 equals).
  template <class Cosine>
  AXIAL_INLINE constexpr auto a11(const Cosine& cosine) const {
    return this->sum(quantity::JointInertia{}, shoulder, cosine, cosine);
  }
  template <class Cosine>
  AXIAL_INLINE constexpr auto a12(const Cosine& cosine) const {
    return this->sum(quantity::RotationalInertia{}, sense * elbow, sense * cosine);
  }
};

/// Sets the separated terms, from the reading of joint 2.
template <class Terms, class Q, class Out>
AXIAL_INLINE constexpr void separate_into(const Terms& k, const Q& q2, const Out& terms) {
  constexpr Index<0> shoulder;
  constexpr Index<1> elbow;
  constexpr Index<2> slide;
  auto swing = k.swing_at(q2);
  terms.inertia(shoulder, shoulder, k.a11(swing.cos));
  terms.inertia(shoulder, elbow, k.a12(swing.cos));
  terms.inertia(elbow, elbow, k.elbow_alone);
  terms.inertia(slide, slide, k.lift);
  terms.product(shoulder, shoulder, elbow, -twice(swing.sin));
  terms.square(shoulder, elbow, -(k.sense * swing.sin));
  terms.square(elbow, shoulder, swing.sin);
  terms.rest(slide, k.weight);
}

/// Sets the torque, from the reading of joint 2.
template <class Terms, class Q, class V, class A, class Tau>
AXIAL_INLINE constexpr void torque_into(const Terms& k, const Q& q2, const V& v, const A& a, Tau& tau) {
  using namespace quantity;
  constexpr Index<0> shoulder;
  constexpr Index<1> elbow;
  constexpr Index<2> slide;
  auto swing = k.swing_at(q2);
  auto a11 = k.a11(swing.cos);
  auto a12 = k.a12(swing.cos);
  auto twice = k.sum(AngularVelocity{}, v[shoulder], v[shoulder], k.sense * v[elbow]);
  auto cross = k.sum(AngularAcceleration{}, v[elbow] * twice);
  auto square = k.sum(AngularAcceleration{}, v[shoulder] * v[shoulder]);
  k.write(tau, shoulder, a11 * a[shoulder] + a12 * a[elbow] - swing.sin * cross);
  k.write(tau, elbow, a12 * a[shoulder] + k.elbow_alone * a[elbow] + swing.sin * square);
  k.write(tau, slide, k.lift * a[slide] + k.weight);
}

}  // namespace detail

/// Separated dynamics of a SCARA: RRP with parallel axes and centres of mass on the links' x axes, the slender rods of
/// the paper among them. Source: Djuric et al. 2016, eqs. (82) to (92), with its misprints mended
/// (doc/guides/scara_errata.md). In: q (rad, rad, m). Out: A, B, C, G, and a status as of separate(): nothing in it
/// overflows. For another robot it does not compile and says why.
template <class S, class T>
[[nodiscard]] constexpr auto scara(const Positions<robot_of<S>, T>& q) {
  using Rounder = detail::ScaraRounding<S, T>;
  using All = Separated<subject_of<S, T>, T>;
  All s{};
  if constexpr (detail::check_scara<robot_of<S>>()) {
    const detail::ScaraTerms<S, Rounder> k;
    const Collected<subject_of<S, T>, T, typename Rounder::Scalar, All> terms{s};
    detail::separate_into(k, k.read(q)[Index<1>{}], terms);
    Soundness<T> all;
    all.angle(q[0]), all.angle(q[1]), all.number(q[2]);
    s.status = all.status();
  }
  return s;
}

/// Torque of the same robots: 11M 10A and one sine-cosine pair. In: q (rad, rad, m), qd, qdd. Out: N m, N m, N.
template <class S, class T>
[[nodiscard]] constexpr EffortsOf<S, T> scara_torque(const Positions<robot_of<S>, T>& q,
                                                     const Velocities<robot_of<S>, T>& qd,
                                                     const Accelerations<robot_of<S>, T>& qdd) {
  EffortsOf<S, T> tau{};
  if constexpr (detail::check_scara<robot_of<S>>()) {
    const detail::ScaraTerms<S, detail::ScaraRounding<S, T>> k;
    detail::torque_into(k, k.read(q)[Index<1>{}], k.read(qd), k.read(qdd), tau);
  }
  return tau;
}

}  // namespace closed_form
}  // namespace axial

#include <axial/options/end.hpp>
