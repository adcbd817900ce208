// Whether forward dynamics was asked of numbers, and answered with numbers.
#pragma once

#include <axial/dynamics/forward_result.hpp>
#include <axial/dynamics/passes.hpp>
#include <axial/links/soundness.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

template <class T, class V>
AXIAL_INLINE constexpr void collect(Soundness<T>& all, const V& x) {
  all.number(x);
}
template <class T, class X, class Y, class Z>
AXIAL_INLINE constexpr void collect(Soundness<T>& all, const Vec3<X, Y, Z>& v) {
  all.number(v.x), all.number(v.y), all.number(v.z);
}
template <class T, class A, class B>
AXIAL_INLINE constexpr void collect(Soundness<T>& all, const ForceVector<A, B>& f) {
  collect(all, f.moment), collect(all, f.force);
}
template <class T, class A, class B>
AXIAL_INLINE constexpr void collect(Soundness<T>& all, const MotionVector<A, B>& m) {
  collect(all, m.angular), collect(all, m.linear);
}

// Run-time inputs of a scene, one after the other.
template <class Scene, class T, class Input>
AXIAL_INLINE constexpr void collect_inputs(Soundness<T>& all, const Input& in) {
  if constexpr (Scene::template has<RuntimeGravity>) collect(all, in.gravity);
  if constexpr (Scene::template has<BaseMotion> || Scene::template has<FloatingBase>) {
    collect(all, in.base_motion.angular_velocity);
    if constexpr (Scene::template has<BaseMotion>)  // a free base's accelerations are the answer, not asked for
      collect(all, in.base_motion.angular_acceleration), collect(all, in.base_motion.linear_acceleration);
  }
  if constexpr (Scene::template has<BaseWrench>) collect(all, in.base_wrench);
  if constexpr (Scene::template has<VelocityThroughWater>) collect(all, in.velocity_through_water);
  if constexpr (Scene::template has<TipWrench>) collect(all, in.tip_wrench);
  if constexpr (Scene::template has<ExternalWrenches>)
    for (const auto& wrench : in.wrenches.values)
      collect(all, wrench);
  if constexpr (Scene::template has<Payload>) {
    const auto& j = in.payload.inertia_com;
    all.number(in.payload.mass), collect(all, in.payload.com);
    collect(all, Vec3{j.xx, j.yy, j.zz}), collect(all, Vec3{j.xy, j.xz, j.yz});
  }
}

// A joint's position, or the sine and cosine that the caller gives instead. Scenes without these are told apart outside
// the lambda: clang 14 looks into branches of one that its scene leaves out.
template <class Links, class T, class Input, class Q, class I>
AXIAL_INLINE constexpr void collect_position(Soundness<T>& all, const Links& links, const Input& in, const Q& q, I i) {
  if constexpr (Links::Scene::template has<SineCosines>) {
    const auto& turn = in.turns[i];
    links.link(i).on_joint([&](auto kind) AXIAL_INLINE {
      if constexpr (std::is_same_v<decltype(kind), Revolute>)
        all.number(turn.sin), all.number(turn.cos);
      else
        all.position(kind, q[i]);
    });
  } else {
    links.link(i).on_joint([&](auto kind) AXIAL_INLINE { all.position(kind, q[i]); });
  }
}

/// Collects what forward dynamics is asked of. Efforts need no look: each is a term of its joint's acceleration.
template <class Links, class Input, class Q, class V>
AXIAL_INLINE constexpr auto collected_request(const Links& links, const Input& in, const Q& q, const V& qd) {
  if constexpr (is_driven<Links>) {
    return collected_request(links.joints(), in, links.positions(q), links.rates(qd));
  } else {
    Soundness<typename Links::Scalar> all;
    for_each_link(links, [&](auto i) AXIAL_INLINE { collect_position(all, links, in, q, i); });
    for_each_link(links, [&](auto i) AXIAL_INLINE { all.number(qd[i]); });
    collect_inputs<typename Links::Scene>(all, in);
    return all;
  }
}

/// The status of an answer that a solver calls `solved`: what is not finite, and angles without exact sines, come
/// first.
template <class Links, class T, class A>
AXIAL_INLINE constexpr auto sound_status(const Links& links, Soundness<T> all, const A& qdd,
                                         const StatusOf<T>& solved) {
  if constexpr (is_driven<Links>)
    links.each_drive([&](auto k) AXIAL_INLINE { all.number(qdd[k]); });
  else
    for_each_link(links, [&](auto i) AXIAL_INLINE { all.number(qdd[i]); });
  if constexpr (Links::Scene::template has<FloatingBase>) collect(all, qdd.base_acceleration);
  return first_trouble(all.status(), solved);
}

/// The state and the inputs of a solve, looked at before it: while they are in registers. Here nothing wraps, so that
/// answers are looked at too; a number system with formats tells by the state alone.
template <class S, class T>
class StateCheck {
 public:
  AXIAL_INLINE constexpr StateCheck(const Inputs<S, T>& in, const Positions<robot_of<S>, T>& q,
                                    const Velocities<robot_of<S>, T>& qd)
      : asked_(collected_request(links_of<S, T>(), in, q, qd)) {}
  /// Puts what is wrong with the state, the inputs or the answer into the answer's status.
  template <class Result>
  AXIAL_INLINE constexpr void judge(Result& result) const {
    result.status = sound_status(links_of<S, T>(), asked_, result, result.status);
  }
  /// Puts what is beyond the formats into a status: nothing.
  AXIAL_INLINE constexpr void name(StatusOf<T>&) const {}

 private:
  Soundness<typename decltype(links_of<S, T>())::Scalar> asked_;
};

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
