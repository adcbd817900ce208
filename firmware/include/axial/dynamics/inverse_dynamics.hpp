// Inverse dynamics: joint efforts from the motion, by recursive Newton-Euler (RNEA) with successive axial screws.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/links/run_time_model.hpp>
#include <axial/recursion/drives.hpp>
#include <axial/recursion/gyration.hpp>
#include <axial/recursion/immersion.hpp>
#include <axial/recursion/joint_axis.hpp>
#include <axial/recursion/joint_screws.hpp>
#include <axial/recursion/loads.hpp>
#include <axial/recursion/moving_base.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace rnea {

/// Motion of a link in its own frame: angular velocity w, angular acceleration dw, acceleration a of the origin, and
/// the products p and matrix U that they give (gyration.hpp).
template <class W, class DW, class A, class P, class U>
struct Motion {
  W w{};    ///< rad/s
  DW dw{};  ///< rad/s^2
  A a{};    ///< m/s^2, gravity as an upward acceleration of the base
  P p{};    ///< rad^2/s^2
  U u{};    ///< rad^2/s^2 and rad/s^2
  /// This motion as numbers, each quantity in the form in which T keeps it.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    using Rate = Kept<T, quantity::AngularVelocity>;
    using Turning = Kept<T, quantity::AngularAcceleration>;
    return rnea::Motion{w.template dense<Rate>(), dw.template dense<Turning>(),
                        a.template dense<Kept<T, quantity::LinearAcceleration>>(), p.template dense<Turning>(),
                        u.template dense<Turning>()};
  }
};
template <class W, class DW, class A, class P, class U>
Motion(W, DW, A, P, U) -> Motion<W, DW, A, P, U>;

/// The base: at rest unless the scene moves it, accelerated against gravity.
template <class Links, class Input>
AXIAL_INLINE constexpr auto base(const Links& links, const Input& in) {
  auto first = links.link(Index<0>{});
  auto w = base_angular_velocity(links, in);
  auto dw = base_angular_acceleration(links, in);
  auto p = products(w, first);
  return Motion{w, dw, base_acceleration(links, in), p, rotation_acceleration(w, dw, p, first)};
}

/// Rotation of a revolute link from its parent's; `a` is left out. Points of the joint's axis accelerate, relative to
/// one another, whatever the joint does: where the axis is one of the parent's (behind turns by multiples of 90
/// degrees) the third column of U is one of the parent's U, and the angular acceleration follows from it, which takes
/// 2M 3A less than the other way round.
template <class Link, class Screw, class Parent, class V, class A>
AXIAL_INLINE constexpr auto turn(const Link& link, const Screw& screw, const Parent& parent, const V& qd,
                                 const A& qdd) {
  using namespace quantity;
  auto x = link.x();
  auto turning = to_child(screw, to_child(x, parent.w));
  auto w = link.sum(AngularVelocity{}, turning, along_z(qd));
  auto p = products(w, link);
  auto by_column = [&](const auto& axis_in_parent) AXIAL_INLINE {
    auto axis = link.sum(AngularAcceleration{}, to_child(screw, to_child(x, parent.u * axis_in_parent)));
    auto dw = angular_acceleration(link, p, axis, axial_part(to_child(x, parent.dw)), qdd);
    return Motion{w, dw, ZeroVec3{}, p, rotation_acceleration(w, dw, p, axis, link)};
  };
  auto by_vectors = [&]() AXIAL_INLINE {
    auto dw =
        link.sum(AngularAcceleration{}, to_child(screw, to_child(x, parent.dw)), cross_z(turning, qd), along_z(qdd));
    return Motion{w, dw, ZeroVec3{}, p, rotation_acceleration(w, dw, p, link)};
  };
  return by_axis(link, axis_in_parent(x), by_column, by_vectors);
}

/// Motion of a revolute link from its parent's (Luh, Walker and Paul 1980; Craig 2005, eqs. (6.45) to (6.47)).
/// `screw` is the joint's z-screw; the part d of the offset lies on the axis, so the link's own U carries it.
template <class Link, class Screw, class Parent, class V, class A>
AXIAL_INLINE constexpr auto move(Revolute, const Link& link, const Screw& screw, const Parent& parent, const V& qd,
                                 const A& qdd) {
  using namespace quantity;
  auto x = link.x();
  auto at_axis = link.sum(LinearAcceleration{}, parent.a, parent.u * translation(x));
  auto m = turn(link, screw, parent, qd, qdd);
  auto a = link.sum(LinearAcceleration{}, to_child(screw, to_child(x, at_axis)), m.u * along_z(screw.shift));
  return Motion{m.w, m.dw, a, m.p, m.u};
}

