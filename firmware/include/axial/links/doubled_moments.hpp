// Moments of a link's mass, doubled, as products of speeds need them.
#pragma once

#include <axial/links/link_view.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Twice the moments of a body's mass: mass (kg), first moment (kg m) and second moments, the integral of r r^T dm (kg
/// m^2), a Sym3: tr(J) 1 - 2 J.
template <class M, class H, class S>
struct DoubledMoments {
  M mass{};    ///< 2 m
  H first{};   ///< 2 m c
  S second{};  ///< 2 integral of r r^T dm
};
template <class M, class H, class S>
DoubledMoments(M, H, S) -> DoubledMoments<M, H, S>;

/// Doubled moments of a body. Speeds of an axial mass along its axis turn nothing that feels it: none.
template <class M, class H, class J>
AXIAL_INLINE constexpr auto doubled_moments(const RigidInertia<M, H, J>& body) {
  const auto& mass = mass_across_z(body.mass);
  const auto& h = body.first_moment;
  const auto& j = body.inertia;
  return DoubledMoments{
      mass + mass, h + h,
      Sym3{j.yy + j.zz - j.xx, j.xx + j.zz - j.yy, j.xx + j.yy - j.zz, -(j.xy + j.xy), -(j.xz + j.xz), -(j.yz + j.yz)}};
}

namespace detail {

// A negative constant by its absolute value: links whose moments balance have products but for a sign twice.
template <class X>
struct Negative {
  X absolute{};
};
template <class A, class X>
AXIAL_INLINE constexpr auto operator*(const A& a, const Negative<X>& x) {
  return -(a * x.absolute);
}
template <class X>
Negative(X) -> Negative<X>;
template <class T, class Constants, Member<double> M>
AXIAL_INLINE constexpr auto twice_constant() {
  return literal<T>([] { return 2.0 * (Constants::of().*M); });
}
template <class Constants, Member<double> A, Member<double> B, Member<double> C>
constexpr double second_moment() {
  return Constants::of().*A + Constants::of().*B - Constants::of().*C;
}
template <class T, class Constants, Member<double> A, Member<double> B, Member<double> C>
AXIAL_INLINE constexpr auto second_moment_constant() {
  if constexpr (second_moment<Constants, A, B, C>() < 0.0)
    return Negative{literal<T>([] { return -second_moment<Constants, A, B, C>(); })};
  else
    return literal<T>([] { return second_moment<Constants, A, B, C>(); });
}
template <class T, class Constants, bool axial>
AXIAL_INLINE constexpr auto twice_mass() {
  if constexpr (axial)
    return Zero{};
  else
    return twice_constant<T, Constants, &LinkConstants<double>::mass>();
}
template <class T, class Constants, bool axial_mass>
AXIAL_INLINE constexpr auto twice_of_link() {
  using C = LinkConstants<double>;
  return DoubledMoments{
      twice_mass<T, Constants, axial_mass>(),
      Vec3{twice_constant<T, Constants, &C::hx>(), twice_constant<T, Constants, &C::hy>(),
           twice_constant<T, Constants, &C::hz>()},
      Sym3{second_moment_constant<T, Constants, &C::jyy, &C::jzz, &C::jxx>(),
           second_moment_constant<T, Constants, &C::jxx, &C::jzz, &C::jyy>(),
           second_moment_constant<T, Constants, &C::jxx, &C::jyy, &C::jzz>(), -twice_constant<T, Constants, &C::jxy>(),
           -twice_constant<T, Constants, &C::jxz>(), -twice_constant<T, Constants, &C::jyz>()}};
}
template <class Robot, class Parameters, int I>
struct ConstantsOfLink {
  static constexpr const auto& of() { return robot_constants<Robot, Parameters>.links[I]; }
};

// x / 2, of a constant that is a type, too.
template <class T, class X>
AXIAL_INLINE constexpr auto halved(const X& x) {
  if constexpr (is_structural_v<X> && !is_zero_v<X>)
    return literal<T>([] { return 0.5 * X::value; });
  else
    return half(x);
}

}  // namespace detail

/// Doubled moments of a link that the compiler knows: constants, too.
template <class Scene, int I, class T, class Parameters, class Rounder>
AXIAL_INLINE constexpr auto doubled_moments(const StaticLink<Scene, I, T, Parameters, Rounder>&) {
  using Constants = detail::ConstantsOfLink<typename Scene::Robot, Parameters, I>;
  return detail::twice_of_link<T, Constants, StaticLink<Scene, I, T, Parameters, Rounder>::has_axial_mass>();
}
/// Doubled moments of a body that a link bears. Where results have formats each second moment is rounded as half of
/// what it says: that has room where an inertia has.
template <class Link, class M, class H, class J>
AXIAL_INLINE constexpr auto doubled_moments(const Link& link, const RigidInertia<M, H, J>& body) {
  if constexpr (Link::ranged) {
    const auto& h = body.first_moment;
    const auto& j = body.inertia;
    using T = typename Link::Scalar;
    const auto about = [&](const auto& a, const auto& b, const auto& c) AXIAL_INLINE {
      using detail::halved;
      return twice(link.sum(quantity::RotationalInertia{}, halved<T>(a), halved<T>(b), -halved<T>(c)));
    };
    return DoubledMoments{twice(body.mass), Vec3{twice(h.x), twice(h.y), twice(h.z)},
                          Sym3{about(j.yy, j.zz, j.xx), about(j.xx, j.zz, j.yy), about(j.xx, j.yy, j.zz), -twice(j.xy),
                               -twice(j.xz), -twice(j.yz)}};
  } else {
    return doubled_moments(body);
  }
}
/// Doubled moments of any other view of a link.
template <class Link>
AXIAL_INLINE constexpr auto doubled_moments(const Link& link) -> decltype(doubled_moments(link.body())) {
  return doubled_moments(link.body());
}

}  // namespace axial

#include <axial/options/end.hpp>
