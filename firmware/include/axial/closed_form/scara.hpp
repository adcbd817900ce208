// The closed form of SCARA dynamics, terms separated. An oracle for the recursions, and the cheapest SCARA torque.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/closed_form/scara_constants.hpp>
#include <axial/links/link_view.hpp>
#include <axial/links/plain_values.hpp>
#include <axial/links/separated_terms.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace closed_form {
namespace detail {

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
  detail::check_scara<robot_of<S>>();
  using Rounder = detail::ScaraRounding<S, T>;
  using All = Separated<subject_of<S, T>, T>;
  const detail::ScaraTerms<S, Rounder> k;
  All s{};
  const Collected<subject_of<S, T>, T, typename Rounder::Scalar, All> terms{s};
  detail::separate_into(k, k.read(q)[Index<1>{}], terms);
  Soundness<T> all;
  all.angle(q[0]), all.angle(q[1]), all.number(q[2]);
  s.status = all.status();
  return s;
}

/// Torque of the same robots: 11M 10A and one sine-cosine pair. In: q (rad, rad, m), qd, qdd. Out: N m, N m, N.
template <class S, class T>
[[nodiscard]] constexpr EffortsOf<S, T> scara_torque(const Positions<robot_of<S>, T>& q,
                                                     const Velocities<robot_of<S>, T>& qd,
                                                     const Accelerations<robot_of<S>, T>& qdd) {
  detail::check_scara<robot_of<S>>();
  const detail::ScaraTerms<S, detail::ScaraRounding<S, T>> k;
  EffortsOf<S, T> tau{};
  detail::torque_into(k, k.read(q)[Index<1>{}], k.read(qd), k.read(qdd), tau);
  return tau;
}

}  // namespace closed_form
}  // namespace axial

#include <axial/options/end.hpp>
