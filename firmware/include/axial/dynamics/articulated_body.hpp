// The articulated-body algorithm (ABA) by successive axial screws, with the bias in classical accelerations.
#pragma once

#include <axial/base/floating_base.hpp>
#include <axial/dynamics/free_response.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/spatial/articulated_congruence.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace aba {

/// Velocity-dependent part of a link's motion: angular velocity w, its products p and matrix u = w~ w~, and the bias
/// acceleration zeta that the joint's motion adds (angular, linear). No linear velocity appears anywhere, so nothing
/// of size m |v|^2 has to cancel.
template <class W, class P, class U, class Z>
struct Velocity {
  W w{};     ///< rad/s
  P p{};     ///< (wy wz, wx wz, wx wy)
  U u{};     ///< w~ w~: how points of the link accelerate
  Z zeta{};  ///< rad/s^2, m/s^2
  /// This velocity as plain numbers.
  template <class T>
  AXIAL_INLINE constexpr Velocity<Vec3<T>, Vec3<T>, Mat3<Vec3<T>>, MotionVector<Vec3<T>, Vec3<T>>> dense() const {
    return {w, p, u, zeta};
  }
};
template <class W, class P, class U, class Z>
Velocity(W, P, U, Z) -> Velocity<W, P, U, Z>;

/// The base: at rest unless the scene moves it.
template <class Links, class Input>
AXIAL_INLINE constexpr auto base_velocity(const Links& links, const Input& in) {
  constexpr ZeroVec3 o;
  auto first = links.link(Index<0>{});
  auto w = base_angular_velocity(links, in);
  auto p = products(w, first);
  return Velocity{w, p, rotation_acceleration(w, o, p, first), MotionVector{o, o}};
}

/// Velocity of a revolute link from its parent's; both in their own frames. qd in rad/s.
template <class Link, class Screw, class Parent, class V>
AXIAL_INLINE constexpr auto move(Revolute, const Link& link, const Screw& screw, const Parent& parent, const V& qd) {
  using namespace quantity;
  constexpr ZeroVec3 still;
  auto x = link.x();
  auto turning = to_child(screw, to_child(x, parent.w));
  auto w = link.sum(AngularVelocity{}, turning, along_z(qd));
  auto p = products(w, link);
  auto u = rotation_acceleration(w, still, p, link);
  auto angular = link.sum(AngularAcceleration{}, cross_z(turning, qd));
  // d lies on the axis, which turns with the parent: w_parent x (w_parent x d) in terms of this link's products.
  auto on_axis = screw.shift * Vec3{p.y + angular.y, p.x - angular.x, u.z.z};
  auto at_axis = link.sum(LinearAcceleration{}, parent.u * translation(x));
  auto linear = link.sum(LinearAcceleration{}, to_child(screw, to_child(x, at_axis)), on_axis);
  return Velocity{w, p, u, MotionVector{angular, linear}};
}
/// Velocity of a prismatic link from its parent's; both in their own frames. qd in m/s.
template <class Link, class Screw, class Parent, class V>
AXIAL_INLINE constexpr auto move(Prismatic, const Link& link, const Screw& screw, const Parent& parent, const V& qd) {
  using namespace quantity;
  constexpr ZeroVec3 still;
  auto x = link.x();
  auto w = to_child(screw, to_child(x, parent.w));
  auto p = products(w, link);
  auto u = rotation_acceleration(w, still, p, link);
  auto at_axis = link.sum(LinearAcceleration{}, parent.u * translation(x));
  auto linear = link.sum(LinearAcceleration{}, to_child(screw, to_child(x, at_axis)), u * along_z(screw.shift),
                         cross_z(w, twice(qd)));
  return Velocity{w, p, u, MotionVector{still, linear}};
}

/// What a subtree shows to the link that carries it: inertia, bias force, and the scale of singularity.
template <class I, class P, class R>
struct Subtree {
  I inertia{};  ///< an ArticulatedInertia
  P bias{};     ///< a ForceVector, N m and N
  R scale{};    ///< a CompositeScale, or Unscaled
  /// This subtree as numbers, each quantity in the form in which T keeps it.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return Subtree<decltype(inertia.template dense<T>()), decltype(bias.template dense<T>()),
                   decltype(scale.template dense<T>())>{inertia.template dense<T>(), bias.template dense<T>(),
                                                        scale.template dense<T>()};
  }
};
template <class I, class P, class R>
Subtree(I, P, R) -> Subtree<I, P, R>;

/// Two subtrees of one link as one.
template <class A, class B, class C, class D, class E, class F>
AXIAL_INLINE constexpr auto operator+(const Subtree<A, B, C>& a, const Subtree<D, E, F>& b) {
  return Subtree{a.inertia + b.inertia, a.bias + b.bias, a.scale + b.scale};
}

