// The closed form of SCARA dynamics, terms separated. An oracle for the recursions, and the cheapest SCARA torque.
#pragma once

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
};

/// The constants as numbers T (in fixed point as literals), and the one sine-cosine pair that they meet.
template <class S, class T>
struct ScaraTerms : ScaraRounding<S, T> {
  using Scalar = typename ScaraRounding<S, T>::Scalar;
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
    const auto sine = this->sum(quantity::RotationalInertia{}, swing * turned(c * pair.sin + s * pair.cos));
    const auto cosine = this->sum(quantity::RotationalInertia{}, swing * turned(c * pair.cos - s * pair.sin));
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

}  // namespace detail

/// Separated dynamics of a SCARA: RRP with parallel axes and centres of mass on the links' x axes, the slender rods of
/// the paper among them. Source: Djuric et al. 2016, eqs. (82) to (92), with its misprints mended
/// (doc/guides/scara_errata.md). In: q (rad, rad, m). Out: A, B, C, G, and a status as of separate(): nothing in it
/// overflows. For another robot it does not compile and says why.
template <class S, class T>
[[nodiscard]] constexpr auto scara(const Positions<robot_of<S>, T>& q) {
  const detail::ScaraTerms<S, T> k;
  auto swing = k.swing_at(k.read(q)[Index<1>{}]);
  constexpr Index<0> shoulder;
  constexpr Index<1> elbow;
  constexpr Index<2> slide;
  using All = Separated<subject_of<S, T>, T>;
  All s{};
  const Collected<subject_of<S, T>, T, typename detail::ScaraTerms<S, T>::Scalar, All> terms{s};
  terms.inertia(shoulder, shoulder, k.a11(swing.cos));
  terms.inertia(shoulder, elbow, k.a12(swing.cos));
  terms.inertia(elbow, elbow, k.elbow_alone);
  terms.inertia(slide, slide, k.lift);
  terms.product(shoulder, shoulder, elbow, -twice(swing.sin));
  terms.square(shoulder, elbow, -(k.sense * swing.sin));
  terms.square(elbow, shoulder, swing.sin);
  terms.rest(slide, k.weight);
  Soundness<T> all;
  all.angle(q[shoulder]), all.angle(q[elbow]), all.number(q[slide]);
  s.status = all.status();
  return s;
}

/// Torque of the same robots: 11M 10A and one sine-cosine pair. In: q (rad, rad, m), qd, qdd. Out: N m, N m, N.
template <class S, class T>
[[nodiscard]] constexpr EffortsOf<S, T> scara_torque(const Positions<robot_of<S>, T>& q,
                                                     const Velocities<robot_of<S>, T>& qd,
                                                     const Accelerations<robot_of<S>, T>& qdd) {
  using namespace quantity;
  constexpr Index<0> shoulder;
  constexpr Index<1> elbow;
  constexpr Index<2> slide;
  const detail::ScaraTerms<S, T> k;
  auto v = k.read(qd);
  auto a = k.read(qdd);
  auto swing = k.swing_at(k.read(q)[elbow]);
  auto a11 = k.a11(swing.cos);
  auto a12 = k.a12(swing.cos);
  auto twice = k.sum(AngularVelocity{}, v[shoulder], v[shoulder], k.sense * v[elbow]);
  auto cross = k.sum(AngularAcceleration{}, v[elbow] * twice);
  auto square = k.sum(AngularAcceleration{}, v[shoulder] * v[shoulder]);
  EffortsOf<S, T> tau{};
  k.write(tau, shoulder, a11 * a[shoulder] + a12 * a[elbow] - swing.sin * cross);
  k.write(tau, elbow, a12 * a[shoulder] + k.elbow_alone * a[elbow] + swing.sin * square);
  k.write(tau, slide, k.lift * a[slide] + k.weight);
  return tau;
}

}  // namespace closed_form
}  // namespace axial

#include <axial/options/end.hpp>
