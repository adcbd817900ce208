#pragma once
/// Where an arm's drives stand: at its joints, or at motors in front of springs. An elastic arm is to an integrator a
/// rigid chain (elastic_joint.hpp). Deflections are states by themselves, so that a spring that is nearly rigid loses
/// no digits to q - theta.

#include "elastic_joint.hpp"
#include "mechanics.hpp"

namespace axial::apps::plant {

/// Which states of the chain are whose.
template <class R>
struct ElasticStates {
  static constexpr int joints = joint_count<R>;
  int size = 0, motor[joints] = {},
      last[joints] = {};  ///< a joint's motor, and what carries the link: the spring or it
  constexpr ElasticStates() {
    for (int i = 0; i < joints; ++i) {
      motor[i] = size++;
      last[i] = is_elastic(R::chain.links[i]) ? size++ : motor[i];
    }
  }
};
template <class R>
inline constexpr ElasticStates<R> elastic_states{};

/// Whether every elastic joint has a rotor, which its motor is.
template <class R>
constexpr bool motors_are_heavy() {
  for (const LinkParameters& link : R::chain.links)
    if (is_elastic(link) && !(link.rotor_inertia > 0.0)) return false;
  return true;
}

/// Whether no elastic joint has a spring of its own about the link, too.
template <class R>
constexpr bool links_have_one_spring() {
  for (const LinkParameters& link : R::chain.links)
    if (is_elastic(link) && link.spring_stiffness != 0.0) return false;
  return true;
}

/// R with its springs as joints.
template <class R>
struct ElasticRobot {
  static_assert(motors_are_heavy<R>(),
                "an elastic joint needs its motor: give each link with stiffness() rotor_inertia()");
  static_assert(links_have_one_spring<R>(),
                "a link behind an elastic joint has no other spring: take stiffness() or spring() from the link");
  static_assert(!R::chain.shares_drives(),
                "elastic joints have a drive each: take elastic out of this robot's Mechanics");
  static constexpr auto chain = [] {
    constexpr const auto& states = elastic_states<R>;
    constexpr const auto& of = R::chain;
    Chain<states.size> all;
    for (int i = 0; i < of.size; ++i) {
      const LinkParameters& link = of.links[i];
      const bool elastic = is_elastic(link);
      LinkParameters& motor = all.links[states.motor[i]];
      motor = elastic ? motor_of(link) : link;
      const int parent = of.parent(i);
      motor.parent = parent < 0 ? LinkParameters::base : states.last[parent];
      if (elastic) all.links[states.last[i]] = body_of(link);
    }
    all.gravity = of.gravity, all.base = of.base, all.tool = of.tool, all.payload_limit = of.payload_limit;
    return all;
  }();
};

/// The scene of a robot with the same features, and springs.
template <class S, class Robot>
struct ElasticScene;
template <class R, class... Features, class Robot>
struct ElasticScene<Scene<R, Features...>, Robot> {
  static constexpr bool has_springs = Scene<R, Features...>::template has<JointSprings>;
  using type = typename WithFeature<Scene<Robot, Features...>, !has_springs, JointSprings>::type;
};

/// A rigid arm: what drives it is what it moves by.
template <class R, class Number>
struct Drives {
  using S = ArmSceneOf<R>;  ///< what an integrator moves
  using Given = S;          ///< whose efforts are given
  using Tau = EffortsOf<S, Number>;
  /// Of the drives, `pushed` included.
  static const Tau& efforts(const Tau& acting, const Tau&) { return acting; }
  /// What encoders look at.
  template <class X>
  static const X& motors(const X& x) {
    return x;
  }
  /// At rest, joints at q.
  template <class X, class Q>
  static void place(X& x, const Q& q) {
    x.q = q;
  }
};

/// An arm of elastic joints.
template <class R, class Number>
struct ElasticDrives {
  static_assert(!is_stored_v<Number>, "an arm in fixed point has no elastic joints: take float, or name no elastic");
  using Given = ArmSceneOf<R>;
  using S = typename ElasticScene<Given, ElasticRobot<R>>::type;
  using Tau = EffortsOf<Given, Number>;
  static constexpr int n = joint_count<R>;
  static constexpr const auto& states = elastic_states<R>;

  /// A drive acts on its motor; a hand on the link, which is moved by both.
  static EffortsOf<S, Number> efforts(const Tau& acting, const Tau& pushed) {
    EffortsOf<S, Number> all{};
    for (int i = 0; i < n; ++i) {
      all[states.last[i]] = pushed[i];
      all[states.motor[i]] = acting[i];
    }
    return all;
  }
  struct Motors {
    Positions<R, Number> q{}, q_rest{};
    Velocities<R, Number> qd{};
  };
  template <class X>
  static Motors motors(const X& x) {
    Motors all;
    for (int i = 0; i < n; ++i)
      all.q[i] = x.q[states.motor[i]], all.q_rest[i] = x.q_rest[states.motor[i]], all.qd[i] = x.qd[states.motor[i]];
    return all;
  }
  /// At rest, links at q, springs bent by their weight.
  template <class X, class Q>
  static void place(X& x, const Q& q) {
    const auto weight = gravity_torque<Scene<R, Gravity>>(q);
    for (int i = 0; i < n; ++i) {
      const auto bent = -weight[i] / static_cast<Number>(R::chain.links[i].stiffness);  // 0 of a rigid joint
      x.q[states.motor[i]] = q[i];
      if (states.last[i] == states.motor[i]) continue;
      x.q[states.motor[i]] = q[i] - bent, x.q[states.last[i]] = bent;
    }
  }
};

template <class R, class Number>
using DrivesOf = std::conditional_t<has_elastic<MechanicsOf<R>>, ElasticDrives<R, Number>, Drives<R, Number>>;

}  // namespace axial::apps::plant