/// A link by itself: I, and beta = (w x J w; w x (w x h)) less the force that acts on it from outside.
template <class Link, class Body, class D, class Vel, class F>
AXIAL_INLINE constexpr auto alone(const Link& link, const Body& body, const D& differences, const Vel& velocity,
                                  const F& external) {
  constexpr ZeroVec3 still;
  auto moment =
      link.sum(quantity::Moment{}, rotational_moment(body.inertia, differences, still, velocity.p, velocity.u));
  auto force = link.sum(quantity::Force{}, velocity.u * body.first_moment);
  return Subtree{link.formatted(articulated(body)), link.subtract(ForceVector{moment, force}, external),
                 scale_of(link, body)};
}

/// A subtree with the mass of the water that moves with its link; `water` is Dry where there is none.
template <class Water, class Tree>
AXIAL_INLINE constexpr auto immersed(const Water& water, const Tree& tree) {
  return Subtree{tree.inertia + water.inertia(), tree.bias, tree.scale + scale_of_water(water)};
}
/// Overload for a dry link: the subtree as it was.
template <class Tree>
AXIAL_INLINE constexpr auto immersed(const Dry&, const Tree& tree) {
  return tree;
}

/// What the outward pass needs of a joint, and what the parent gets.
template <class G, class U, class Z, class B, class L, class S>
struct InwardResult {
  G gain{};       ///< K = U / D
  U free{};       ///< u / D: the acceleration of the joint if its parent did not accelerate
  Z zeta{};       ///< bias acceleration of its motion
  B singular{};   ///< whether D is lost in rounding
  L left{};       ///< whether anything is left of D: the joint is held if not
  S on_parent{};  ///< subtree that its parent bears, in the parent's frame
};
template <class G, class U, class Z, class B, class L, class S>
InwardResult(G, U, Z, B, L, S) -> InwardResult<G, U, Z, detail::Decided<B>, L, S>;

/// An inward result in the form in which the link keeps results.
template <class Link, class G, class U, class Z, class B, class L, class S>
AXIAL_INLINE constexpr auto shaped(const Link& link, const InwardResult<G, U, Z, B, L, S>& left) {
  return InwardResult{link.shape(left.gain),     link.shape(left.free), link.shape(left.zeta), left.singular, left.left,
                      link.shape(left.on_parent)};
}

/// Inward step of a joint: reflects the subtree across it and brings the result to the parent's frame.
template <class Kind, class Link, class Screw, class Tree, class Vel, class Tau>
AXIAL_INLINE constexpr auto reflect(Kind joint, const Link& link, const Screw& screw, const Tree& tree,
                                    const Vel& velocity, const Tau& tau) {
  auto x = link.x_inboard();
  auto r = reflection(joint, link, tree.inertia, tree.bias, velocity.zeta, tau, singularity_scale(joint, tree.scale));
  Subtree on_parent{to_parent(x, to_parent(screw, r.inertia, link), link.outer()),
                    to_parent(x, to_parent(screw, r.bias, link), link.outer()),
                    seen_from(tree.scale, shift_length(x) + shift_length(screw))};
  return InwardResult{r.gain, r.free, velocity.zeta, r.singular, r.left, on_parent};
}

/// What drives a moving structure: joint speeds, the base's motion, forces from outside, friction and springs.
template <class Links, class Input, class Q, class V, class Water>
struct InMotion {
  const Links& links;  ///< of the scene
  const Input& in;     ///< run-time inputs
  const Q& q;          ///< rad or m
  const V& qd;         ///< rad/s or m/s
  const Water& water;  ///< immersion of each link, or Dry

