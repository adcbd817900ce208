// How the axes of joints move: what derivatives of inverse dynamics need besides the links' motions.
#pragma once

#include <axial/derivatives/derivative_rounding.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// How the frame moves in which joint i finds its axis: behind the x-screw, before the joint's own turn and shift. Its
/// rotation is the parent's; of U it holds the third column alone, which the joint does not change either.
template <class W, class V, class A, class U>
struct AxisFrame {
  W w{};       ///< rad/s
  V v{};       ///< m/s, of its origin
  A a{};       ///< m/s^2, of its origin, against gravity
  U column{};  ///< rad^2/s^2 and rad/s^2: U's third column
  /// This frame as numbers, each quantity in the form in which T keeps it.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return derivatives::AxisFrame{w.template dense<Kept<T, quantity::AngularVelocity>>(),
                                  v.template dense<Kept<T, quantity::LinearVelocity>>(),
                                  a.template dense<Kept<T, quantity::LinearAcceleration>>(),
                                  column.template dense<Kept<T, quantity::AngularAcceleration>>()};
  }
};
template <class W, class V, class A, class U>
AxisFrame(W, V, A, U) -> AxisFrame<W, V, A, U>;

/// by_parent(axis) where the joint's axis is one of the parent's, known to the compiler, else by_link().
template <class Axis, class ByParent, class ByLink>
AXIAL_INLINE constexpr auto axis_column(const Axis& axis, const ByParent& by_parent, const ByLink& by_link) {
  if constexpr (is_structural_vector<Axis>)
    return by_parent(axis);
  else
    return by_link();
}
/// U's third column: how points of the z axis accelerate, relative to one another.
template <class U>
AXIAL_INLINE constexpr auto third_column(const U& u) {
  return Vec3{u.x.z, u.y.z, u.z.z};
}

/// The frame behind the x-screw of a link, from the motion of its parent and the velocity of the parent's origin. The
/// joint does not change how points of its axis accelerate: where the axis is one of the parent's, that is a column of
/// the parent's U, else the link's own is turned back.
template <class Link, class Screw, class P, class V, class M>
AXIAL_INLINE constexpr auto axis_frame(const Link& link, const Screw& screw, const P& parent, const V& velocity,
                                       const M& own) {
  using namespace quantity;
  auto x = link.x();
  auto column = axis_column(
      axis_in_parent(x), [&](const auto& axis) AXIAL_INLINE { return to_child(x, parent.u * axis); },
      [&]() AXIAL_INLINE { return to_parent(screw, third_column(own.u)); });
  auto v = link.sum(LinearVelocity{}, velocity, cross(parent.w, translation(x)));
  auto a = link.sum(LinearAcceleration{}, parent.a, parent.u * translation(x));
  return AxisFrame{to_child(x, parent.w), to_child(x, v), to_child(x, a), column};
}

/// Velocity of a link's origin in its own axes, m/s.
template <class Link, class Screw, class F, class M, class V>
AXIAL_INLINE constexpr auto origin_velocity(Revolute, const Link& link, const Screw& screw, const F& frame,
                                            const M& motion, const V&) {
  return link.sum(quantity::LinearVelocity{}, to_child(screw, frame.v), cross_z(motion.w, screw.shift));
}
/// Prismatic overload: the link moves along its axis.
template <class Link, class Screw, class F, class M, class V>
AXIAL_INLINE constexpr auto origin_velocity(Prismatic, const Link& link, const Screw& screw, const F& frame,
                                            const M& motion, const V& qd) {
  return link.sum(quantity::LinearVelocity{}, to_child(screw, frame.v), cross_z(motion.w, screw.shift), along_z(qd));
}

/// Velocity of the axis' frame from that of the link's origin: the inverse of origin_velocity().
template <class Joint, class Screw, class F, class O, class V>
AXIAL_INLINE constexpr auto axis_velocity(Joint, const Screw& screw, const F& frame, const O& origin, const V& qd) {
  auto turned = to_parent(screw, origin) - cross_z(frame.w, screw.shift);
  if constexpr (std::is_same_v<Joint, Prismatic>)
    return turned - along_z(qd);
  else
    return turned;
}

