// Articulated bodies over clusters of joints: what a link leaves to its parent.
#pragma once

#include <axial/transmissions/drive_clusters.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace clusters {

/// What the outward pass needs of a link, and what its parent bears.
template <class H, class J, class S>
struct Kept {
  H hung{};       ///< solutions of the clusters that hang on it: slots, None where one does not
  J joint{};      ///< a Reflection's gain and the like of a plain joint, or None
  S on_parent{};  ///< a Subtree, in the parent's frame
};
template <class H, class J, class S>
Kept(H, J, S) -> Kept<H, J, S>;
/// What is kept of a joint whose drive is its own.
template <class G, class U, class B, class L>
struct PlainJoint {
  G gain{};      ///< K = U / D
  U free{};      ///< u / D
  B singular{};  ///< whether D is lost in rounding
  L left{};      ///< whether anything is left of D
};
template <class G, class U, class B, class L>
PlainJoint(G, U, B, L) -> PlainJoint<G, U, detail::Decided<B>, L>;

/// From the tips to the base, over the links of a robot R whose joints share drives; `Driven` are those of its drives.
template <class R, class Driven>
struct Bodies {
  using T = typename Driven::Scalar;                          ///< the number
  static constexpr const auto& g = detail::drive_matrix<R>;   ///< G and q0
  static constexpr const auto& layout = clusters::layout<R>;  ///< which joints are a cluster

  /// G(I, K).
  template <int I, int K>
  AXIAL_INLINE static constexpr auto ratio() {
    return literal<T>([] { return g.ratio[I][K]; });
  }
  /// Ratio of the k-th drive of cluster C.
  template <int I, int C, int K>
  AXIAL_INLINE static constexpr auto ratio_in() {
    return ratio<I, layout.drive[C][K]>();
  }

  /// A subtree with the clusters that hang on link I closed.
  template <class S, class H>
  struct Whole {
    S tree;  ///< a Subtree
    H hung;  ///< slots: solutions of the drives of each
  };
  template <class S, class H>
  Whole(S, H) -> Whole<S, H>;

  /// Link I's subtree with the clusters that hang on it closed.
  template <class I, class Tree, class A>
  AXIAL_INLINE static constexpr auto whole(I, const Tree& tree, const A& efforts) {
    return close<0, I::value>(tree, slots<0>([](auto) { return None{}; }), efforts);
  }
  /// Link I's subtree with the clusters from C on that hang on it closed.
  template <int C, int I, class Tree, class Hung, class A>
  AXIAL_INLINE static constexpr auto close(const Tree& tree, const Hung& hung, const A& efforts) {
    if constexpr (C == layout.count) {
      return Whole{tree, hung};
    } else if constexpr (layout.carrier[C] == I) {
      const auto closed = eliminated<C>(as_articulated(tree.inertia), tree.force, tree.open[Index<C>{}], efforts);
      const auto open = slots<layout.count>([&](auto c) AXIAL_INLINE {
        if constexpr (decltype(c)::value == C)
          return None{};
        else
          return tree.open[c];
      });
      return close<C + 1, I>(Subtree{closed.inertia, closed.force, tree.scale, open}, appended(hung, closed.solved),
                             efforts);
    } else {
      return close<C + 1, I>(tree, appended(hung, None{}), efforts);
    }
  }
  /// Slots with one more.
  template <class... V, class Next>
  AXIAL_INLINE static constexpr auto appended(const Slots<V...>& all, const Next& next) {
    return slots<sizeof...(V) + 1>([&](auto c) AXIAL_INLINE {
      if constexpr (decltype(c)::value == sizeof...(V))
        return next;
      else
        return all[c];
    });
  }
  /// The carrier of cluster C with its drives eliminated, under efforts of the drives.
  template <int C, class I, class P, class O, class A>
  AXIAL_INLINE static constexpr auto eliminated(const I& inertia, const P& force, const O& open, const A& efforts) {
    constexpr int n = layout.drives[C];
    const auto rotor = [](auto k) AXIAL_INLINE {
      return Driven::drives().link(Index<layout.drive[C][decltype(k)::value]>{}).rotor();
    };
    const auto d = slots<entry(n, 0)>([&](auto at) AXIAL_INLINE {
      constexpr int k = row_of(decltype(at)::value);
      if constexpr (column_of(decltype(at)::value) == k)
        return open.inertia[at] + rotor(Index<k>{});
      else
        return open.inertia[at];
    });
    const auto u = slots<n>(
        [&](auto k) AXIAL_INLINE { return efforts[layout.drive[C][decltype(k)::value]] - open.actuator_effort[k]; });
    const auto scales = slots<n>([&](auto k) AXIAL_INLINE { return open.scales[k] + rotor(k); });
    return Elimination<n - 1, T>::of(inertia, force, open.forces, d, u, scales);
  }

