// Momenta of the joints and what changes them besides the drives, without accelerations: C^T qd and no matrix.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/recursion/position_soundness.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Momenta of the joints, M(q) qd: N m s or N s; what changes them: N m or N.
template <class S, class T>
using MomentaOf = Joints<subject_of<S, T>, T, typename detail::RoleOf<T, role::Momentum>::type>;
/// What changes the momenta of a scene: N m or N.
template <class S, class T>
using MomentumRatesOf = Joints<subject_of<S, T>, T, typename detail::RoleOf<T, role::MomentumRate>::type>;

/// What d(momentum)/dt = tau + drift + tau_external is made of.
template <class S, class T>
struct MomentumTerms {
  MomentaOf<S, T> momentum{};     ///< M(q) qd, with rotors as the scene names them: N m s or N s
  MomentumRatesOf<S, T> drift{};  ///< C^T qd - g - friction - springs + J^T wrench: N m or N
  StatusOf<T> status{};           ///< whether they are numbers, see momentum_terms()
};

namespace momentum {

/// Velocities of all links in their own frames, under the names of accelerations: a start from rest, without gravity.
template <class Links, class Screws, class V>
AXIAL_INLINE constexpr auto velocities(const Links& links, const Screws& screws, const V& qd) {
  auto none = no_motion(links);
  auto first = links.link(Index<0>{});
  auto p = products(none, first);
  auto u = rotation_acceleration(none, none, p, first);
  return outward(links, rnea::Motion{none, none, none, p, u}, [&](auto i, const auto& parent) AXIAL_INLINE {
    auto link = links.link(i);
    return link.on_joint(
        [&](auto joint) AXIAL_INLINE { return link.shape(rnea::move(joint, link, screws[i], parent, Zero{}, qd[i])); });
  });
}

/// Momentum of link i with its payload, about its frame's origin.
template <class Links, class Input, class Motions, class I>
AXIAL_INLINE constexpr auto own_momentum(const Links& links, const Input& in, const Motions& motions, I i) {
  const TipLoads<typename Links::Scene, Input> loads(in);
  auto link = links.link(i);
  auto body = loads.body(link);
  auto differences = loaded_differences<typename Links::Scene>(link, body);
  return link.shape(rnea::newton_euler(link, body, differences, motions[i]));
}

/// Component of v x u along the joint's axis.
template <class U, class V>
AXIAL_INLINE constexpr auto axial_product(const U& u, const V& v) {
  return u.y * v.x - u.x * v.y;
}

/// dT/dq of a joint: -s . (v x* h), where (w, v) is the velocity of its link, h = (n, l) the momentum of all that it
/// carries and s its axis. For velocities of links farther out change by v x s with the joint's position.
template <class M, class H>
AXIAL_INLINE constexpr auto kinetic_slope(Revolute, const M& motion, const H& h) {
  return axial_product(motion.dw, h.moment) + axial_product(motion.a, h.force);
}
/// Prismatic overload.
template <class M, class H>
AXIAL_INLINE constexpr auto kinetic_slope(Prismatic, const M& motion, const H& h) {
  return axial_product(motion.dw, h.force);
}

/// Efforts that hold the robot where it is, with the friction of its speeds: the inward pass of RNEA at rest.
template <class Links, class Input, class Q, class Screws, class V, class Tau>
AXIAL_INLINE constexpr void hold(const Links& links, const Input& in, const Q& q, const Screws& screws, const V& qd,
                                 Tau& tau) {
  const NoMotion none;
  auto motions = rnea::link_motions(links, in, screws, none, none);
  auto water = immersions(links, in, screws, none);
  auto own = [&](auto i) AXIAL_INLINE { return rnea::own_force(links, in, motions, water, i); };
  inward(links, own, [&](auto i, const auto& force) AXIAL_INLINE {
    links.write(tau, i, rnea::joint_effort(links, i, force, q, qd, none));
    return rnea::InwardResult{rnea::force_on_parent(links, screws, i, force)};
  });
}

/// The inward pass: a joint's momentum is the one about its axis of all that it carries, and its rotor's.
template <class Links, class Input, class Screws, class V, class Tau, class Terms>
AXIAL_INLINE constexpr void carry(const Links& links, const Input& in, const Screws& screws, const V& qd,
                                  const Tau& holding, Terms& terms) {
  auto motions = velocities(links, screws, qd);
  auto own = [&](auto i) AXIAL_INLINE { return own_momentum(links, in, motions, i); };
  inward(links, own, [&](auto i, const auto& h) AXIAL_INLINE {
    auto link = links.link(i);
    links.write(terms.momentum, i, link.on_joint([&](auto joint) AXIAL_INLINE {
      return link.sum(quantity::JointEffort{}, along_joint(joint, h), link.rotor() * qd[i]);
    }));
    link.on_joint([&](auto joint) AXIAL_INLINE {
      links.write_difference(terms.drift, i, kinetic_slope(joint, motions[i], h), holding[i]);
    });
    return rnea::InwardResult{rnea::force_on_parent(links, screws, i, h)};
  });
}

/// Whether what went in and what came out are numbers.
template <class Links, class Input, class Q, class V, class Terms>
AXIAL_INLINE constexpr auto status_of(const Links& links, const Input& in, const Q& q, const V& qd,
                                      const Terms& terms) {
  Soundness<typename Links::Scalar> all;
  detail::judge_positions(all, links, in, q);
  for_each_link(links, [&](auto i) AXIAL_INLINE {
    all.number(qd[i]), all.number(terms.momentum[i]), all.number(terms.drift[i]);
  });
  return all.status();
}

/// Whether momenta are those of the joints alone; where not, calls say so, and nothing else is said.
template <class Scene>
inline constexpr bool has_momenta =
    !base_moves<Scene> && !Scene::template has<Underwater> && !Scene::template has<RotorDynamics>;
/// Says it, once for a scene. In fixed point Inputs have said it.
template <class Scene, bool words>
constexpr auto check_momenta() {
  static_assert(words || (!base_moves<Scene> && !Scene::template has<Underwater>),
                "axial: momenta are those of a robot on a fixed base in air; take BaseMotion, FloatingBase and "
                "Underwater out of this scene");
  static_assert(words || !Scene::template has<RotorDynamics>,
                "axial: momenta have no rotors as bodies; take RotorDynamics out of this scene");
}

/// Momenta and drifts over the links of RNEA and of momenta, which differ where links have formats.
struct Terms {
  /// writes them
  template <class Holding, class Links, class Input, class Q, class V, class Result>
  AXIAL_INLINE static constexpr void run(const Holding& at_rest, const Links& links, const Input& in, const Q& q,
                                         const V& qd, Result& terms) {
    auto at = at_rest.read(q);
    auto screws = joint_screws(at_rest, in, at);
    auto holding = at_rest.no_efforts();
    hold(at_rest, in, at, screws, at_rest.read(qd), holding);
    carry(links, in, screws, links.read(qd), at_rest.read(holding), terms);
    terms.status = status_of(links, in, q, qd, terms);
  }
};
/// The same over any links of a scene that has momenta.
template <class Holding, class... Arguments>
AXIAL_INLINE constexpr void run(const Holding& at_rest, Arguments&&... arguments) {
  if constexpr (has_momenta<typename Holding::Scene>) execute<Terms>(at_rest, arguments...);
}

}  // namespace momentum