  /// Effort of joint i less what friction and spring take of it, N m or N.
  template <class I, class Link, class Tau>
  AXIAL_INLINE constexpr auto effort(I i, const Link& link, const Tau& tau) const {
    return link.sum(quantity::JointEffort{}, tau, -passive_effort(link, q[i], qd[i]));
  }
  /// Velocity-dependent part of every link's motion.
  template <class Screws>
  AXIAL_INLINE constexpr auto velocities(const Screws& screws) const {
    auto next = [&](auto joint, auto i, const auto& link, const auto& parent)
                    AXIAL_INLINE { return link.shape(move(joint, link, screws[i], parent, qd[i])); };
    return outward(links, base_velocity(links, in), ByJoint{links, next});
  }
  /// Force that acts on link i from outside, water included: N m and N.
  template <class I, class Link, class Body, class Vel>
  AXIAL_INLINE constexpr auto external(I i, const Link& link, const Body& body, const Vel& velocity) const {
    constexpr ZeroVec3 still;
    return TipLoads<typename Links::Scene, Input>(in).wrench(i, link) -
           force_on_water(links, i, link, body, water[i], velocity.p, velocity.u, still, still);
  }
  /// The base's acceleration against gravity: given, or what the links leave to a base that is free.
  template <class Joints>
  AXIAL_INLINE constexpr auto base(const Joints& joints) const {
    if constexpr (Links::Scene::template has<FloatingBase>) {
      using T = typename Links::Scalar;
      auto body = base_link(links);
      auto velocity = base_velocity(links, in);
      constexpr ZeroVec3 still;
      auto load = base_load(links, in) - base_force_on_water(links, in, body, velocity.p, velocity.u, still, still);
      auto own = alone(body, body.body(), body.inertia_differences(), velocity, load);
      auto all = with_roots(links, joints, immersed(water_about_base(links), own));
      return free_motion<T>(body, all.inertia, all.bias, all.scale);
    } else {
      return FreeMotion{MotionVector{base_angular_acceleration(links, in), base_acceleration(links, in)}, false};
    }
  }
};

/// Writes the acceleration of a floating base, with gravity back in it.
template <class Links, class Input, class Motion, class Answer, class A>
AXIAL_INLINE constexpr Answer write_base(const Links& links, const Input& in, const Motion& base, Answer status,
                                         A& result) {
  if constexpr (Links::Scene::template has<FloatingBase>) {
    const auto& a = base.acceleration;
    if constexpr (Links::Scene::template has<Underwater>)
      result.base_acceleration = a;
    else
      result.base_acceleration = MotionVector{a.angular, a.linear + gravity_at_base(links, in)};
    put_where(status, base.singular, Status::Code::near_singular);
  }
  return status;
}

/// The algorithm over any form of links and the screws at q; writes one acceleration per joint.
template <class Links, class Input, class Screws, class Situation, class Tau, class A>
AXIAL_INLINE constexpr auto accelerations(const Links& links, const Input& in, const Screws& screws,
                                          const Situation& situation, const Tau& tau, A& qdd) {
  using T = typename Links::Scalar;
  const TipLoads<typename Links::Scene, Input> loads(in);
  auto velocities = situation.velocities(screws);
  auto own = [&](auto i) AXIAL_INLINE {
    auto link = links.link(i);
    auto body = loads.body(link);
    auto differences = loaded_differences<typename Links::Scene>(link, body);
    auto dry = alone(link, body, differences, velocities[i], situation.external(i, link, body, velocities[i]));
    return link.shape(immersed(water_about(links, i), dry));
  };
  auto joints = inward(links, own, [&](auto i, const auto& tree) AXIAL_INLINE {
    auto link = links.link(i);
    auto effort = situation.effort(i, link, tau[i]);
    if constexpr (Links::unrolled)
      return shaped(link, reflect(detail::KindOfJoint<decltype(link)>{}, link, screws[i], tree, velocities[i], effort));
    else
      return link.on_joint([&](auto joint) AXIAL_INLINE {
        return shaped(link, reflect(joint, link, screws[i], tree, velocities[i], effort));
      });
  });
  Ordinal<T> singular = -1;
  auto base = situation.base(joints);
  outward(links, base.acceleration, [&](auto i, const auto& parent) AXIAL_INLINE {
    auto link = links.link(i);
    const auto& left = joints[i];
    auto moved = with_joint(link, to_child(screws[i], to_child(link.x(), parent, link), link), left.zeta);
    Truth<T> lost = left.singular;
    auto answer = link.on_joint([&](auto joint) AXIAL_INLINE {
      auto acceleration = joint_acceleration(link, left.free, left.gain, moved, left.left, lost);
      links.write_limited(qdd, i, acceleration, lost);
      return link.shape(with_joint(link, moved, along_axis(joint, acceleration)));
    });
    singular = first_found(singular, lost, static_cast<int>(i));
    return answer;
  });
  return write_base(links, in, base, status_of<Links>(singular, false), qdd);
}

/// The classical form: one inward pass carries inertia and bias.
template <class Links, class Input, class Q, class V, class Tau, class A>
AXIAL_INLINE constexpr auto run(const Links& links, const Input& in, const Q& q, const V& qd, const Tau& tau, A& qdd) {
  auto at = links.read(q);
  auto speed = links.read(qd);
  auto screws = joint_screws(links, in, at);
  auto water = immersions(links, in, screws, speed);
  using Situation = InMotion<Links, Input, decltype(at), decltype(speed), decltype(water)>;
  return accelerations(links, in, screws, Situation{links, in, at, speed, water}, links.read(tau), qdd);
}

}  // namespace aba
}  // namespace axial

#include <axial/options/end.hpp>
