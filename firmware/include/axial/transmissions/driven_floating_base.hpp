// Forward dynamics of joints that share drives on a base that is free: composite bodies, the base eliminated first.
//
// With a the base's acceleration, I the inertia of all bodies about it, F_k the force that moves them with a unit of
// drive k's acceleration and p the force that holds a base without acceleration: I a + F udd + p = 0 and
// F^T a + M udd = tau - bias, so (M - F^T I^-1 F) udd = tau - bias + F^T I^-1 p. Source: Featherstone 2008,
// section 9.3.
#pragma once

#include <axial/base/floating_base.hpp>
#include <axial/dynamics/base_wrench.hpp>
#include <axial/dynamics/composite_body.hpp>
#include <axial/transmissions/driven_links.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace driven {

/// A force beyond the screw of link j as the base bears it, in its frame.
template <class Bodies, class Screws, class F, class J>
AXIAL_INLINE constexpr auto at_base(const Bodies& joints, const Screws& screws, const F& force, J j) {
  const auto link = joints.link(j);
  const auto on_parent = to_parent(link.x(), force, link.outer());
  if constexpr (Bodies::unrolled) {
    constexpr int parent = Bodies::template parent_of<J::value>;
    if constexpr (parent < 0)
      return on_parent;
    else
      return at_base(joints, screws, to_parent(screws[Index<parent>{}], on_parent, joints.link(Index<parent>{})),
                     Index<parent>{});
  } else {
    auto carried = link.shape(on_parent);
    for (int i = joints.parent_index(j); i >= 0; i = joints.parent_index(i)) {
      const auto inboard = joints.link(i);
      carried = inboard.shape(to_parent(inboard.x(), to_parent(screws[i], carried, inboard), inboard.outer()));
    }
    return carried;
  }
}

/// Forward dynamics over the links of drives, on each link's own parameters.
template <class Links>
struct FloatingBaseCoupled {
  using T = typename Links::Scalar;                                                     ///< the number
  using Force = ForceVector<Vec3<T>, Vec3<T>>;                                          ///< at frame 0
  using Motion = MotionVector<Vec3<T>, Vec3<T>>;                                        ///< of frame 0
  using JointMatrix = MassMatrixOf<typename Links::JointScene, typename Links::Value>;  ///< M of the joints
  using Matrix = MassMatrix<typename Links::Scene::Robot, T>;                           ///< M of the drives

  static_assert(!Links::Scene::template has<Underwater> && !Links::Scene::template has<BaseParameters>,
                "axial: forward dynamics of joints that share drives on a floating base is that in air, on each link's "
                "own parameters; take Underwater and BaseParameters out of the scene");

  /// Accelerations of the drives and of the base, with a status.
  template <class Input, class Q, class V, class Tau, class A>
  AXIAL_INLINE static constexpr auto accelerations(const Links& links, const Input& in, const Q& u, const V& ud,
                                                   const Tau& tau, A& udd) {
    const auto& joints = links.joints();
    const auto screws = joint_screws(joints, in, links.positions(u));
    const Force p = hold(links, in, screws, u, ud, tau, udd);
    Force at[Links::capacity] = {};
    Matrix m{};
    const auto body = base_link(joints);
    const RigidInertia<T, Vec3<T>, Sym3<T>> all = compose(links, in, screws, at, m);
    const auto freed = [&](const Force& force)
                           AXIAL_INLINE { return free_motion<T>(body, articulated(all), force, composite_scale(all)); };
    const auto alone = freed(p);
    Motion gain[Links::capacity] = {};
    links.each_drive([&](auto k) AXIAL_INLINE {
      gain[k] = freed(at[k]).acceleration;
      udd[k] = udd[k] - along_motion(alone.acceleration, at[k]);
    });
    crba::Loss<T, false> loss;
    links.each_drive([&](auto k) AXIAL_INLINE {
      const T whole = m(k, k);
      for (int l = 0; l <= k; ++l)
        m(k, l) = m(k, l) + along_motion(gain[l], at[k]);
      loss.see(whole, reciprocal(m(k, k)));
    });
    auto status = crba::solve(links.drives(), m, udd);
    put_where(status, loss.code() != Ordinal<T>(0), Status::Code::inaccurate);
    put_where(status, !is_negative(Ordinal<T>(status.joint)), Status::Code::near_singular);
    put_where(status, alone.singular, Status::Code::near_singular);
    Motion base = alone.acceleration;
    links.each_drive([&](auto k) AXIAL_INLINE {
      base.angular = base.angular + udd[k] * gain[k].angular, base.linear = base.linear + udd[k] * gain[k].linear;
    });
    udd.base_acceleration = base;
    return status;
  }