/// Motion of a prismatic link from its parent's (Craig 2005, eqs. (6.33) and (6.35)).
template <class Link, class Screw, class Parent, class V, class A>
AXIAL_INLINE constexpr auto move(Prismatic, const Link& link, const Screw& screw, const Parent& parent, const V& qd,
                                 const A& qdd) {
  using namespace quantity;
  auto x = link.x();
  auto at_axis = link.sum(LinearAcceleration{}, parent.a, parent.u * translation(x));
  auto w = link.sum(AngularVelocity{}, to_child(screw, to_child(x, parent.w)));
  auto dw = link.sum(AngularAcceleration{}, to_child(screw, to_child(x, parent.dw)));
  auto p = products(w, link);
  auto u = rotation_acceleration(w, dw, p, link);
  auto a = link.sum(LinearAcceleration{}, to_child(screw, to_child(x, at_axis)), u * along_z(screw.shift),
                    cross_z(w, twice(qd)), along_z(qdd));
  return Motion{w, dw, a, p, u};
}

/// Force and moment about the frame's origin that give a body its motion: f = m a + U h, n = J dw + w x J w + h x a.
template <class Link, class Body, class D, class M>
AXIAL_INLINE constexpr auto newton_euler(const Link& link, const Body& body, const D& differences, const M& motion) {
  using namespace quantity;
  const auto& h = body.first_moment;
  auto force = link.sum(Force{}, body.mass * motion.a, motion.u * h);
  auto moment = link.sum(Moment{}, rotational_moment(body.inertia, differences, motion.dw, motion.p, motion.u),
                         cross(h, motion.a));
  return ForceVector{moment, force};
}

/// Motions of all links, from the base outwards.
template <class Links, class Input, class Screws, class V, class A>
AXIAL_INLINE constexpr auto link_motions(const Links& links, const Input& in, const Screws& screws, const V& qd,
                                         const A& qdd) {
  return outward(links, base(links, in), [&](auto i, const auto& parent) AXIAL_INLINE {
    auto link = links.link(i);
    return link.on_joint([&](auto joint)
                             AXIAL_INLINE { return link.shape(move(joint, link, screws[i], parent, qd[i], qdd[i])); });
  });
}

/// Force that moves link i with its payload, and the water about it, less what pushes it from outside.
template <class Links, class Input, class Motions, class Water, class I>
AXIAL_INLINE constexpr auto own_force(const Links& links, const Input& in, const Motions& motions, const Water& water,
                                      I i) {
  const TipLoads<typename Links::Scene, Input> loads(in);
  auto link = links.link(i);
  auto body = loads.body(link);
  auto differences = loaded_differences<typename Links::Scene>(link, body);
  const auto& m = motions[i];
  return link.shape(link.subtract(newton_euler(link, body, differences, m), loads.wrench(i, link)) +
                    force_on_water(links, i, link, body, water[i], m.p, m.u, m.dw, m.a));
}

/// Effort of joint i that bears a force and drives its rotor, friction and spring.
template <class Links, class I, class F, class Q, class V, class A>
AXIAL_INLINE constexpr auto joint_effort(const Links& links, I i, const F& force, const Q& q, const V& qd,
                                         const A& qdd) {
  auto link = links.link(i);
  return link.on_joint([&](auto kind) AXIAL_INLINE {
    return link.sum(quantity::JointEffort{}, along_joint(kind, force), link.rotor() * qdd[i],
                    passive_effort(link, q[i], qd[i]));
  });
}

/// Force of link i as its parent bears it, in the parent's frame.
template <class Links, class Screws, class I, class F>
AXIAL_INLINE constexpr auto force_on_parent(const Links& links, const Screws& screws, I i, const F& force) {
  auto link = links.link(i);
  return link.shape(to_parent(link.x_inboard(), to_parent(screws[i], force, link), link.outer()));
}

/// What the inward pass keeps of a link.
template <class F>
struct InwardResult {
  F on_parent{};  ///< N m and N, on its parent, in the parent's frame
};
template <class F>
InwardResult(F) -> InwardResult<F>;

/// The algorithm over any form of links and the screws at q; calls each(i, force, effort) for every joint, from the
/// tips on, with what it bears.
template <class Links, class Input, class Q, class Screws, class V, class A, class Each>
AXIAL_INLINE constexpr void propagate_inward(const Links& links, const Input& in, const Q& q, const Screws& screws,
                                             const V& qd, const A& qdd, const Each& each) {
  static_cast<void>(detail::RotorsIncluded<typename Links::Scene>{});
  auto motions = link_motions(links, in, screws, qd, qdd);
  auto water = immersions(links, in, screws, qd);
  auto joint = [&](auto i, const auto& force) AXIAL_INLINE {
    if constexpr (Links::Scene::template has<RotorDynamics>)
      each(i, force, joint_effort(links, i, force, q, qd, qdd) + effort_on_rotor(links, links, in, i, motions));
    else
      each(i, force, joint_effort(links, i, force, q, qd, qdd));
    return InwardResult{force_on_parent(links, screws, i, force)};
  };
  if constexpr (Links::Scene::template has<RotorDynamics>) {
    auto spins = rotor_spins(links, links, qd, qdd);
    auto own = [&](auto i) AXIAL_INLINE {
      return with_spin(links.link(i), own_force(links, in, motions, water, i), spins[i], motions[i]);
    };
    inward(links, own, joint);
  } else {
    auto own = [&](auto i) AXIAL_INLINE { return own_force(links, in, motions, water, i); };
    inward(links, own, joint);
  }
}
/// Writes tau[i] for every joint.
template <class Links, class Input, class Q, class Screws, class V, class A, class Tau>
AXIAL_INLINE constexpr void efforts(const Links& links, const Input& in, const Q& q, const Screws& screws, const V& qd,
                                    const A& qdd, Tau& tau) {
  propagate_inward(links, in, q, screws, qd, qdd,
                   [&](auto i, const auto&, const auto& effort) AXIAL_INLINE { links.write(tau, i, effort); });
}
/// Writes tau[i] for every joint from q itself, whatever the form in which joint values stand.
struct InverseDynamics {
  /// the algorithm
  template <class Links, class Input, class Q, class V, class A, class Tau>
  AXIAL_INLINE static constexpr void run(const Links& links, const Input& in, const Q& q, const V& qd, const A& qdd,
                                         Tau& tau) {
    auto at = links.read(q);
    efforts(links, in, at, joint_screws(links, in, at), links.read(qd), links.read(qdd), tau);
  }
};

}  // namespace rnea

