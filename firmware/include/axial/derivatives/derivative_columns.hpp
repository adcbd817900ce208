// What a joint's acceleration, speed and position do to all that it carries, and to the joints inboard of it.
#pragma once

#include <axial/derivatives/axis_motion.hpp>
#include <axial/derivatives/mass_flow.hpp>
#include <axial/dynamics/mass_matrix.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// All that a joint carries, about the origin of its link's frame.
template <class B, class W, class F>
struct Subtree {
  B body{};   ///< a RigidInertia
  W flow{};   ///< a MassFlow
  F force{};  ///< what moves it, N m and N
  /// This subtree as numbers.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return derivatives::Subtree{body.template dense<T>(), flow.template dense<T>(), force.template dense<T>()};
  }
};
template <class B, class W, class F>
Subtree(B, W, F) -> Subtree<B, W, F>;
/// A subtree as the links inboard feel it.
template <class B, class W, class F>
AXIAL_INLINE constexpr auto inboard_part(const Subtree<B, W, F>& t) {
  return Subtree{axial::inboard_part(t.body), t.flow, t.force};
}
/// Two subtrees of one frame as one.
template <class A, class B, class C, class D, class E, class F>
AXIAL_INLINE constexpr auto operator+(const Subtree<A, B, C>& a, const Subtree<D, E, F>& b) {
  return Subtree{a.body + b.body, a.flow + b.flow, a.force + b.force};
}

/// A body about the origin of the parent's frame, in its axes: without step A of the congruence, where nothing asks for
/// one rounding.
template <class Axis, class C, class S, class L, class Turn, class M, class H, class J, class Rounder>
AXIAL_INLINE constexpr auto carried_body(const AxialScrew<Axis, C, S, L, Turn>& x, const RigidInertia<M, H, J>& body,
                                         const Rounder& round) {
  using axial::to_parent;
  if constexpr (Rounder::ranged) {
    return to_parent(x, body, round);
  } else {
    const RigidInertia turned{body.mass, to_parent(x, body.first_moment),
                              Axis::out(detail::turned_tensor(x, Axis::in(body.inertia)))};
    const AxialScrew<Axis, One, Zero, L> shift{One{}, Zero{}, x.shift};
    return to_parent(shift, turned);
  }
}
/// Overload for a body that is known by other than its entries.
template <class Screw, class B, class Rounder>
AXIAL_INLINE constexpr auto carried_body(const Screw& x, const B& body, const Rounder& round) {
  using axial::to_parent;
  return to_parent(x, body, round);
}
/// A subtree about the origin of the parent's frame, in its axes.
template <class Axis, class C, class S, class L, class Turn, class B, class W, class F, class Rounder = Plain>
AXIAL_INLINE constexpr auto to_parent(const AxialScrew<Axis, C, S, L, Turn>& x, const Subtree<B, W, F>& t,
                                      const Rounder& round = {}) {
  using axial::to_parent;
  return Subtree{carried_body(x, t.body, round), to_parent(x, t.flow, round), to_parent(x, t.force, round)};
}

/// Force that gives a rigid body the motion m about its frame, without products of speeds: I m.
template <class B, class M>
AXIAL_INLINE constexpr auto inertial_force(const B& body, const M& m) {
  const auto& h = body.first_moment;
  return ForceVector{body.inertia * m.angular + cross(h, m.linear), body.mass * m.linear + cross(m.angular, h)};
}
/// phi x* F: how a force turns, or its moment grows, with the joint.
template <class F>
AXIAL_INLINE constexpr auto turned_force(Revolute, const F& f) {
  return ForceVector{-across(f.moment), -across(f.force)};
}
/// Prismatic overload.
template <class F>
AXIAL_INLINE constexpr auto turned_force(Prismatic, const F& f) {
  return ForceVector{-across(f.force), ZeroVec3{}};
}

/// What joint k sends inwards: the forces of one unit of its acceleration, speed and position on all that it carries,
/// and its row of the Coriolis matrix.
template <class F, class B, class U, class T>
struct Columns {
  F acceleration{};  ///< I phi
  B row{};           ///< b
  U speed{};         ///< B phi + 2 I psi
  T position{};      ///< B psi + I d(psi)/dt + phi x* F
  /// These columns as numbers, each quantity in the form in which N keeps it; a slide's row as a turning joint's.
  template <class N>
  AXIAL_INLINE constexpr auto dense() const {
    using namespace quantity;
    return derivatives::Columns{
        dense_force<N, UnitMoment, UnitForce>(acceleration), row.template dense<Kept<N, FlowMoment>>(),
        dense_force<N, FlowMoment, FlowMomentum>(speed), dense_force<N, PositionMoment, PositionForce>(position)};
  }
};
template <class F, class B, class U, class T>
Columns(F, B, U, T) -> Columns<F, B, U, T>;

/// Columns of a joint, from its axis' motion and what it carries.
template <class Joint, class Link, class S, class M>
AXIAL_INLINE constexpr auto columns_of(Joint joint, const Link& link, const S& carried, const M& axis) {
  using namespace quantity;
  using crba::unit_force;
  auto speed = sum_of<FlowMoment, FlowMomentum>(link, unit_flow_force(joint, carried.flow),
                                                inertial_force(carried.body, axis.doubled));
  auto position = sum_of<PositionMoment, PositionForce>(link, flow_force(carried.flow, axis.first.angular),
                                                        inertial_force(carried.body, axis.second),
                                                        turned_force(joint, carried.force));
  return Columns{unit_force(joint, carried.body), joint_row(joint, carried.flow), speed, position};
}
/// Columns one screw farther in.
template <class Axis, class C, class S, class L, class Turn, class F, class B, class U, class T, class Rounder = Plain>
AXIAL_INLINE constexpr auto to_parent(const AxialScrew<Axis, C, S, L, Turn>& x, const Columns<F, B, U, T>& c,
                                      const Rounder& round = {}) {
  using axial::to_parent;
  using namespace quantity;
  return Columns{to_parent(x, c.acceleration, as_forces<UnitMoment, UnitForce>(round)), to_parent(x, c.row),
                 to_parent(x, c.speed, as_forces<FlowMoment, FlowMomentum>(round)),
                 to_parent(x, c.position, as_forces<PositionMoment, PositionForce>(round))};
}

