// Derivatives of inverse dynamics: efforts, mass matrix and both Jacobians in one pass.
#pragma once

#include <axial/dynamics/derivative_columns.hpp>
#include <axial/dynamics/derivative_results.hpp>
#include <axial/dynamics/friction_slope.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// Doubled moments of a link with what it bears: constants of the model where the compiler knows that this is nothing.
template <class Link, class B>
AXIAL_INLINE constexpr auto loaded_moments(const Link& link, const B& body) {
  if constexpr (!Link::Scene::template has<Payload>) {
    return doubled_moments(link);
  } else if constexpr (Link::unrolled) {
    if constexpr (Link::is_last)
      return doubled_moments(link, body);
    else
      return doubled_moments(link);
  } else {
    return doubled_moments(link, body);
  }
}
/// What link i is by itself.
template <class Links, class Input, class Motions, class Passages, class Water, class I>
AXIAL_INLINE constexpr auto own_part(const Links& links, const Input& in, const Motions& motions,
                                     const Passages& passages, const Water& water, I i) {
  const TipLoads<typename Links::Scene, Input> loads(in);
  auto link = links.link(i);
  auto body = loads.body(link);
  auto force = rnea::own_force(links, in, motions, water, i);
  auto flow = mass_flow(link, loaded_moments(link, body), motions[i].w, passages[i].origin);
  return link.shape(Subtree{link.formatted(body), flow, force});
}

/// The algorithm over any form of links and the screws at q; hands every entry to `out`.
template <class Links, class Input, class Q, class Screws, class V, class A, class Out>
AXIAL_INLINE constexpr void entries(const Links& links, const Input& in, const Q& q, const Screws& screws, const V& qd,
                                    const A& qdd, Out& out) {
  auto motions = rnea::link_motions(links, in, screws, qd, qdd);
  auto passed = passages(links, in, screws, motions, qd);
  auto axes = map_links(links, [&](auto i) AXIAL_INLINE {
    auto link = links.link(i);
    return link.on_joint([&](auto joint)
                             AXIAL_INLINE { return link.shape(axis_motion(joint, link, passed[i].frame)); });
  });
  auto water = immersions(links, in, screws, qd);
  auto own = [&](auto i) AXIAL_INLINE { return own_part(links, in, motions, passed, water, i); };
  inward(links, own, [&](auto i, const auto& carried) AXIAL_INLINE {
    auto link = links.link(i);
    auto turned = link.shape(to_axis(links, screws, i, carried, link));
    link.on_joint([&](auto joint) AXIAL_INLINE {
      auto columns = link.shape(columns_of(joint, link, turned, axes[i]));
      out.effort(i, rnea::joint_effort(links, i, turned.force, q, qd, qdd));
      out.mass(i, i, along_joint(joint, columns.acceleration) + link.rotor());
      out.position(i, i, along_joint(joint, columns.position) + spring_slope(link));
      out.velocity(i, i, along_joint(joint, columns.speed) + friction_slope(link, qd[i]));
      climb(links, screws, axes, columns, i, i, out);
    });
    return rnea::InwardResult{link.shape(to_parent(link.x_inboard(), turned, link.outer()))};
  });
}

/// The algorithm from q itself; hands every entry to `out`.
template <class Links, class Input, class Q, class V, class A, class Out>
AXIAL_INLINE constexpr void run(const Links& links, const Input& in, const Q& q, const V& qd, const A& qdd, Out& out) {
  entries(links, in, q, joint_screws(links, in, q), qd, qdd, out);
}

/// The algorithm's results over links, joint values as callers have them.
template <class Result, class Links, class Input, class Q, class V, class A>
AXIAL_INLINE constexpr Result results(const Links& links, const Input& in, const Q& q, const V& qd, const A& qdd) {
  auto result = blank<Links, Result>();
  Entries<Links, Result> entries{result};
  run(links, in, links.read(q), links.read(qd), links.read(qdd), entries);
  write_between_branches(links, entries);
  return result;
}

}  // namespace derivatives

/// Inverse dynamics with its derivatives, in one pass: efforts tau (N m or N), mass matrix M, dtau_dq(i, j) = d tau_i /
/// d q_j and dtau_dqd(i, j) = d tau_i / d qd_j at given q, qd, qdd; d tau / d qdd is M. `Wanted` are with_efforts,
/// with_mass_matrix, with_position_jacobian, with_velocity_jacobian; all of them unless some are named: what is not
/// asked for has no member and no code.
/// Friction adds friction_slope() to the diagonal: no slope describes the jump of dry friction at rest. A payload moves
/// with the last link; wrenches are constant in the axes of the link that they act on. A base that moves or floats
/// keeps the motion that the inputs say. Errors: tests/property/derivatives_test.cpp holds them below 1e-6 of a block's
/// largest entry in float for three arms, below 1e-13 in double for all that it knows. In fixed point every entry has
/// an exponent and a certified error (error_bound()), where q, qd and qdd are inside the declared limits; unrolled.
/// Source: Singh, Russell and Wensing 2022, "Efficient Analytical Derivatives of Rigid-Body Dynamics Using Spatial
/// Vector Algebra" (arXiv 2105.05102), in link frames with successive axial screws. NaN and infinities propagate.
template <class S, class... Wanted, class T>
[[nodiscard]] constexpr InverseDynamicsDerivatives<S, T, Wanted...> inverse_dynamics_derivatives(
    const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd, const Accelerations<robot_of<S>, T>& qdd,
    const Inputs<S, T>& in = {}) {
  detail::check_derivable<scene_of<S>>();
  return derivatives::results<InverseDynamicsDerivatives<S, T, Wanted...>>(
      links_of<S, T, BaseParameters, recursion::Derivatives>(), in, q, qd, qdd);
}
/// Overload for a run-time model.
template <class... Wanted, int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr InverseDynamicsDerivatives<M, T, Wanted...> inverse_dynamics_derivatives(
    const Model<N, F...>& model, const Positions<M, T>& q, const Velocities<M, T>& qd, const Accelerations<M, T>& qdd,
    const Inputs<M, T>& in = {}) {
  detail::check_derivable<scene_of<M>>();
  return derivatives::results<InverseDynamicsDerivatives<M, T, Wanted...>>(model.template links<T>(), in, q, qd, qdd);
}

}  // namespace axial

#include <axial/options/end.hpp>