/// Momenta p = M(q) qd of the joints and their drift C^T qd - g - friction, so that dp/dt = tau + drift + tau_external.
/// Source: De Luca and Mattone 2003, eqs. (3) to (6), computed in O(n): p from the links' momenta, C^T qd = dT/dq (for
/// fixed q and qd as independent variables) from the same pass as -s . (v x* h), without C or dM/dt. No accelerations.
/// In: q (rad or m), qd; `in` as of inverse_dynamics(), a payload and a known wrench included. Out: both terms.
/// The status, which costs nothing where nobody reads it: not_finite where something that goes in or comes out is NaN
/// or infinite, angle_range where sines are not exact, about no joint. In fixed point it names positions, speeds and
/// inputs beyond what is declared (position_limit, speed_limit, payload_limit, input_limit); inside, nothing overflows
/// (formats: fixed/bounds/dynamics.hpp). Cost: doc/guides/observer.md, less than one inverse_dynamics().
template <class S, class T>
[[nodiscard]] constexpr MomentumTerms<S, T> momentum_terms(const Positions<robot_of<S>, T>& q,
                                                           const Velocities<robot_of<S>, T>& qd,
                                                           const Inputs<S, T>& in = no_inputs<S, T>()) {
  momentum::check_momenta<scene_of<S>, detail::is_word<T>>();
  MomentumTerms<S, T> terms{};
  momentum::run(links_of<S, T, BaseParameters>(), links_of<S, T, BaseParameters, recursion::Momenta>(), in, q, qd,
                terms);
  detail::StateCheck<S, T>(in, q, qd).name(terms.status);
  return terms;
}
/// Overload for a run-time model.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr MomentumTerms<M, T> momentum_terms(const Model<N, F...>& model, const Positions<M, T>& q,
                                                           const Velocities<M, T>& qd,
                                                           const Inputs<M, T>& in = no_inputs<M, T>()) {
  momentum::check_momenta<scene_of<M>, detail::is_word<T>>();
  MomentumTerms<M, T> terms{};
  const auto& links = model.template links<T>();
  momentum::run(links, links, in, q, qd, terms);
  return terms;
}

}  // namespace axial

#include <axial/options/end.hpp>
