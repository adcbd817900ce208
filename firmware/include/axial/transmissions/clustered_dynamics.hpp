// Forward dynamics of joints that share drives by articulated bodies over clusters.
#pragma once

#include <axial/dynamics/route.hpp>
#include <axial/transmissions/clustered_bodies.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace clusters {

/// The passes over the links of a robot R whose joints share drives; `Links` are those of its clusters, `Driven` those
/// of its drives.
template <class R, class Driven, class Links>
struct Passes : private Bodies<R, Driven> {
  using Base = Bodies<R, Driven>;                             ///< the inward pass
  static constexpr const auto& g = detail::drive_matrix<R>;   ///< G and q0
  static constexpr const auto& layout = clusters::layout<R>;  ///< which joints are a cluster
  using typename Base::T;                                     ///< the number

  /// Accelerations of the drives under the efforts that `udd` holds at first.
  template <class Input, class Screws, class A>
  AXIAL_INLINE static constexpr auto run(const Links& links, const Input& in, const Screws& screws, A& udd) {
    const TipLoads<typename Links::Scene, Input> loads(in);
    const auto own = [&](auto i) AXIAL_INLINE {
      const auto link = links.link(i);
      const auto body = loads.body(link);
      return Subtree{body, ForceVector<ZeroVec3, ZeroVec3>{}, scale_of(link, body),
                     slots<layout.count>([](auto) { return None{}; })};
    };
    const auto kept = inward(links, own, [&](auto i, const auto& tree) AXIAL_INLINE {
      return Base::propagate_inward(links.link(i), screws[i], i, Base::whole(i, tree, udd), udd);
    });
    Ordinal<T> lost = -1;
    accelerate_base(kept, udd, lost);
    outward(links, MotionVector<ZeroVec3, ZeroVec3>{}, [&](auto i, const auto& parent) AXIAL_INLINE {
      const auto link = links.link(i);
      const auto moved = to_child(screws[i], to_child(link.x(), parent, link), link);
      const auto motion = link.on_joint([&](auto joint) AXIAL_INLINE {
        return aba::with_joint(link, moved, along_axis(joint, acceleration(link, i, kept[i].joint, moved, udd, lost)));
      });
      slots<layout.count>([&](auto c) AXIAL_INLINE { return solve(kept[i].hung[c], c, motion, udd, lost); });
      return motion;
    });
    return aba::status_of<Links>(lost, false);
  }

 private:
  /// Acceleration of link i's joint.
  template <class Link, class I, class J, class M, class A, class Lost>
  AXIAL_INLINE static constexpr auto acceleration(const Link& link, I, const J& joint, const M& moved, A& udd,
                                                  Lost& lost) {
    if constexpr (layout.number[I::value] < 0) {
      constexpr int k = g.drive_of(I::value);
      Truth<T> singular = joint.singular;
      const auto own = joint_acceleration(link, joint.free, joint.gain, moved, joint.left, singular);
      udd[k] = static_cast<T>(own);
      lost = first_found(lost, singular, k);
      return own;
    } else {
      return moved_by<I::value>(udd);
    }
  }
  template <int I, class A>
  AXIAL_INLINE static constexpr auto moved_by(const A& udd) {
    return driven::sum_of<g.drives>(
        [&](auto k) AXIAL_INLINE { return Base::template ratio<I, decltype(k)::value>() * udd[k]; });
  }

  /// Accelerations of the drives of cluster c, whose carrier moves so.
  template <class C, class M, class A, class Lost>
  AXIAL_INLINE static constexpr None solve(None, C, const M&, A&, Lost&) {
    return {};
  }
  template <class... S, class C, class M, class A, class Lost>
  AXIAL_INLINE static constexpr None solve(const Slots<S...>& solved, C, const M& carrier, A& udd, Lost& lost) {
    slots<sizeof...(S)>([&](auto k) AXIAL_INLINE {
      constexpr int drive = layout.drive[C::value][decltype(k)::value];
      const auto& own = solved[k];
      udd[drive] = static_cast<T>(where_left<T>(
          own.left, own.free - gain_times(own.gain, carrier) - before<C::value, decltype(k)::value>(own.gains, udd),
          Zero{}));
      lost = first_found(lost, Truth<T>(own.singular), drive);
      return None{};
    });
    return {};
  }
  template <int C, int K, class G, class A>
  AXIAL_INLINE static constexpr auto before(const G& gains, const A& udd) {
    return driven::sum_of<K>([&](auto l) AXIAL_INLINE { return gains[l] * udd[layout.drive[C][decltype(l)::value]]; });
  }