/// A joint's frame and the velocity of its link's origin.
template <class F, class V>
struct Passage {
  F frame{};   ///< an AxisFrame
  V origin{};  ///< m/s
  /// This passage as numbers, each quantity in the form in which T keeps it.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return derivatives::Passage{frame.template dense<T>(), origin.template dense<Kept<T, quantity::LinearVelocity>>()};
  }
};
template <class F, class V>
Passage(F, V) -> Passage<F, V>;

/// Whether what the compiler knows of the first links may be left out. Where ranges are proved, the proof is of the
/// same for all links.
template <class Links>
inline constexpr bool knows_first_links =
    Links::unrolled && !std::decay_t<decltype(std::declval<const Links&>().link(Index<0>{}))>::ranged;

/// Whether velocities are taken relative to where the origin of link 1 is at the moment, for more of them are zero
/// then: of a chain that the compiler knows. Nothing that is computed depends on it (Galilei).
template <class Links>
constexpr bool rests_at_link_1() {
  bool serial = knows_first_links<Links> && Links::capacity > 1;
  if constexpr (Links::unrolled)
    for (int i = 0; i < Links::capacity; ++i)
      serial = serial && Links::parent_index(i) == i - 1;
  return serial;
}

/// Passage of link 1 whose origin is at rest.
template <class Link, class Screw, class P, class M, class V>
AXIAL_INLINE constexpr auto passage_at_rest(const Link& link, const Screw& screw, const P& parent, const M& own,
                                            const V& qd) {
  auto frame = axis_frame(link, screw, parent, ZeroVec3{}, own);
  return link.on_joint([&](auto joint) AXIAL_INLINE {
    auto v = axis_velocity(joint, screw, frame, ZeroVec3{}, qd);
    return Passage{AxisFrame{frame.w, v, frame.a, frame.column}, ZeroVec3{}};
  });
}
/// Passage of a joint on the base that the compiler knows: its link's own frame, so that nothing is carried any
/// farther.
template <class M, class V>
AXIAL_INLINE constexpr auto passage_of_root(const M& motion, const V& origin) {
  return Passage{AxisFrame{motion.w, origin, motion.a, third_column(motion.u)}, origin};
}
/// Whether the joint's frame is that of its link, not the one behind the x-screw.
template <class Links, class I>
AXIAL_INLINE constexpr auto is_known_root(I) {
  if constexpr (knows_first_links<Links>)
    return std::bool_constant<(Links::template parent_of<I::value> < 0)>{};
  else
    return std::false_type{};
}
/// Brings x from a link's frame to that of its joint.
template <class Links, class Screws, class I, class X, class... Rounder>
AXIAL_INLINE constexpr auto to_axis(const Links&, const Screws& screws, I i, const X& x, const Rounder&... round) {
  using axial::to_parent;
  if constexpr (decltype(is_known_root<Links>(i))::value)
    return x;
  else
    return to_parent(screws[i], x, round...);
}

