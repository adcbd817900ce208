// The algorithm of derivatives of inverse dynamics: one pass that hands out efforts, M and both Jacobians, entry by
// entry; and which entries are not zero, as the compiler finds by running it once.
#pragma once

#include <axial/derivatives/derivative_columns.hpp>
#include <axial/derivatives/derivative_results.hpp>
#include <axial/recursion/drive_slopes.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// Whether doubled moments of a link are constants of the model: it bears nothing, as far as the compiler knows, and is
/// none of a table whose numbers have formats, where one step rounds them as a loaded link's.
template <class Link>
constexpr bool has_constant_moments() {
  if constexpr (!Link::Scene::template has<Payload>)
    return Link::unrolled || !Link::ranged;
  else if constexpr (Link::unrolled)
    return !Link::is_last;
  else
    return false;
}
/// Doubled moments of a link with what it bears.
template <class Link, class B>
AXIAL_INLINE constexpr auto loaded_moments(const Link& link, const B& body) {
  if constexpr (has_constant_moments<Link>())
    return doubled_moments(link);
  else
    return doubled_moments(link, body);
}
/// What link i is by itself.
template <class Links, class Input, class Motions, class Passages, class Forces, class I>
AXIAL_INLINE constexpr auto own_part(const Links& links, const Input& in, const Motions& motions,
                                     const Passages& passages, const Forces& forces, I i) {
  const TipLoads<typename Links::Scene, Input> loads(in);
  auto link = links.link(i);
  auto body = loads.body(link);
  auto force = forces(i);
  auto flow = mass_flow(link, loaded_moments(link, body), motions[i].w, passages[i].origin);
  return link.shape(Subtree{link.formatted(body), flow, force});
}

/// How the algorithm goes over its links: no number depends on it.
struct JointByJoint {
  static constexpr bool forces_ahead = false;  ///< whether links' own forces are found before the motions of axes
  static constexpr int looped_from = 0;  ///< joint of a chain whose columns, and those outboard, end in a loop; or 0
};
/// `force` itself, or what it found of every link, which is less to keep than the motions that it is found from.
template <class Order, class Links, class Force>
AXIAL_INLINE constexpr auto forces_of(const Links& links, const Force& force) {
  if constexpr (Order::forces_ahead)
    return [forces = map_links(links, force)](auto i) AXIAL_INLINE { return forces[i]; };
  else
    return force;
}
/// Whether columns of joint i end in the loop.
template <class Order, class I>
AXIAL_INLINE constexpr auto is_looped(I) {
  if constexpr (Order::looped_from > 0)
    return std::bool_constant<(I::value >= Order::looped_from)>{};
  else
    return std::false_type{};
}

/// The algorithm over any form of links and the screws at q; hands every entry to `out`.
template <class Order = JointByJoint, class Links, class Input, class Q, class Screws, class V, class A, class Out>
AXIAL_INLINE constexpr void entries(const Links& links, const Input& in, const Q& q, const Screws& screws, const V& qd,
                                    const A& qdd, Out& out) {
  auto motions = rnea::link_motions(links, in, screws, qd, qdd);
  auto water = immersions(links, in, screws, qd);
  auto forces =
      forces_of<Order>(links, [&](auto i) AXIAL_INLINE { return rnea::own_force(links, in, motions, water, i); });
  auto passed = passages(links, in, screws, motions, qd);
  auto axes = map_links(links, [&](auto i) AXIAL_INLINE {
    auto link = links.link(i);
    return link.on_joint([&](auto joint)
                             AXIAL_INLINE { return link.shape(axis_motion(joint, link, passed[i].frame)); });
  });
  auto own = [&](auto i) AXIAL_INLINE { return own_part(links, in, motions, passed, forces, i); };
  KeptColumns<Links, Order::looped_from> kept;
  inward(links, own, [&](auto i, const auto& carried) AXIAL_INLINE {
    auto link = links.link(i);
    auto turned = link.shape(to_axis(links, screws, i, carried, link));
    link.on_joint([&](auto joint) AXIAL_INLINE {
      auto columns = link.shape(columns_of(joint, link, turned, axes[i]));
      out.effort(i, rnea::joint_effort(links, i, turned.force, q, qd, qdd));
      out.mass(i, i, unrounded_sum(along_joint(joint, columns.acceleration), link.rotor()));
      out.position(i, i, along_joint(joint, columns.position) + spring_slope(link));
      out.velocity(i, i, unrounded_sum(along_joint(joint, columns.speed), friction_slope(link, qd[i])));
      if constexpr (decltype(is_looped<Order>(i))::value)
        climb_and_keep(links, screws, axes, columns, i, i, kept, out);
      else
        climb(links, screws, axes, columns, i, i, out);
    });
    return rnea::InwardResult{link.shape(to_parent(link.x_inboard(), inboard_part(turned), link.outer()))};
  });
  climb_in_loop(links, screws, axes, kept, out);
}

/// The algorithm from q itself; hands every entry to `out`.
template <class Links, class Input, class Q, class V, class A, class Out>
AXIAL_INLINE constexpr void run(const Links& links, const Input& in, const Q& q, const V& qd, const A& qdd, Out& out) {
  entries(links, in, q, joint_screws(links, in, q), qd, qdd, out);
}

/// Which entries of the Jacobians are not zero by structure; where a kernel writes them.
template <int N>
struct JacobianStructure {
  bool by_position[N][N] = {};  ///< d tau / d q, by row and column
  bool by_velocity[N][N] = {};  ///< d tau / d qd

  template <class X>
  constexpr void effort(int, const X&) {}  ///< not looked at
  template <class X>
  constexpr void mass(int, int, const X&) {}  ///< not looked at
  constexpr void position(int, int, Zero) {}  ///< what is zero by type stays absent
  constexpr void velocity(int, int, Zero) {}  ///< what is zero by type stays absent
  template <class X>
  constexpr void position(int i, int j, const X&) {
    by_position[i][j] = true;
  }  ///< present
  template <class X>
  constexpr void velocity(int i, int j, const X&) {
    by_velocity[i][j] = true;
  }  ///< present

  /// Entries by positions.
  constexpr const auto& of(by::Position) const { return by_position; }
  constexpr const auto& of(by::Velocity) const { return by_velocity; }  ///< entries by velocities
};
/// Structure of the Jacobians of drives that joints share.
template <class Links>
constexpr auto driven_jacobian_structure();
/// Found by types alone, so at any motion: the compiler runs the kernel once over zeros.
template <class Links>
constexpr auto jacobian_structure_of() {
  using Scene = typename Links::Scene;
  if constexpr (detail::shares_drives_in<typename Scene::Robot>) {
    return driven_jacobian_structure<decltype(links_of<Scene, double, BaseParameters>())>();
  } else {
    constexpr StaticLinks<Scene, double, typename Links::Parameters> links;
    constexpr Joints<typename Scene::Robot, double> rest{};
    JacobianStructure<Links::capacity> structure;
    entries(links, Inputs<Scene, double>{}, rest, map_links(links, [&](auto i) { return links.link(i).z(0.0); }), rest,
            rest, structure);
    return structure;
  }
}
/// Structure of the Jacobians over these links.
template <class Links>
inline constexpr auto jacobian_structure = jacobian_structure_of<Links>();

}  // namespace derivatives
}  // namespace axial

#include <axial/options/end.hpp>
