// What resists a joint's drive, D, and its inverse: lost in rounding or not, known to the compiler where that can be.
#pragma once

#include <axial/links/link_view.hpp>
#include <axial/recursion/composite_scale.hpp>
#include <axial/scene/status.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Composite inertia that a joint's D is compared with: about the axis (bounded by the polar moment), or the mass.
AXIAL_INLINE constexpr Unscaled singularity_scale(Revolute, Unscaled) { return {}; }
AXIAL_INLINE constexpr Unscaled singularity_scale(Prismatic, Unscaled) { return {}; }  ///< nor of a slide
/// Revolute overload, kg m^2.
template <class R>
AXIAL_INLINE constexpr auto singularity_scale(Revolute, const R& scale) {
  return scale.polar;
}
/// Prismatic overload, kg.
template <class R>
AXIAL_INLINE constexpr auto singularity_scale(Prismatic, const R& scale) {
  return scale.mass;
}

namespace detail {

// Whether no body with that inertia about its centre of mass resists a turn or a shift with less than nothing.
constexpr bool resists_every_way(const LinkParameters& p) {
  const double(&j)[6] = p.inertia_com;
  const double xy = j[0] * j[1] - j[3] * j[3], xz = j[0] * j[2] - j[4] * j[4], yz = j[1] * j[2] - j[5] * j[5];
  const double determinant = j[0] * yz - j[3] * (j[3] * j[2] - j[4] * j[5]) + j[4] * (j[3] * j[5] - j[1] * j[4]);
  return p.mass >= 0.0 && j[0] >= 0.0 && j[1] >= 0.0 && j[2] >= 0.0 && xy >= 0.0 && xz >= 0.0 && yz >= 0.0 &&
         determinant >= 0.0;
}

/// For each joint, what its own link and rotor resist with as a share of a bound of the composite inertia; 0 where that
/// is not known at compile time: a payload, water, a slide that moves masses away from an axis, an inertia that no body
/// has.
template <int N>
struct OwnShares {
  double of[N] = {};
};
template <class Scene>
constexpr auto own_shares() {
  using Robot = typename Scene::Robot;
  constexpr int n = Robot::chain.size;
  OwnShares<n> shares;
  if (Scene::template has<Payload> || Scene::template has<Underwater>) return shares;
  const auto& links = robot_constants<Robot>.links;
  CompositeScale<double, double, double> carried[n] = {};
  bool known[n] = {};
  for (int i = 0; i < n; ++i)
    known[i] = true;
  for (int i = n; i-- > 0;) {
    const auto& c = links[i];
    carried[i] = carried[i] + composite_scale(RigidInertia{c.mass, Vec3<double>{c.hx, c.hy, c.hz},
                                                           Sym3<double>{c.jxx, c.jyy, c.jzz, 0.0, 0.0, 0.0}});
    known[i] = known[i] && resists_every_way(Robot::chain.links[i]);
    const double rotor = Scene::template has<RotorInertia> ? c.rotor : 0.0;
    const double all = (c.prismatic ? carried[i].mass : carried[i].polar) + rotor;
    if (known[i] && all > 0.0) shares.of[i] = ((c.prismatic ? c.mass : c.jzz) + rotor) / all;
    if (c.parent < 0) continue;
    known[c.parent] = known[c.parent] && known[i] && (!c.prismatic || turns_along_slide(links, i));
    carried[c.parent] =
        carried[c.parent] + seen_from(carried[i], magnitude(c.branch.b) + magnitude(c.a) + magnitude(c.d));
  }
  return shares;
}
template <class Scene>
inline constexpr auto own_shares_of = own_shares<Scene>();

// A joint whose own share is larger than this is never near singular over numbers T.
template <class T>
inline constexpr double sufficient_share = 64.0 * static_cast<double>(std::numeric_limits<float>::epsilon());
template <>
inline constexpr double sufficient_share<double> = 64.0 * std::numeric_limits<double>::epsilon();

/// Whether a link's joint is never near singular over the link's numbers: what is articulated lies between the link's
/// own inertia and the composite one.
template <class Link>
struct AlwaysResists : std::false_type {};
template <class Scene, int I, class T, class Parameters>
struct AlwaysResists<StaticLink<Scene, I, T, Parameters, Plain>>
    : std::bool_constant<!Scene::template has<RotorDynamics> &&
                         (own_shares_of<Scene>.of[I] > sufficient_share<Lane<T>>)> {};

}  // namespace detail

/// 1/D, and what is left of D in the rounding of the composite inertia that it was subtracted from. Where that is known
/// at compile time, both are types and cost nothing.
template <class R, class Singular, class Left>
struct Resistance {
  R inverse;          ///< 1 / D; 0 where nothing is left of D
  Singular singular;  ///< whether D is lost in rounding, though it may be solved for
  Left left;          ///< whether anything is left of D; a joint without is held
};
template <class R, class Singular, class Left>
Resistance(R, Singular, Left) -> Resistance<R, Singular, Left>;

/// In floating point: D below 16 eps times the composite inertia `scale` is singular; where not even eps^2 of it is
/// left, 1/D is taken as 0, so that the result stays finite. Both are selected, not branched on. Number systems that
/// know a lower bound of D overload it.
template <class T, class Scale>
AXIAL_INLINE constexpr auto resistance(const T& d, const Scale& scale) {
  const T eps = NumberTraits<T>::epsilon();
  const auto left = d > T(eps * eps * scale);
  return Resistance{select(left, reciprocal(d), T(Zero{})), !(d > T(T(Int<16>{}) * eps * scale)), left};
}

/// Resistance of a slide that carries one kilogram, known to the compiler.
template <class Scale>
AXIAL_INLINE constexpr auto resistance(One, const Scale&) {
  return Resistance{One{}, std::false_type{}, std::true_type{}};
}

/// Resistance of a joint that nothing resists by structure: a slide between masses and the parent, all along one
/// direction. It is held.
template <class Scale>
AXIAL_INLINE constexpr auto resistance(Zero, const Scale&) {
  return Resistance{Zero{}, std::true_type{}, std::false_type{}};
}

/// Resistance of a link's joint: nothing is compared where the compiler knows that the joint always resists.
template <class Link, class D, class Scale>
AXIAL_INLINE constexpr auto resistance_at(const Link&, const D& d, const Scale& scale) {
  if constexpr (detail::AlwaysResists<Link>::value && is_number_v<D>)
    return Resistance{reciprocal(d), std::false_type{}, std::true_type{}};
  else
    return resistance(d, scale);
}

/// `yes` where something is left of D, else `no`: by type where the compiler knows, else as numbers T.
template <class T, class Yes, class No>
AXIAL_INLINE constexpr Yes where_left(std::true_type, const Yes& yes, const No&) {
  return yes;
}
/// Overload where the compiler knows that nothing is left.
template <class T, class Yes, class No>
AXIAL_INLINE constexpr No where_left(std::false_type, const Yes&, const No& no) {
  return no;
}
/// Overload that selects at run time.
template <class T, class Left, class Yes, class No>
AXIAL_INLINE constexpr T where_left(Left left, const Yes& yes, const No& no) {
  return select(left, T(yes), T(no));
}

}  // namespace axial

#include <axial/options/end.hpp>
