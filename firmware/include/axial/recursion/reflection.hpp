// An articulated body seen across its joint: the reflected inertia N, the gain K and the bias that passes through.
#pragma once

#include <axial/recursion/joint_axis.hpp>
#include <axial/recursion/resistance.hpp>
#include <axial/spatial/articulated_inertia.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Column of a 6x6 inertia along a joint, U = I* phi: angular and linear rows.
template <class I>
AXIAL_INLINE constexpr auto joint_column(Revolute, const I& i) {
  return MotionVector{Vec3{i.angular.xz, i.angular.yz, i.angular.zz}, i.coupling.z};
}
/// Prismatic overload.
template <class I>
AXIAL_INLINE constexpr auto joint_column(Prismatic, const I& i) {
  return MotionVector{Vec3{i.coupling.x.z, i.coupling.y.z, i.coupling.z.z},
                      Vec3{i.linear.xz, i.linear.yz, i.linear.zz}};
}

namespace detail {

template <class I>
AXIAL_INLINE constexpr auto axis_inertia(Revolute, const I& i) {
  return i.angular.zz;
}
template <class I>
AXIAL_INLINE constexpr auto axis_inertia(Prismatic, const I& i) {
  return i.linear.zz;
}

// K_s = I_ss / D, exactly 1 without a rotor: then the joint transmits its effort and nothing else.
template <class Link, class I, class J, class R>
AXIAL_INLINE constexpr auto axis_gain(const Link& link, const I& inertia, const J& rotor, const R& inverse) {
  if constexpr (is_zero_v<J>) {
    return One{};
  } else {
    auto gain = link.quotient(quantity::AngularGain{}, inverse, inertia);
    if constexpr (Link::unrolled)
      return gain;
    else
      return select(rotor > J(Zero{}), gain, J(One{}));
  }
}

// s - U K^T on the plane x, y; the joint's row and column are K_k J_rotor (zero by type without a rotor) instead of a
// difference that cancels.
template <class S, class U, class K, class KS, class J, class Round, class Q>
AXIAL_INLINE constexpr auto reduced(Round round, Q q, const S& s, const U& u, const K& k, const KS& axis,
                                    const J& rotor) {
  return Sym3{round.sum(q, s.xx, -(u.x * k.x)), round.sum(q, s.yy, -(u.y * k.y)), round.sum(q, axis * rotor),
              round.sum(q, s.xy, -(u.x * k.y)), round.sum(q, k.x * rotor),        round.sum(q, k.y * rotor)};
}
template <class S, class U, class K, class Round, class Q>
AXIAL_INLINE constexpr auto reduced(Round round, Q q, const S& s, const U& u, const K& k) {
  return Sym3{round.sum(q, s.xx, -(u.x * k.x)), round.sum(q, s.yy, -(u.y * k.y)), round.sum(q, s.zz, -(u.z * k.z)),
              round.sum(q, s.xy, -(u.x * k.y)), round.sum(q, s.xz, -(u.x * k.z)), round.sum(q, s.yz, -(u.y * k.z))};
}

}  // namespace detail

/// Reflected inertia N_jk = I_jk - U_j K_k, McMillan and Orin 1995, eqs. (4)-(6): 20M 15A for one joint without a rotor
/// (K takes 5M of them, given 1/D). `gain` is K, `axis_gain` its component along the joint.
template <class Link, class I, class U, class K, class KS, class J>
AXIAL_INLINE constexpr auto reflected(Revolute, const Link& link, const I& i, const U& u, const K& k, const KS& axis,
                                      const J& rotor) {
  using namespace quantity;
  auto row = [&](const auto& c, const auto& uj) { return link.sum(FirstMoment{}, c, -(uj * k.linear)); };
  return ArticulatedInertia{
      detail::reduced(link, RotationalInertia{}, i.angular, u.angular, k.angular, axis, rotor),
      Mat3{row(i.coupling.x, u.angular.x), row(i.coupling.y, u.angular.y), link.sum(FirstMoment{}, rotor * k.linear)},
      detail::reduced(link, Mass{}, i.linear, u.linear, k.linear)};
}
/// Prismatic overload.
template <class Link, class I, class U, class K, class KS, class J>
AXIAL_INLINE constexpr auto reflected(Prismatic, const Link& link, const I& i, const U& u, const K& k, const KS& axis,
                                      const J& rotor) {
  using namespace quantity;
  auto row = [&](const auto& c, const auto& uj, const auto& kj) {
    return Vec3{link.sum(FirstMoment{}, c.x, -(uj * k.linear.x)), link.sum(FirstMoment{}, c.y, -(uj * k.linear.y)),
                link.sum(FirstMoment{}, kj * rotor)};
  };
  return ArticulatedInertia{
      detail::reduced(link, RotationalInertia{}, i.angular, u.angular, k.angular),
      Mat3{row(i.coupling.x, u.angular.x, k.angular.x), row(i.coupling.y, u.angular.y, k.angular.y),
           row(i.coupling.z, u.angular.z, k.angular.z)},
      detail::reduced(link, Mass{}, i.linear, u.linear, k.linear, axis, rotor)};
}

