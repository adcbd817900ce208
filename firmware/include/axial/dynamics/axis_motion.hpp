// How the axes of joints move: what derivatives of inverse dynamics need besides the links' motions.
#pragma once

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
  /// The same as numbers.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return derivatives::AxisFrame{w.template dense<T>(), v.template dense<T>(), a.template dense<T>(),
                                  column.template dense<T>()};
  }
};
template <class W, class V, class A, class U>
AxisFrame(W, V, A, U) -> AxisFrame<W, V, A, U>;

/// Behind the x-screw of a link, from the motion of its parent and the velocity of the parent's origin.
template <class X, class M, class V>
AXIAL_INLINE constexpr auto axis_frame(const X& x, const M& parent, const V& velocity) {
  return AxisFrame{to_child(x, parent.w), to_child(x, velocity + cross(parent.w, translation(x))),
                   to_child(x, parent.a + parent.u * translation(x)), to_child(x, parent.u * axis_in_parent(x))};
}

/// Velocity of a link's origin in its own axes, m/s.
template <class Joint, class Screw, class F, class M, class V>
AXIAL_INLINE constexpr auto origin_velocity(Joint, const Screw& screw, const F& frame, const M& motion, const V& qd) {
  auto turned = to_child(screw, frame.v) + cross_z(motion.w, screw.shift);
  if constexpr (std::is_same_v<Joint, Prismatic>)
    return turned + along_z(qd);
  else
    return turned;
}

/// The same the other way round: velocity of the axis' frame from that of the link's origin.
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
  /// The same as numbers.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return derivatives::Passage{frame.template dense<T>(), origin.template dense<T>()};
  }
};
template <class F, class V>
Passage(F, V) -> Passage<F, V>;

/// Whether velocities are taken relative to where the origin of link 1 is at the moment, for more of them are zero
/// then: of a chain that the compiler knows. Nothing that is computed depends on it (Galilei).
template <class Links>
constexpr bool rests_at_link_1() {
  bool serial = Links::unrolled && Links::capacity > 1;
  if constexpr (Links::unrolled)
    for (int i = 0; i < Links::capacity; ++i)
      serial = serial && Links::parent_index(i) == i - 1;
  return serial;
}

/// Of link 1 at rest.
template <class Link, class Screw, class M, class V>
AXIAL_INLINE constexpr auto passage_at_rest(const Link& link, const Screw& screw, const M& parent, const V& qd) {
  auto frame = axis_frame(link.x(), parent, ZeroVec3{});
  return link.on_joint([&](auto joint) AXIAL_INLINE {
    auto v = axis_velocity(joint, screw, frame, ZeroVec3{}, qd);
    return Passage{AxisFrame{frame.w, v, frame.a, frame.column}, ZeroVec3{}};
  });
}
/// Of a joint on the base that the compiler knows: its link's own frame, so that nothing is carried any farther.
template <class M, class V>
AXIAL_INLINE constexpr auto passage_of_root(const M& motion, const V& origin) {
  const auto& u = motion.u;
  return Passage{AxisFrame{motion.w, origin, motion.a, Vec3{u.x.z, u.y.z, u.z.z}}, origin};
}
/// Whether the joint's frame is that of its link, not the one behind the x-screw.
template <class Links, class I>
AXIAL_INLINE constexpr auto is_known_root(I) {
  if constexpr (Links::unrolled)
    return std::bool_constant<(Links::template parent_of<I::value> < 0)>{};
  else
    return std::false_type{};
}
/// From a link's frame to that of its joint.
template <class Links, class Screws, class I, class X>
AXIAL_INLINE constexpr auto to_axis(const Links&, const Screws& screws, I i, const X& x) {
  using axial::to_parent;
  if constexpr (decltype(is_known_root<Links>(i))::value)
    return x;
  else
    return to_parent(screws[i], x);
}

/// Those of all links, from the base outwards.
template <class Links, class Input, class Screws, class Motions, class V>
AXIAL_INLINE constexpr auto passages(const Links& links, const Input& in, const Screws& screws, const Motions& motions,
                                     const V& qd) {
  auto next = [&](auto i, const auto& parent, const auto& velocity) AXIAL_INLINE {
    auto link = links.link(i);
    auto frame = axis_frame(link.x(), parent, velocity);
    return link.on_joint([&](auto joint) AXIAL_INLINE {
      return link.shape(Passage{frame, origin_velocity(joint, screws[i], frame, motions[i], qd[i])});
    });
  };
  auto base = rnea::base(links, in);
  if constexpr (Links::unrolled) {
    const Index<1> resting;
    auto rest = [&](auto i)
                    AXIAL_INLINE { return passage_at_rest(links.link(i), screws[i], motions[Index<0>{}], qd[i]); };
    return outward(links, Passage{ZeroVec3{}, ZeroVec3{}}, [&](auto i, const auto& parent) AXIAL_INLINE {
      constexpr int of = Links::template parent_of<decltype(i)::value>;
      if constexpr (rests_at_link_1<Links>() && decltype(i)::value == 1) {
        return rest(i);
      } else if constexpr (rests_at_link_1<Links>() && of < 0) {
        auto x = links.link(resting).x();
        return passage_of_root(motions[i], to_parent(x, rest(resting).frame.v) - cross(motions[i].w, translation(x)));
      } else if constexpr (of < 0) {
        return passage_of_root(motions[i], next(i, base, parent.origin).origin);
      } else {
        return next(i, motions[Index<of>{}], parent.origin);
      }
    });
  } else {
    using Dense = typename Links::Dense;
    const Passage root{axis_frame(links.link(0).x(), base, ZeroVec3{}), ZeroVec3{}};  // of which the origin is read
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
  /// The same as numbers.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return derivatives::AxisMotion{first.template dense<T>(), doubled.template dense<T>(), second.template dense<T>()};
  }
};
template <class P, class D, class A>
AxisMotion(P, D, A) -> AxisMotion<P, D, A>;

/// u x z.
template <class U>
AXIAL_INLINE constexpr auto across(const U& u) {
  return Vec3{u.y, -u.x, Zero{}};
}
/// Of a revolute joint.
template <class F>
AXIAL_INLINE constexpr auto axis_motion(Revolute, const F& frame) {
  const MotionVector first{across(frame.w), across(frame.v)};
  const auto doubled = first + first;
  return AxisMotion{first, doubled, MotionVector{frame.column, across(frame.a) + cross(frame.v, doubled.angular)}};
}
/// Of a prismatic joint, whose axis only turns.
template <class F>
AXIAL_INLINE constexpr auto axis_motion(Prismatic, const F& frame) {
  const MotionVector first{ZeroVec3{}, across(frame.w)};
  return AxisMotion{first, first + first, MotionVector{ZeroVec3{}, frame.column}};
}

}  // namespace derivatives
}  // namespace axial

#include <axial/options/end.hpp>
