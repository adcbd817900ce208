// The Automatic Separation Method for any chain: the torque with its terms apart, A qdd + B [qd qd] + C [qd^2] + G.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/mass_matrix.hpp>
#include <axial/links/separated_terms.hpp>
#include <axial/recursion/joint_motions.hpp>
#include <axial/recursion/position_soundness.hpp>
#include <axial/recursion/walks.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace separation {

/// Gravity's stand-in, the acceleration of the base, in a link's frame before and after its own z-screw.
template <class B, class A>
struct LinkGravity {
  B before{};  ///< m/s^2, before it
  A after{};   ///< m/s^2, behind it
  /// This gravity as plain numbers.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return separation::LinkGravity{before.template dense<T>(), after.template dense<T>()};
  }
};
template <class B, class A>
LinkGravity(B, A) -> LinkGravity<B, A>;

/// Gravity of all links, from the base outwards.
template <class Links, class Input, class Screws>
AXIAL_INLINE constexpr auto link_gravities(const Links& links, const Input& in, const Screws& screws) {
  return outward(links, LinkGravity{no_motion(links), base_acceleration(links, in)},
                 [&](auto i, const auto& parent) AXIAL_INLINE {
                   auto link = links.link(i);
                   auto before = to_child(link.x(), link.sum(quantity::GravityAcceleration{}, parent.after));
                   return LinkGravity{link.shape(before), link.shape(to_child(screws[i], before))};
                 });
}

/// Effort of a joint that holds its composite body against gravity.
template <class B, class A>
AXIAL_INLINE constexpr auto weight(Revolute, const B& body, const A& a) {
  return body.first_moment.x * a.y - body.first_moment.y * a.x;
}
/// Prismatic overload.
template <class B, class A>
AXIAL_INLINE constexpr auto weight(Prismatic, const B& body, const A& a) {
  return mass_along_z(body.mass) * a.z;
}

/// Force on the composite body of a joint at unit rate of it alone: the coefficient of qd_i^2.
template <class B>
AXIAL_INLINE constexpr auto square_force(Revolute, const B& body) {
  const auto& h = body.first_moment;
  const auto& j = body.inertia;
  return ForceVector{Vec3{-j.yz, j.xz, Zero{}}, Vec3{-h.x, -h.y, Zero{}}};
}
/// Prismatic overload: none.
template <class B>
AXIAL_INLINE constexpr auto square_force(Prismatic, const B&) {
  return ForceVector<ZeroVec3, ZeroVec3>{};
}

/// Force on the composite body of joint i that the rates of joint i and of a joint inboard give it together, the
/// coefficient of qd_j qd_i: points r of it accelerate with 2 w x (z x r), or 2 w x z where joint i slides. w is the
/// angular part of joint j's motion.
template <class Link, class B, class W>
AXIAL_INLINE constexpr auto product_force(Revolute, const Link& link, const B& body, const W& w) {
  using namespace quantity;
  const auto& j = body.inertia;
  auto hx = body.first_moment.x + body.first_moment.x;
  auto hy = body.first_moment.y + body.first_moment.y;
  auto xy = j.xy + j.xy;
  auto xz = j.xz + j.xz;
  auto yz = j.yz + j.yz;
  auto xx = (j.yy - j.xx) + j.zz;  // second moments, twice
  auto yy = (j.xx - j.yy) + j.zz;
  return ForceVector{
      Vec3{link.sum(Moment{}, w.y * yy, -(w.x * xy), -(w.z * yz)), link.sum(Moment{}, w.y * xy, -(w.x * xx), w.z * xz),
           Zero{}},
      Vec3{link.sum(Force{}, -(w.z * hx)), link.sum(Force{}, -(w.z * hy)), link.sum(Force{}, w.x * hx, w.y * hy)}};
}
/// Prismatic overload.
template <class Link, class B, class W>
AXIAL_INLINE constexpr auto product_force(Prismatic, const Link& link, const B& body, const W& w) {
  using namespace quantity;
  const auto& h = body.first_moment;
  auto x = twice(w.x);
  auto y = twice(w.y);
  return ForceVector{
      Vec3{link.sum(Moment{}, h.z * x), link.sum(Moment{}, h.z * y), link.sum(Moment{}, -(h.x * x), -(h.y * y))},
      Vec3{link.sum(Force{}, mass_across_z(body.mass) * y), link.sum(Force{}, -(mass_across_z(body.mass) * x)),
           Zero{}}};
}

/// Whether the types say that j < m does not hold; else a compiler may look at the pair of a joint with itself.
///@{
template <class J, class M>
inline constexpr bool never_below = false;
template <int J, int M>
inline constexpr bool never_below<Index<J>, Index<M>> = !(J < M);
///@}