/// N zeta, in the products that it is summed from: of both parts of zeta, moments and forces.
template <class A, class B, class C, class D>
struct BiasProducts {
  A turning_moment{};  ///< of the angular part: N m
  B moment{};          ///< of the linear part: N m
  C turning_force{};   ///< of the angular part: N
  D force{};           ///< of the linear part: N
};
template <class A, class B, class C, class D>
BiasProducts(A, B, C, D) -> BiasProducts<A, B, C, D>;
/// The products N zeta for an inertia N and a bias acceleration zeta.
template <class N, class Z>
AXIAL_INLINE constexpr auto bias_products(const N& n, const Z& zeta) {
  return BiasProducts{n.angular * zeta.angular, n.coupling * zeta.linear, transpose_times(n.coupling, zeta.angular),
                      n.linear * zeta.linear};
}
/// Bias products of a structure at rest.
inline constexpr BiasProducts<ZeroVec3, ZeroVec3, ZeroVec3, ZeroVec3> no_bias_products{};

/// Bias that passes a joint: p + N zeta + K u; along the joint it is p J/D + K_s tau, which is tau without a rotor.
template <class Link, class P, class N, class K, class U, class S>
AXIAL_INLINE constexpr auto passed_bias(Revolute, const Link& link, const P& p, const N& n, const K& k, const U& u,
                                        const S& axis) {
  using namespace quantity;
  Vec3 carried{p.moment.x, p.moment.y, axis};
  Vec3 gained{k.angular.x * u, k.angular.y * u, Zero{}};
  return ForceVector{link.sum(Moment{}, carried, n.turning_moment, n.moment, gained),
                     link.sum(Force{}, p.force, n.turning_force, n.force, u * k.linear)};
}
/// Prismatic overload.
template <class Link, class P, class N, class K, class U, class S>
AXIAL_INLINE constexpr auto passed_bias(Prismatic, const Link& link, const P& p, const N& n, const K& k, const U& u,
                                        const S& axis) {
  using namespace quantity;
  Vec3 carried{p.force.x, p.force.y, axis};
  Vec3 gained{k.linear.x * u, k.linear.y * u, Zero{}};
  return ForceVector{link.sum(Moment{}, p.moment, n.turning_moment, n.moment, u * k.angular),
                     link.sum(Force{}, carried, n.turning_force, n.force, gained)};
}

/// Everything that a joint's reflection yields.
template <class I, class P, class K, class U, class B, class L>
struct Reflection {
  I inertia;   ///< N, inertia seen on the inboard side
  P bias;      ///< force seen on the inboard side
  K gain;      ///< K = U / D with K_s = I_ss / D
  U free;      ///< u / D
  B singular;  ///< D is lost in the rounding of the composite inertia
  L left;      ///< whether anything is left of D: the joint is held if not
};
template <class I, class P, class K, class U, class B, class L>
Reflection(I, P, K, U, B, L) -> Reflection<I, P, K, U, detail::Decided<B>, L>;

namespace detail {

template <class K, class KS>
AXIAL_INLINE constexpr auto gain_vector(Revolute, const K& k, const KS& axis) {
  return MotionVector{Vec3{k.angular.x, k.angular.y, axis}, k.linear};
}
template <class K, class KS>
AXIAL_INLINE constexpr auto gain_vector(Prismatic, const K& k, const KS& axis) {
  return MotionVector{k.angular, Vec3{k.linear.x, k.linear.y, axis}};
}

}  // namespace detail

/// What a joint makes of an articulated body's inertia, whatever drives it: N, D and its inverse, and K.
template <class N, class D, class R, class K, class B, class Left>
struct Hinge {
  N inertia;     ///< N, an ArticulatedInertia
  D resistance;  ///< D = I_ss + rotor, kg m^2 or kg
  R inverse;     ///< 1 / D, 0 of a joint that is held
  K gain;        ///< k = U / D with K_s = I_ss / D
  B singular;    ///< whether D is lost in the rounding of the composite inertia
  Left left;     ///< whether anything is left of D: the joint is held if not
};
template <class N, class D, class R, class K, class B, class Left>
Hinge(N, D, R, K, B, Left) -> Hinge<N, D, R, K, detail::Decided<B>, Left>;

