// Forward dynamics in the split form: the bias torque by RNEA, then the structure at rest under what is left of tau.
// That structure, weightless and free of outside forces, and its answer to efforts alone serve any number of drives.
#pragma once

#include <axial/base/water.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/recursion/forward_result.hpp>
#include <axial/recursion/joint_screws.hpp>
#include <axial/recursion/loads.hpp>
#include <axial/recursion/reflection.hpp>
#include <axial/recursion/stages.hpp>
#include <axial/spatial/articulated_congruence.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace aba {

/// A subtree's inertia and the scale of its singularity.
template <class I, class R>
struct SubtreeInertia {
  I inertia{};  ///< an ArticulatedInertia
  R scale{};    ///< a CompositeScale, or Unscaled
  /// This inertia and scale as numbers, each quantity in the form in which T keeps it.
  template <class T>
  AXIAL_INLINE constexpr auto dense() const {
    return aba::SubtreeInertia{inertia.template dense<T>(), scale.template dense<T>()};
  }
};
template <class I, class R>
SubtreeInertia(I, R) -> SubtreeInertia<I, R>;
/// Two subtrees of one link as one.
template <class I, class R, class J, class S>
AXIAL_INLINE constexpr auto operator+(const SubtreeInertia<I, R>& a, const SubtreeInertia<J, S>& b) {
  return SubtreeInertia{a.inertia + b.inertia, a.scale + b.scale};
}
/// A subtree with the mass of the water that moves with its link.
template <class Water, class W>
AXIAL_INLINE constexpr auto submerged(const Water& water, const W& subtree) {
  return SubtreeInertia{subtree.inertia + water.inertia(), subtree.scale + scale_of_water(water)};
}
/// Overload for a dry link: the subtree as it was.
template <class W>
AXIAL_INLINE constexpr const W& submerged(const Dry&, const W& subtree) {
  return subtree;
}

/// What the structure keeps of a joint: its gain K, D and 1/D; and what its parent bears.
template <class K, class D, class R, class B, class L, class W>
struct AtRest {
  K gain{};        ///< k = U / D
  D resistance{};  ///< D, kg m^2 or kg
  R inverse{};     ///< 1 / D
  B singular{};    ///< whether D is lost in rounding
  L left{};        ///< whether anything is left of D: the joint is held if not
  W on_parent{};   ///< weight that its parent bears, in the parent's frame
};
template <class K, class D, class R, class B, class L, class W>
AtRest(K, D, R, B, L, W) -> AtRest<K, D, R, detail::Decided<B>, L, W>;

/// A step of a pass as f(kind of the joint, i, link i, ...). Where a kind is a type nothing is called in between.
template <class Links, class F>
struct ByJoint {
  const Links& links;  ///< of the scene
  const F& f;          ///< the step

  /// the step of link i
  template <class I, class... X>
  AXIAL_INLINE constexpr auto operator()(I i, const X&... x) const {
    auto link = links.link(i);
    if constexpr (Links::unrolled)
      return f(detail::KindOfJoint<decltype(link)>{}, i, link, x...);
    else
      return link.on_joint([&](auto joint) AXIAL_INLINE { return f(joint, i, link, x...); });
  }
};
template <class Links, class F>
ByJoint(const Links&, const F&) -> ByJoint<Links, F>;

/// The structure at the joint screws, from the tips to the base.
template <class Links, class Input, class Screws>
AXIAL_INLINE constexpr auto structure_at_rest(const Links& links, const Input& in, const Screws& screws) {
  const TipLoads<typename Links::Scene, Input> loads(in);
  auto own = [&](auto i) AXIAL_INLINE {
    auto link = links.link(i);
    auto body = loads.body(link);
    return link.shape(
        submerged(water_about(links, i), SubtreeInertia{link.formatted(articulated(body)), scale_of(link, body)}));
  };
  auto reflect = [&](auto joint, auto i, const auto& link, const auto& tree) AXIAL_INLINE {
    auto x = link.x_inboard();
    auto h = hinge(joint, link, tree.inertia, singularity_scale(joint, tree.scale));
    SubtreeInertia on_parent{to_parent(x, to_parent(screws[i], h.inertia, link), link.outer()),
                             seen_from(tree.scale, shift_length(x) + shift_length(screws[i]))};
    return AtRest{link.shape(h.gain),   link.shape(h.resistance), link.shape(h.inverse), h.singular, h.left,
                  link.shape(on_parent)};
  };
  if constexpr (detail::stages_apart<Links>) {
    return detail::called([&]() AXIAL_INLINE {  // a frame of its own holds what parents bear
      auto all = detail::inward_by_steps(links, own, ByJoint{links, reflect});
      return map_links(links, [&](auto i) AXIAL_INLINE {
        const auto& left = all[i];
        return AtRest{left.gain, left.resistance, left.inverse, left.singular, left.left, detail::NoLoad{}};
      });
    });
  } else {
    return inward(links, own, ByJoint{links, reflect});
  }
}

