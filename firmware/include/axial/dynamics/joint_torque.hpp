// The effort of one joint: what the links outboard of it need, and nothing of the other joints' efforts.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/inverse_dynamics.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace rnea {

// Force that joint I bears, from the tips of its own branch: recursion over a tree of types.
/// Force that joint I bears, from the tips of its own branch.
template <class Links, class Input, class Screws, class Motions, class Water, class Spins>
struct Branch {
  const Links& links;      ///< of the scene
  const Input& in;         ///< run-time inputs
  const Screws& screws;    ///< z-screw of each joint
  const Motions& motions;  ///< motion of each link
  const Water& water;      ///< immersion of each link, or Dry
  const Spins& spins;      ///< spins of the rotors on each link, where the scene names RotorDynamics

  /// Force of link i by itself: N m and N, in its frame.
  template <class I>
  AXIAL_INLINE constexpr auto own(I i) const {
    if constexpr (Links::Scene::template has<RotorDynamics>)
      return with_spin(links.link(i), own_force(links, in, motions, water, i), spins[i], motions[i]);
    else
      return own_force(links, in, motions, water, i);
  }

  /// Force of link I and all that it carries: N m and N, in its frame.
  template <int I>
  AXIAL_INLINE constexpr auto force(Index<I> i) const {
    return detail::loaded(own(i), children<I, I + 1>());
  }
  /// What the children of link I, from link C on, send to it, in its frame.
  template <int I, int C>
  AXIAL_INLINE constexpr auto children() const {
    if constexpr (C >= Links::capacity)
      return detail::NoLoad{};
    else if constexpr (Links::template parent_of<C> == I)
      return detail::loaded(children<I, C + 1>(), force_on_parent(links, screws, Index<C>{}, force(Index<C>{})));
    else
      return children<I, C + 1>();
  }
  /// Looped form of force(): a child has a larger index than its parent.
  AXIAL_INLINE constexpr auto force(int joint) const {
    Row<std::decay_t<decltype(own(0))>, Links::capacity> total;
    for (int i = joint; i < links.size(); ++i)
      total[i] = own(i);
    for (int i = links.size(); --i > joint;) {
      const int parent = links.parent_index(i);
      if (parent >= joint) total[parent] = total[parent] + force_on_parent(links, screws, i, total[i]);
    }
    return total[joint];
  }
};

/// Spins of the rotors on all links; nothing where the scene does not name RotorDynamics.
template <class Links, class V, class A>
AXIAL_INLINE constexpr auto spins_of(const Links& links, const V& qd, const A& qdd) {
  if constexpr (Links::Scene::template has<RotorDynamics>)
    return rotor_spins(links, links, qd, qdd);
  else
    return NoMotion{};
}

/// Effort of joint i that bears its branch, and drives its rotor.
template <class Branch, class I, class Q, class V, class A>
AXIAL_INLINE constexpr auto effort_with_rotor(const Branch& branch, I i, const Q& q, const V& qd, const A& qdd) {
  auto effort = joint_effort(branch.links, i, branch.force(i), q, qd, qdd);
  if constexpr (std::decay_t<decltype(branch.links)>::Scene::template has<RotorDynamics>)
    return effort + effort_on_rotor(branch.links, branch.links, branch.in, i, branch.motions);
  else
    return effort;
}

/// Effort of one joint over any form of links, N m or N; joint values as kernels read them.
template <class Links, class Input, class I, class Q, class V, class A>
AXIAL_INLINE constexpr auto run_joint(const Links& links, const Input& in, I joint, const Q& q, const V& qd,
                                      const A& qdd) {
  if constexpr (is_refused<Links>) {
    return links;
  } else {
    auto screws = joint_screws(links, in, q);
    auto motions = link_motions(links, in, screws, qd, qdd);
    auto water = immersions(links, in, screws, qd);
    const auto spins = spins_of(links, qd, qdd);
    const Branch<Links, Input, decltype(screws), decltype(motions), decltype(water), decltype(spins)> branch{
        links, in, screws, motions, water, spins};
    if constexpr (Links::unrolled)
      return effort_with_rotor(branch, joint, q, qd, qdd);
    else
      return effort_with_rotor(branch, int{joint}, q, qd, qdd);
  }
}

/// Whether a scene's robot has a joint of that index.
template <class S, int Joint>
inline constexpr bool has_joint = Joint >= 0 && Joint < joint_count<S>;

/// Effort of one joint as results of a scene S over numbers T hold it.
template <class S, class T, int Joint>
struct JointEffort {
  /// N m or N
  template <class Links, class Input, class Q, class V, class A>
  AXIAL_INLINE static constexpr T run(const Links& links, const Input& in, const Q& q, const V& qd, const A& qdd) {
    constexpr Index<Joint> joint;
    auto effort = links.no_efforts();
    links.write(effort, joint, run_joint(links, in, joint, links.read(q), links.read(qd), links.read(qdd)));
    return effort[Joint];
  }
};
/// The same over any links.
template <class S, int Joint, class T, class Q, class V, class A>
constexpr T joint_effort_of(const Inputs<S, T>& in, const Q& q, const V& qd, const A& qdd) {
  return execute<JointEffort<S, T, Joint>>(links_of<S, T, BaseParameters>(), in, q, qd, qdd);
}

}  // namespace rnea

/// Effort of one joint (where joints share drives, of one drive) in inverse_dynamics, N m or N, without the efforts of
/// the others: joint_torque<Robot, 2>(q, qd, qdd). Inputs as there; in fixed point the exponent is that of the joint's
/// effort there.
template <class S, int Joint, class T>
[[nodiscard]] constexpr T joint_torque(const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd,
                                       const Accelerations<robot_of<S>, T>& qdd,
                                       const Inputs<S, T>& in = no_inputs<S, T>()) {
  static_assert(rnea::has_joint<S, Joint>,
                "axial: the robot has no such joint; joints are counted from 0, base outwards");
  if constexpr (rnea::has_joint<S, Joint>)  // else the message alone
    return rnea::joint_effort_of<S, Joint>(in, q, qd, qdd);
  else
    return T{};
}
/// Effort of one joint in gravity_torque: gravity_torque<Robot, 2>(q).
template <class S, int Joint, class T>
[[nodiscard]] constexpr T gravity_torque(const Positions<robot_of<S>, T>& q,
                                         const Inputs<S, T>& in = no_inputs<S, T>()) {
  static_assert(rnea::has_joint<S, Joint>,
                "axial: the robot has no such joint; joints are counted from 0, base outwards");
  if constexpr (rnea::has_joint<S, Joint>)
    return rnea::joint_effort_of<S, Joint>(in, q, NoMotion{}, NoMotion{});
  else
    return T{};
}

/// Overload for a run-time model, 0 <= joint < model.size().
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr T joint_torque(const Model<N, F...>& model, int joint, const Positions<M, T>& q,
                                       const Velocities<M, T>& qd, const Accelerations<M, T>& qdd,
                                       const Inputs<M, T>& in = no_inputs<M, T>()) {
  return rnea::run_joint(model.template links<T>(), in, joint, q, qd, qdd);
}
/// Overload for a run-time model, 0 <= joint < model.size().
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr T gravity_torque(const Model<N, F...>& model, int joint, const Positions<M, T>& q,
                                         const Inputs<M, T>& in = no_inputs<M, T>()) {
  return rnea::run_joint(model.template links<T>(), in, joint, q, NoMotion{}, NoMotion{});
}

}  // namespace axial

#include <axial/options/end.hpp>