/// Sets a coefficient of qd_j qd_i that joint m feels, j and m both inboard of i, and the coefficient that follows from
/// it. As M(a, b) depends on joints beyond the inner one of a and b alone, Christoffel's symbols give
/// b(i; j m) = -b(m; j i) for j inboard of m, c(i; j j) = -b(j; j i) / 2, and nothing for b(i; j i) and c(i; i i).
template <class Terms, class M, class J, class I, class V>
AXIAL_INLINE constexpr void set_product(Terms& terms, M m, J j, I i, const V& value) {
  terms.product(m, j, i, value);
  if constexpr (!never_below<J, M>)
    if (j < m) terms.product(i, j, m, -value);
  if (j == m) terms.square(i, j, -half(value));
}

/// What the joint of link i contributes: its column of A, and all coefficients of products with its rate.
template <class Links, class Bodies, class Motions, class I, class Terms>
AXIAL_INLINE constexpr void joint_terms(const Links& links, const Bodies& bodies, const Motions& motions, I i,
                                        Terms& terms) {
  using crba::unit_force;
  auto link = links.link(i);
  link.on_joint([&](auto kind) AXIAL_INLINE {
    const auto& body = bodies[i].turned;
    auto unit = unit_force(kind, body);
    auto square = square_force(kind, body);
    terms.inertia(i, i, link.sum(quantity::JointInertia{}, along_joint(kind, unit), link.rotor()));
    for_each_ancestor(links, i, [&](auto j) AXIAL_INLINE {
      terms.inertia(j, i, along_motion(motions[j][i], unit));
      terms.square(j, i, along_motion(motions[j][i], square));
      auto product = product_force(kind, link, body, motions[j][i].angular);
      for_each_ancestor(links, i, [&](auto m) AXIAL_INLINE {
        set_product(terms, m, j, i, link.sum(quantity::JointInertia{}, along_motion(motions[m][i], product)));
      });
    });
  });
}

/// Efforts at rest: read off the composite bodies, or by RNEA where the scene has forces from outside.
template <class Links, class Input, class Screws, class Q, class Bodies, class Terms>
AXIAL_INLINE constexpr void rest_terms(const Links& links, const Input& in, const Screws& screws, const Q& q,
                                       const Bodies& bodies, Terms& terms) {
  using Scene = typename Links::Scene;
  if constexpr (Scene::template has<TipWrench> || Scene::template has<ExternalWrenches>) {
    Joints<typename Scene::Robot, typename Links::Scalar> effort{};
    rnea::efforts(links, in, q, screws, NoMotion{}, NoMotion{}, effort);
    for_each_link(links, [&](auto i) AXIAL_INLINE { terms.rest(i, effort[i]); });
  } else {
    auto gravity = link_gravities(links, in, screws);
    for_each_link(links, [&](auto i) AXIAL_INLINE {
      auto link = links.link(i);
      link.on_joint([&](auto kind) AXIAL_INLINE {
        terms.rest(i, link.sum(quantity::JointEffort{}, weight(kind, bodies[i].turned, gravity[i].before),
                               spring_effort(link, q[i])));
      });
    });
  }
}

/// Whether all terms have a place; where not, calls say so, and nothing else is said.
template <class Scene>
inline constexpr bool is_separable =
    !base_moves<Scene> && !Scene::template has<Underwater> && !Scene::template has<RotorDynamics>;
/// Says it, once for a scene; a number system may refuse more. In fixed point Inputs have said what moves the base.
template <class Scene, class T>
constexpr auto check_separable() {
  constexpr bool said = detail::is_word<T>;
  static_assert(said || !base_moves<Scene>,
                "axial: a base that turns adds terms which are linear in the joint rates, and separate() has no place "
                "for them; take BaseMotion or FloatingBase out of the scene, or use inverse_dynamics");
  static_assert(said || !Scene::template has<Underwater>,
                "axial: drag and added mass have no place in the terms of separate(); take Underwater out of the "
                "scene, or use inverse_dynamics, bias_torque and mass_matrix");
  static_assert(said || !Scene::template has<RotorDynamics>,
                "axial: separate() has no rotors as bodies; take RotorDynamics out of the scene, or use "
                "inverse_dynamics, bias_torque and mass_matrix");
  detail::Forms<Scene, T>::template check<recursion::Separation>();
}

/// The algorithm over any form of links. Coefficients that vanish for every q are not set, or set as Zero.
template <class Links, class Input, class Q, class Screws, class Terms>
AXIAL_INLINE constexpr void run(const Links& links, const Input& in, const Q& q, const Screws& screws, Terms& terms) {
  if constexpr (is_separable<typename Links::Scene>) {
    auto bodies = crba::composite_bodies(links, in, screws);
    auto motions = joint_motions(links, screws);
    for_each_link(links, [&](auto i) AXIAL_INLINE { joint_terms(links, bodies, motions, i, terms); });
    rest_terms(links, in, screws, q, bodies, terms);
  }
}

/// Whether coefficients can overflow at positions that judge_positions() finds sound: where run-time inputs are in
/// them, or a model whose constants the compiler does not know.
template <class Scene>
inline constexpr bool inputs_can_overflow =
    !detail::is_described<typename Scene::Robot> || Scene::template has<RuntimeGravity> ||
    Scene::template has<Payload> || Scene::template has<TipWrench> || Scene::template has<ExternalWrenches>;