/// Joint efforts for a desired motion: tau = M(q) qdd + c(q, qd) + g(q) [+ rotor inertia, friction] - J^T wrench.
/// Source: recursive Newton-Euler (Luh, Walker and Paul 1980) in link frames with successive axial screws.
/// In: q (rad or m), qd, qdd; `in` carries the run-time inputs that the scene names. Out: N m or N, one per joint.
/// Gravity as the chain declares it: a link that must be held up has a positive effort opposite to gravity.
/// NaN and infinities propagate to the result, and in fixed point q, qd and qdd must be inside the declared limits; use
/// control/feedforward.hpp where inputs are not trusted.
template <class S, class T>
[[nodiscard]] constexpr EffortsOf<S, T> inverse_dynamics(const Positions<robot_of<S>, T>& q,
                                                         const Velocities<robot_of<S>, T>& qd,
                                                         const Accelerations<robot_of<S>, T>& qdd,
                                                         const Inputs<S, T>& in = no_inputs<S, T>()) {
  EffortsOf<S, T> tau{};
  execute<rnea::InverseDynamics>(links_of<S, T, BaseParameters>(), in, q, qd, qdd, tau);
  return tau;
}

namespace detail {
/// g(q), of who has looked at what the chain says.
template <class S, class T>
constexpr EffortsOf<S, T> holding_torque(const Positions<robot_of<S>, T>& q, const Inputs<S, T>& in) {
  EffortsOf<S, T> tau{};
  execute<rnea::InverseDynamics>(links_of<S, T, BaseParameters>(), in, q, NoMotion{}, NoMotion{}, tau);
  return tau;
}
}  // namespace detail

/// Gravity torque g(q) (with the tip wrench that the scene names): the effort that holds the robot still. Of a robot
/// whose chain says which way gravity pulls.
template <class S, class T>
[[nodiscard]] AXIAL_INLINE constexpr EffortsOf<S, T> gravity_torque(const Positions<robot_of<S>, T>& q,
                                                                    const Inputs<S, T>& in = no_inputs<S, T>()) {
  static_assert(detail::says_gravity<S>(), AXIAL_GRAVITY_IS);
  return detail::holding_torque<S>(q, in);
}

/// Bias torque c(q, qd) + g(q) [+ friction] - J^T wrench: the effort at zero acceleration.
template <class S, class T>
[[nodiscard]] constexpr EffortsOf<S, T> bias_torque(const Positions<robot_of<S>, T>& q,
                                                    const Velocities<robot_of<S>, T>& qd,
                                                    const Inputs<S, T>& in = no_inputs<S, T>()) {
  EffortsOf<S, T> tau{};
  execute<rnea::InverseDynamics>(links_of<S, T, BaseParameters>(), in, q, qd, NoMotion{}, tau);
  return tau;
}

/// Overload for a run-time model, in the looped form.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr Efforts<M, T> inverse_dynamics(const Model<N, F...>& model, const Positions<M, T>& q,
                                                       const Velocities<M, T>& qd, const Accelerations<M, T>& qdd,
                                                       const Inputs<M, T>& in = no_inputs<M, T>()) {
  Efforts<M, T> tau{};
  execute<rnea::InverseDynamics>(model.template links<T>(), in, q, qd, qdd, tau);
  return tau;
}
/// Overload for a run-time model, in the looped form.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr Efforts<M, T> gravity_torque(const Model<N, F...>& model, const Positions<M, T>& q,
                                                     const Inputs<M, T>& in = no_inputs<M, T>()) {
  Efforts<M, T> tau{};
  execute<rnea::InverseDynamics>(model.template links<T>(), in, q, NoMotion{}, NoMotion{}, tau);
  return tau;
}
/// Overload for a run-time model, in the looped form.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr Efforts<M, T> bias_torque(const Model<N, F...>& model, const Positions<M, T>& q,
                                                  const Velocities<M, T>& qd,
                                                  const Inputs<M, T>& in = no_inputs<M, T>()) {
  Efforts<M, T> tau{};
  execute<rnea::InverseDynamics>(model.template links<T>(), in, q, qd, NoMotion{}, tau);
  return tau;
}

}  // namespace axial

#include <axial/options/end.hpp>