/// Passages of all links, from the base outwards.
template <class Links, class Input, class Screws, class Motions, class V>
AXIAL_INLINE constexpr auto passages(const Links& links, const Input& in, const Screws& screws, const Motions& motions,
                                     const V& qd) {
  auto next = [&](auto i, const auto& parent, const auto& velocity) AXIAL_INLINE {
    auto link = links.link(i);
    auto frame = axis_frame(link, screws[i], parent, velocity, motions[i]);
    return link.on_joint([&](auto joint) AXIAL_INLINE {
      return link.shape(Passage{frame, origin_velocity(joint, link, screws[i], frame, motions[i], qd[i])});
    });
  };
  auto base = rnea::base(links, in);
  auto still = no_motion(links);
  if constexpr (Links::unrolled) {
    const Index<(Links::capacity > 1 ? 1 : 0)> resting;  // there is one, for who compiles what nobody calls
    auto rest = [&](auto i) AXIAL_INLINE {
      return passage_at_rest(links.link(i), screws[i], motions[Index<0>{}], motions[i], qd[i]);
    };
    return outward(links, Passage{still, still}, [&](auto i, const auto& parent) AXIAL_INLINE {
      constexpr int of = Links::template parent_of<decltype(i)::value>;
      if constexpr (rests_at_link_1<Links>() && decltype(i)::value == 1) {
        return rest(i);
      } else if constexpr (rests_at_link_1<Links>() && of < 0) {
        auto x = links.link(resting).x();
        return passage_of_root(motions[i], to_parent(x, rest(resting).frame.v) - cross(motions[i].w, translation(x)));
      } else if constexpr (knows_first_links<Links> && of < 0) {
        return passage_of_root(motions[i], next(i, base, parent.origin).origin);
      } else if constexpr (of < 0) {
        return next(i, base, parent.origin);
      } else {
        return next(i, motions[Index<of>{}], parent.origin);
      }
    });
  } else {
    using Dense = typename Links::Dense;
    const Passage root{AxisFrame{still, still, still, still}, still};  // of which the origin is read
    return outward(links, root, [&](auto i, const auto& parent) AXIAL_INLINE {
      const int of = links.parent_index(i);
      return next(i, of < 0 ? base.template dense<Dense>() : motions[of], parent.origin);
    });
  }
}

/// How a joint's axis moves: psi = d(phi)/dt, its double, and the part of its second derivative that no joint value's
/// own change makes.
template <class P, class D, class A>
struct AxisMotion {
  P first{};    ///< psi, 1/s
  D doubled{};  ///< 2 psi
  A second{};   ///< 1/s^2
  /// This motion as numbers, in the forms in which T keeps how a turning joint's axis moves; a slide's is kept in the
  /// same.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    using namespace quantity;
    return derivatives::AxisMotion{MotionVector{first.angular.template dense<Kept<T, AngularVelocity>>(),
                                                first.linear.template dense<Kept<T, LinearVelocity>>()},
                                   MotionVector{doubled.angular.template dense<KeptTwice<T, AngularVelocity>>(),
                                                doubled.linear.template dense<KeptTwice<T, LinearVelocity>>()},
                                   MotionVector{second.angular.template dense<Kept<T, AngularAcceleration>>(),
                                                second.linear.template dense<Kept<T, AxisAcceleration>>()}};
  }
};
template <class P, class D, class A>
AxisMotion(P, D, A) -> AxisMotion<P, D, A>;

/// u x z.
template <class U>
AXIAL_INLINE constexpr auto across(const U& u) {
  return Vec3{u.y, -u.x, Zero{}};
}
/// 2 x of a vector.
template <class X, class Y, class Z>
AXIAL_INLINE constexpr auto doubled(const Vec3<X, Y, Z>& v) {
  return Vec3{twice(v.x), twice(v.y), twice(v.z)};
}
/// Revolute overload.
template <class Link, class F>
AXIAL_INLINE constexpr auto axis_motion(Revolute, const Link& link, const F& frame) {
  const MotionVector first{across(frame.w), across(frame.v)};
  const MotionVector twofold{doubled(first.angular), doubled(first.linear)};
  auto second = link.sum(quantity::AxisAcceleration{}, across(frame.a), cross(frame.v, twofold.angular));
  return AxisMotion{first, twofold, MotionVector{frame.column, second}};
}
/// Prismatic overload: the axis only turns.
template <class Link, class F>
AXIAL_INLINE constexpr auto axis_motion(Prismatic, const Link&, const F& frame) {
  const MotionVector first{ZeroVec3{}, across(frame.w)};
  return AxisMotion{first, MotionVector{ZeroVec3{}, doubled(first.linear)}, MotionVector{ZeroVec3{}, frame.column}};
}

}  // namespace derivatives
}  // namespace axial

#include <axial/options/end.hpp>