/// What Out has room for.
template <class Out, class S, class T>
struct Terms {
  /// at q
  template <class Links, class Input, class Q>
  AXIAL_INLINE static constexpr Out run(const Links& links, const Input& in, const Q& q) {
    using Scene = typename Links::Scene;
    Out out{};
    Collected<S, T, typename Links::Scalar, Out> terms{out};
    auto at = links.read(q);
    auto screws = joint_screws(links, in, at);
    if constexpr (!std::is_same_v<Out, Separated<S, T>>) {
      separation::run(links, in, at, screws, terms);
    } else {
      Soundness<typename Links::Scalar> all;
      detail::judge_positions(all, links, in, q);
      if constexpr (inputs_can_overflow<Scene> && is_number_v<typename Links::Scalar>) {
        const Collected<S, T, typename Links::Scalar, Out, typename Links::Scalar> judged{out, {all}};
        separation::run(links, in, at, screws, judged);
      } else {
        separation::run(links, in, at, screws, terms);
      }
      out.status = all.status();
    }
    return out;
  }
};
/// The same over any links of a scene that has them.
template <class Out, class S, class T, class Links, class... Arguments>
AXIAL_INLINE constexpr Out collected(const Links& links, Arguments&&... arguments) {
  if constexpr (is_separable<typename Links::Scene>)
    return execute<Terms<Out, S, T>>(links, arguments...);
  else
    return {};
}

}  // namespace separation

/// The terms of the dynamics at q, with the rotors and the payload that the scene names; its springs and wrenches are
/// in G. Source: the Automatic Separation Method of Djuric et al. 2016, eqs. (26) to (61): accelerations and forces
/// over the basis {qdd_j}, {qd_i qd_j}, {qd_j^2}, {g}; by composite rigid bodies, and Christoffel's symmetries, which
/// the paper does not use. In: q (rad or m). Out: A, B, C, G for torque(), and a status, which costs nothing where
/// nobody reads it: not_finite where q or an input is NaN or infinite, a term overflows, or a slide is so far out
/// (some 1e15 m in float) that it might; angle_range where sines are not exact; it names no joint. In fixed point
/// position_limit names the first slide beyond its limits, where formats wrap; input_limit, payload_limit.
template <class S, class T>
[[nodiscard]] constexpr Separated<S, T> separate(const Positions<robot_of<S>, T>& q,
                                                 const Inputs<S, T>& in = no_inputs<S, T>()) {
  separation::check_separable<scene_of<S>, T>();
  auto all =
      separation::collected<Separated<S, T>, S, T>(links_of<S, T, BaseParameters, recursion::Separation>(), in, q);
  detail::PositionCheck<S, T>::name(all.status, in, q);
  return all;
}
/// A alone, without a status; what B, C and G need alone is not computed.
template <class S, class T>
[[nodiscard]] constexpr SeparatedA<S, T> separate_A(const Positions<robot_of<S>, T>& q,
                                                    const Inputs<S, T>& in = no_inputs<S, T>()) {
  separation::check_separable<scene_of<S>, T>();
  return separation::collected<SeparatedA<S, T>, S, T>(links_of<S, T, BaseParameters, recursion::Separation>(), in, q);
}
/// B alone, without a status.
template <class S, class T>
[[nodiscard]] constexpr SeparatedB<S, T> separate_B(const Positions<robot_of<S>, T>& q,
                                                    const Inputs<S, T>& in = no_inputs<S, T>()) {
  separation::check_separable<scene_of<S>, T>();
  return separation::collected<SeparatedB<S, T>, S, T>(links_of<S, T, BaseParameters, recursion::Separation>(), in, q);
}
/// C alone, without a status.
template <class S, class T>
[[nodiscard]] constexpr SeparatedC<S, T> separate_C(const Positions<robot_of<S>, T>& q,
                                                    const Inputs<S, T>& in = no_inputs<S, T>()) {
  separation::check_separable<scene_of<S>, T>();
  return separation::collected<SeparatedC<S, T>, S, T>(links_of<S, T, BaseParameters, recursion::Separation>(), in, q);
}
/// G alone, without a status.
template <class S, class T>
[[nodiscard]] constexpr SeparatedG<S, T> separate_G(const Positions<robot_of<S>, T>& q,
                                                    const Inputs<S, T>& in = no_inputs<S, T>()) {
  separation::check_separable<scene_of<S>, T>();
  return separation::collected<SeparatedG<S, T>, S, T>(links_of<S, T, BaseParameters, recursion::Separation>(), in, q);
}
/// Overload for a run-time model: all four terms.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr Separated<M, T> separate(const Model<N, F...>& model, const Positions<M, T>& q,
                                                 const Inputs<M, T>& in = no_inputs<M, T>()) {
  separation::check_separable<scene_of<M>, T>();
  return separation::collected<Separated<M, T>, M, T>(model.template links<T>(), in, q);
}

}  // namespace axial

#include <axial/options/end.hpp>