/// b . phi.
template <class B>
AXIAL_INLINE constexpr auto row_along(Revolute, const B& row) {
  return row.z;
}
/// Prismatic overload: a slide turns nothing.
template <class B>
AXIAL_INLINE constexpr Zero row_along(Prismatic, const B&) {
  return {};
}

/// Entries of joint k with joint i inboard of it, in whose frame the columns stand: both ways round.
template <class Joint, class K, class I, class C, class M, class Out>
AXIAL_INLINE constexpr void write_pair(Joint joint, K k, I i, const C& columns, const M& axis, Out& out) {
  out.mass(k, i, along_joint(joint, columns.acceleration));
  out.position(i, k, along_joint(joint, columns.position));
  out.position(k, i, dot(columns.row, axis.first.angular) + along_motion(axis.second, columns.acceleration));
  out.velocity(i, k, along_joint(joint, columns.speed));
  out.velocity(k, i, row_along(joint, columns.row) + along_motion(axis.doubled, columns.acceleration));
}

/// The columns of joint k, in the frame of joint j's axis, as they are in that of joint i's, the next one inboard; with
/// their entries.
template <class Links, class Screws, class Axes, class C, class K, class J, class I, class Out>
AXIAL_INLINE constexpr auto carried_inboard(const Links& links, const Screws& screws, const Axes& axes,
                                            const C& columns, K k, J j, I i, Out& out) {
  auto link = links.link(i);
  auto carried = to_axis(links, screws, i, to_parent(links.link(j).x(), columns, link), link);
  link.on_joint([&](auto joint) AXIAL_INLINE { write_pair(joint, k, i, carried, axes[i], out); });
  return carried;
}
/// Carries the columns of joint k, in the frame of joint j's axis, to all joints inboard of it.
template <class Links, class Screws, class Axes, class C, class K, class J, class Out>
AXIAL_INLINE constexpr void climb(const Links& links, const Screws& screws, const Axes& axes, const C& columns, K k,
                                  J j, Out& out) {
  if constexpr (Links::unrolled) {
    constexpr int parent = Links::template parent_of<J::value>;
    if constexpr (parent >= 0) {
      const Index<parent> i;
      climb(links, screws, axes, carried_inboard(links, screws, axes, columns, k, j, i, out), k, i, out);
    }
  } else {
    auto carried = columns;
    for (int from = j, i = links.parent_index(from); i >= 0; from = i, i = links.parent_index(from)) {
      auto link = links.link(i);
      carried = link.shape(to_parent(screws[i], to_parent(links.link(from).x(), carried, link), link));
      link.on_joint([&](auto joint) { write_pair(joint, k, i, carried, axes[i], out); });
    }
  }
}

/// Columns of the joints of a chain from joint `From` on, as numbers in the frame of that joint's axis.
template <class Links, int From>
struct KeptColumns {
  using T = typename Links::Scalar;               ///< the numbers
  using Force = ForceVector<ZeroVec3, ZeroVec3>;  ///< of columns that are nothing
  using Dense = decltype(Columns<Force, ZeroVec3, Force, Force>{}.template dense<T>());  ///< a joint's
  Row<Dense, Links::capacity - From> columns{};                                          ///< joint by joint
};
/// No columns.
template <class Links>
struct KeptColumns<Links, 0> {};
/// Carries the columns of joint k of a chain, in the frame of joint j's axis, to joints from joint `From` on, where
/// they are kept.
template <class Links, class Screws, class Axes, class C, class K, class J, int From, class Out>
AXIAL_INLINE constexpr void climb_and_keep(const Links& links, const Screws& screws, const Axes& axes, const C& columns,
                                           K k, J j, KeptColumns<Links, From>& kept, Out& out) {
  if constexpr (J::value > From) {
    const Index<J::value - 1> i;
    climb_and_keep(links, screws, axes, carried_inboard(links, screws, axes, columns, k, j, i, out), k, i, kept, out);
  } else {
    kept.columns[k - From] = columns.template dense<typename Links::Scalar>();
  }
}
/// Carries what is kept to all joints inboard, in a loop: its code stands once, not for each joint.
template <class Links, class Screws, class Axes, int From, class Out>
AXIAL_INLINE constexpr void climb_in_loop(const Links& links, const Screws& screws, const Axes& axes,
                                          const KeptColumns<Links, From>& kept, Out& out) {
  for (int k = From; k < Links::capacity; ++k)
    climb(links, screws, axes, kept.columns[k - From], k, Index<From>{}, out);
}
/// Overload for nothing kept.
template <class Links, class Screws, class Axes, class Out>
AXIAL_INLINE constexpr void climb_in_loop(const Links&, const Screws&, const Axes&, const KeptColumns<Links, 0>&,
                                          Out&) {}

}  // namespace derivatives
}  // namespace axial

#include <axial/options/end.hpp>