  /// Link i's joint: reflects the subtree, or adds to its cluster and passes on.
  template <class Link, class Screw, class I, class W, class A>
  AXIAL_INLINE static constexpr auto propagate_inward(const Link& link, const Screw& screw, I, const W& whole,
                                                      const A& efforts) {
    return link.on_joint([&](auto joint) AXIAL_INLINE {
      const auto& tree = whole.tree;
      const auto scale = seen_from(tree.scale, shift_length(link.x()) + shift_length(screw));
      if constexpr (layout.number[I::value] < 0) {
        constexpr int k = g.drive_of(I::value);
        const auto r = reflection(joint, link, as_articulated(tree.inertia), tree.force,
                                  MotionVector<ZeroVec3, ZeroVec3>{}, efforts[k], singularity_scale(joint, tree.scale));
        return Kept{whole.hung, PlainJoint{r.gain, r.free, r.singular, r.left},
                    Subtree{on_parent(link, screw, r.inertia), on_parent(link, screw, r.bias), scale, tree.open}};
      } else {
        constexpr int c = layout.number[I::value];
        const auto force = crba::unit_force(joint, tree.inertia);
        const auto open = slots<layout.count>([&](auto other) AXIAL_INLINE {
          if constexpr (decltype(other)::value == c)
            return on_parent(link, screw, with_joint<I::value, c>(joint, tree, force));
          else
            return tree.open[other];
        });
        return Kept{whole.hung, None{},
                    Subtree{on_parent(link, screw, tree.inertia), on_parent(link, screw, tree.force), scale, open}};
      }
    });
  }
  /// A quantity of the link in the parent's frame.
  template <class Link, class Screw, class V>
  AXIAL_INLINE static constexpr auto on_parent(const Link& link, const Screw& screw, const V& v) {
    return to_parent(link.x_inboard(), to_parent(screw, v, link), link.outer());
  }
  /// The forces of a cluster; the rest of it has no frame.
  template <class Link, class Screw, class F, class D, class U, class S>
  AXIAL_INLINE static constexpr auto on_parent(const Link& link, const Screw& screw, const Open<F, D, U, S>& open) {
    return forces_on_parent(link, screw, open.forces, open);
  }
  /// The forces of a cluster in the parent's frame, drive by drive.
  template <class Link, class Screw, class... F, class O>
  AXIAL_INLINE static constexpr auto forces_on_parent(const Link& link, const Screw& screw, const Slots<F...>& forces,
                                                      const O& open) {
    return Open{slots<sizeof...(F)>([&](auto k) AXIAL_INLINE { return on_parent(link, screw, forces[k]); }),
                open.inertia, open.actuator_effort, open.scales};
  }
  /// Cluster C with joint I, whose subtree needs `force` for a unit acceleration of it.
  template <int I, int C, class Joint, class Tree, class F>
  AXIAL_INLINE static constexpr auto with_joint(Joint joint, const Tree& tree, const F& force) {
    constexpr int n = layout.drives[C];
    const auto& open = opened<n>(tree.open[Index<C>{}]);
    const auto forces = slots<n>(
        [&](auto k) AXIAL_INLINE { return open.forces[k] + times(ratio_in<I, C, decltype(k)::value>(), force); });
    const auto inertia = slots<entry(n, 0)>([&](auto at) AXIAL_INLINE {
      constexpr int k = row_of(decltype(at)::value), l = column_of(decltype(at)::value);
      return open.inertia[at] + ratio_in<I, C, k>() * along_joint(joint, forces[Index<l>{}]) +
             ratio_in<I, C, l>() * along_joint(joint, open.forces[Index<k>{}]);
    });
    const auto actuator_effort = slots<n>([&](auto k) AXIAL_INLINE {
      return open.actuator_effort[k] + ratio_in<I, C, decltype(k)::value>() * along_joint(joint, tree.force);
    });
    // M of a drive is at most that of its joints, by Cauchy and Schwarz: their number times the sum of squares.
    const auto scales = slots<n>([&](auto k) AXIAL_INLINE {
      constexpr int drive = layout.drive[C][decltype(k)::value];
      return open.scales[k] + literal<T>([] {
                                return layout.joints_of_drive[drive] * g.ratio[I][drive] * g.ratio[I][drive];
                              }) * singularity_scale(joint, tree.scale);
    });
    return Open{forces, inertia, actuator_effort, scales};
  }
};

}  // namespace clusters
}  // namespace axial

#include <axial/options/end.hpp>