 private:
  /// What the drives' efforts leave while the base does not accelerate, and the force that holds it so.
  template <class Input, class Screws, class Q, class V, class Tau, class A>
  AXIAL_INLINE static constexpr Force hold(const Links& links, const Input& in, const Screws& screws, const Q& u,
                                           const V& ud, const Tau& tau, A& left) {
    Input still = in;
    still.base_motion.angular_acceleration = still.base_motion.linear_acceleration = {};
    const auto& joints = links.joints();
    const auto q = links.positions(u);
    const auto qd = links.rates(ud);
    typename Links::JointValues bias{};
    const auto motions = rnea::link_motions(joints, still, screws, qd, NoMotion{});
    const auto water = immersions(joints, still, screws, qd);
    const auto own = [&](auto i) AXIAL_INLINE { return rnea::own_force(joints, still, motions, water, i); };
    const auto on_parent = inward(joints, own, [&](auto i, const auto& force) AXIAL_INLINE {
      joints.write(bias, i, rnea::joint_effort(joints, i, force, q, qd, NoMotion{}));
      return rnea::InwardResult{rnea::force_on_parent(joints, screws, i, force)};
    });
    DrivenKernels<Links>::remaining_efforts(links, bias, ud, tau, left);
    return with_roots(joints, on_parent, rnea::base_body_force(joints, still));
  }
  /// M of the drives, the forces at the base that go with each of its columns, and the inertia of everything there.
  template <class Input, class Screws>
  AXIAL_INLINE static constexpr RigidInertia<T, Vec3<T>, Sym3<T>> compose(const Links& links, const Input& in,
                                                                          const Screws& screws, Force* at, Matrix& m) {
    const auto& joints = links.joints();
    const auto bodies = crba::composite_bodies(joints, in, screws);
    JointMatrix of_joints{};
    Row<Force, std::decay_t<decltype(joints)>::capacity> forces{};
    for_each_link(joints, [&](auto i) AXIAL_INLINE {
      const auto link = joints.link(i);
      const auto force =
          link.on_joint([&](auto joint) AXIAL_INLINE { return link.shape(crba::unit_force(joint, bodies[i].turned)); });
      link.on_joint([&](auto joint) AXIAL_INLINE { of_joints.set(i, i, along_joint(joint, force)); });
      crba::climb(joints, screws, force, i, i, of_joints);
      forces[i] = at_base(joints, screws, force, i);
    });
    DrivenKernels<Links>::reduce(links, of_joints, m);
    links.each_drive([&](auto k) AXIAL_INLINE {
      const auto actuator_effort = [&](const auto& get) AXIAL_INLINE {
        typename Links::JointValues values{};
        for_each_link(joints, [&](auto i) AXIAL_INLINE { values[i] = get(forces[i]); });
        return static_cast<T>(links.actuator_effort(k, values));
      };
      at[k].moment = {actuator_effort([](const Force& f) { return f.moment.x; }),
                      actuator_effort([](const Force& f) { return f.moment.y; }),
                      actuator_effort([](const Force& f) { return f.moment.z; })};
      at[k].force = {actuator_effort([](const Force& f) { return f.force.x; }),
                     actuator_effort([](const Force& f) { return f.force.y; }),
                     actuator_effort([](const Force& f) { return f.force.z; })};
    });
    return with_roots(joints, bodies, base_link(joints).body());
  }
};

}  // namespace driven
}  // namespace axial

#include <axial/options/end.hpp>