/// What the outward pass needs of a joint's drive, and what the parent gets.
template <class U, class B, class F>
struct Driven {
  U free{};       ///< u / D, rad/s^2 or m/s^2
  B lost{};       ///< whether D is lost, or the drive is beyond its format
  F on_parent{};  ///< N m and N, on the parent, in its frame
};
template <class U, class B, class F>
Driven(U, B, F) -> Driven<U, B, F>;

/// Nothing to watch: numbers that do not leave their range.
struct Unwatched {
  /// looks at nothing
  template <class... V>
  AXIAL_INLINE constexpr void operator()(const V&...) {}
  AXIAL_INLINE static constexpr Zero magnified() { return {}; }  ///< the drive is taken as it is
};

/// Accelerations of the structure under efforts alone; take(i, qdd_i) gets one per joint. `watch` sees every vector on
/// the way. Returns the first joint that is near singular or beyond its formats, or -1.
template <class Links, class Screws, class Structure, class Drive, class Watch, class Take>
AXIAL_INLINE constexpr auto respond(const Links& links, const Screws& screws, const Structure& structure,
                                    const Drive& drive, Watch& watch, const Take& take) {
  using T = typename Links::Scalar;
  auto nothing = [&](auto i) AXIAL_INLINE { return links.link(i).shape(ForceVector<ZeroVec3, ZeroVec3>{}); };
  auto pass = [&](auto joint, auto i, const auto& link, const auto& force) AXIAL_INLINE {
    Truth<T> lost = structure[i].singular;
    auto passed = passage(joint, link, structure[i], no_bias_products, force, drive[i], watch.magnified(), lost);
    auto turned = to_parent(screws[i], passed.bias, link);
    auto on_parent = to_parent(link.x_inboard(), turned, link.outer());
    watch(passed.bias, turned, on_parent, passed.free);
    return Driven{link.shape(passed.free), lost, link.shape(on_parent)};
  };
  auto forces = inward(links, nothing, ByJoint{links, pass});
  Ordinal<T> first = -1;
  outward(links, MotionVector<ZeroVec3, ZeroVec3>{}, [&](auto i, const auto& parent) AXIAL_INLINE {
    auto link = links.link(i);
    auto across = to_child(link.x(), parent, link);
    auto moved = with_joint(link, to_child(screws[i], across, link), MotionVector<ZeroVec3, ZeroVec3>{});
    Truth<T> lost = forces[i].lost;
    auto answer = link.on_joint([&](auto joint) AXIAL_INLINE {
      auto own = joint_acceleration(link, forces[i].free, structure[i].gain, moved, structure[i].left, lost);
      auto motion = with_joint(link, moved, along_axis(joint, own));
      watch(across, moved, own, motion);
      take(i, own);
      return link.shape(motion);
    });
    first = first_found(first, lost, static_cast<int>(i));
    return answer;
  });
  return first;
}

}  // namespace aba
namespace aba {

/// One answer in numbers of unlimited range, each acceleration as it comes.
struct PlainAnswer {
  /// Writes the accelerations under tau - bias.
  template <class Links, class Screws, class Structure, class Tau, class Bias, class A>
  AXIAL_INLINE static constexpr auto of(const Links& links, const Screws& screws, const Structure& structure,
                                        const Tau& tau, const Bias& bias, A& qdd) {
    auto drive = map_links(links, [&](auto i) AXIAL_INLINE { return tau[i] - bias[i]; });
    Unwatched watch;
    const auto lost = respond(links, screws, structure, drive, watch,
                              [&](auto i, const auto& own) AXIAL_INLINE { links.write(qdd, i, own); });
    return status_of<Links>(lost, false);
  }
};

/// How the structure answers what drives it, over links that compute by `Scalar`; a number system with formats has its
/// own way.
template <class Scalar>
struct SplitAnswer {
  /// the way over these links
  template <class Links>
  using Over = PlainAnswer;
};

/// The algorithm over any form of links; `bias_links` are those of the bias torque, which may be of base parameters.
struct SplitForm {
  /// status of the accelerations that it writes
  template <class Links, class BiasLinks, class Input, class Q, class V, class Tau, class A>
  AXIAL_INLINE static constexpr auto run(const Links& links, const BiasLinks& bias_links, const Input& in, const Q& q,
                                         const V& qd, const Tau& tau, A& qdd) {
    auto at = links.read(q);
    auto screws = joint_screws(links, in, at);
    auto bias = bias_links.no_efforts();
    if constexpr (detail::stages_apart<Links>)
      detail::called([&]()
                         AXIAL_INLINE { rnea::efforts(bias_links, in, at, screws, links.read(qd), NoMotion{}, bias); });
    else
      rnea::efforts(bias_links, in, at, screws, links.read(qd), NoMotion{}, bias);
    auto structure = structure_at_rest(links, in, screws);
    auto given = links.read(tau);
    auto left = links.read(bias);
    using Answer = typename SplitAnswer<typename Links::Scalar>::template Over<Links>;
    return Answer::of(links, screws, structure, given, left, qdd);
  }
};

}  // namespace aba
}  // namespace axial

#include <axial/options/end.hpp>