  /// Clusters that hang on the base, which is at rest.
  template <class Kept, class A, class Lost>
  AXIAL_INLINE static constexpr void accelerate_base(const Kept& kept, A& udd, Lost& lost) {
    slots<layout.count>([&](auto c) AXIAL_INLINE {
      constexpr int number = decltype(c)::value;
      if constexpr (layout.carrier[number] < 0) {
        const auto closed = Base::template eliminated<number>(nothing(), ForceVector<ZeroVec3, ZeroVec3>{},
                                                              of_roots<number>(kept), udd);
        solve(closed.solved, c, MotionVector<ZeroVec3, ZeroVec3>{}, udd, lost);
      }
      return None{};
    });
  }
  AXIAL_INLINE static constexpr auto nothing() { return articulated(RigidInertia{Zero{}, ZeroVec3{}, Sym3<Zero>{}}); }
  /// What all links on the base leave to cluster C.
  template <int C, int I = 0, class Kept>
  AXIAL_INLINE static constexpr auto of_roots(const Kept& kept) {
    if constexpr (I == R::chain.size)
      return None{};
    else if constexpr (R::chain.parent(I) < 0)
      return detail::loaded(kept[Index<I>{}].on_parent.open[Index<C>{}], of_roots<C, I + 1>(kept));
    else
      return of_roots<C, I + 1>(kept);
  }
};

}  // namespace clusters

namespace detail {
/// Whether clusters cost less, by counts of chains of ten joints (tests/property/drives/drive_clusters_test.cpp): a
/// cluster that carries others costs 34 operations per joint more than as many joints by themselves, and 45 for each
/// ratio that is not 1 or -1; one at a tip nothing; a rotor of a joint's own 35. With composite bodies a coupled joint
/// adds 30.
template <class Scene>
constexpr bool clusters_cost_less() {
  using Robot = typename SceneOfClusters<Scene>::Robot;
  constexpr auto& layout = clusters::layout<Robot>;
  constexpr auto& g = drive_matrix<Robot>;
  auto cost = unrolled_cost<JointCoordinates<Robot>>();
  bool carries[Robot::chain.size] = {};
  for (int i = 0; i < Robot::chain.size; ++i)
    if (const int p = Robot::chain.parent(i); p >= 0 && layout.number[p] >= 0 && layout.number[p] != layout.number[i])
      carries[layout.number[p]] = true;
  for (int i = 0; i < Robot::chain.size; ++i) {
    const bool plain = layout.number[i] < 0;
    const bool rotor = Scene::template has<RotorInertia> && Robot::chain.links[i].rotor_inertia > 0.0;
    int products = 0;
    for (int k = 0; k < g.drives; ++k)
      products += g.is_moved(i, k) && g.ratio[i][k] != 1.0 && g.ratio[i][k] != -1.0 ? 1 : 0;
    cost.articulated += plain ? (rotor ? 35 : 0) : carries[layout.number[i]] ? 34 + 45 * products : 0;
    cost.composite += plain ? 0 : 30;
  }
  return cost.articulated < cost.composite;
}

/// Route where joints share drives.
template <class Scene>
constexpr Route driven_route() {
  constexpr bool articulated = Scene::template has<ArticulatedBody> || Scene::template has<SplitArticulatedBody>;
  static_assert(!(articulated && (Scene::template has<Looped> || Scene::template has<Underwater> ||
                                  Scene::template has<FloatingBase>)),
                "axial: joints that share drives are solved by articulated bodies over clusters where links are "
                "unrolled, in air, on a base that does not float; take ArticulatedBody or SplitArticulatedBody out");
  if constexpr (articulated)
    return Route::split_articulated_body;
  else if constexpr (Scene::template has<CompositeBody> || Scene::template has<Looped> ||
                     Scene::template has<Underwater> || Scene::template has<RotorDynamics> ||
                     Scene::template has<FloatingBase>)
    return Route::composite_body;
  else
    return clusters_cost_less<Scene>() ? Route::split_articulated_body : Route::composite_body;
}
template <class R, class... Features>
inline constexpr Route scene_route<Scene<DriveCoordinates<R>, Features...>> =
    driven_route<Scene<DriveCoordinates<R>, Features...>>();
}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