/// Hinge of an articulated body's inertia at its joint; `scale` is what D is compared with.
template <class Joint, class Link, class I, class Scale>
AXIAL_INLINE constexpr auto hinge(Joint joint, const Link& link, const I& inertia, const Scale& scale) {
  using namespace quantity;
  auto rotor = link.rotor();
  auto own = detail::axis_inertia(joint, inertia);
  auto d = link.sum(JointInertia{}, own, rotor);
  auto [inverse, singular, left] = resistance_at(link, d, scale);
  auto column = joint_column(joint, inertia);
  MotionVector k{link.quotient(AngularGain{}, inverse, column.angular),
                 link.quotient(LinearGain{}, inverse, column.linear)};
  auto axis = detail::axis_gain(link, own, rotor, inverse);
  auto n = reflected(joint, link, inertia, column, k, axis, rotor);
  return Hinge{n, d, inverse, detail::gain_vector(joint, k, axis), singular, left};
}

namespace detail {
template <class K>
AXIAL_INLINE constexpr const auto& along_axis_of(Revolute, const K& gain) {
  return gain.angular.z;
}
template <class K>
AXIAL_INLINE constexpr const auto& along_axis_of(Prismatic, const K& gain) {
  return gain.linear.z;
}
}  // namespace detail

/// What a force p and the effort tau do at a joint: the force that passes, and u / D.
template <class P, class U>
struct JointTransmission {
  P bias;  ///< N m and N, on the inboard side
  U free;  ///< u / D, rad/s^2 or m/s^2
};
template <class P, class U>
JointTransmission(P, U) -> JointTransmission<P, U>;

/// Across a joint that is held all of p passes, and u / D is 0. Sets `lost` where u / 2^magnified is beyond what
/// formats are made for.
template <class Joint, class Link, class H, class N, class P, class Tau, class M, class B>
AXIAL_INLINE constexpr auto passage(Joint joint, const Link& link, const H& hinge, const N& products, const P& p,
                                    const Tau& tau, M magnified, B& lost) {
  using namespace quantity;
  auto held = along_joint(joint, p);
  auto axis = detail::along_axis_of(joint, hinge.gain);
  auto u = link.gated_drive(lost, hinge.resistance, link.sum(JointEffort{}, tau, -held), magnified);
  auto across = link.sum(JointEffort{}, link.quotient(AngularGain{}, hinge.inverse, link.rotor()) * held, axis * tau);
  auto passed = where_left<decltype(across)>(hinge.left, across, held);
  return JointTransmission{passed_bias(joint, link, p, products, hinge.gain, u, passed),
                           link.quotient(JointAcceleration{}, hinge.inverse, u)};
}

/// Reflection of an articulated body (inertia, bias p) across its joint, driven by the effort tau; D = I_ss + rotor.
template <class Joint, class Link, class I, class P, class Z, class Tau, class Scale>
AXIAL_INLINE constexpr auto reflection(Joint joint, const Link& link, const I& inertia, const P& p, const Z& zeta,
                                       const Tau& tau, const Scale& scale) {
  auto h = hinge(joint, link, inertia, scale);
  Truth<typename Link::Scalar> lost = h.singular;
  auto passed = passage(joint, link, h, bias_products(h.inertia, zeta), p, tau, Zero{}, lost);
  return Reflection{h.inertia, passed.bias, h.gain, passed.free, lost, h.left};
}

/// K . a, the part of a motion that the joint's inertia answers.
template <class K, class M>
AXIAL_INLINE constexpr auto gain_times(const K& k, const M& motion) {
  return dot(k.angular, motion.angular) + dot(k.linear, motion.linear);
}

/// Acceleration of a joint whose link's inboard side moves so: u / D - K . a; 0 of a joint that is held. Sets `lost`
/// where the format is too small for it.
template <class Link, class U, class K, class M, class Left, class B>
AXIAL_INLINE constexpr auto joint_acceleration(const Link& link, const U& free, const K& gain, const M& motion,
                                               Left left, B& lost) {
  auto own = link.limited(quantity::JointAcceleration{}, lost, free, -gain_times(gain, motion));
  return where_left<decltype(own)>(left, own, Zero{});
}

}  // namespace axial

#include <axial/options/end.hpp>
