// Articulated bodies over clusters: joints that share drives are one joint of several degrees of freedom, with a small
// dense D of its drives (constraint embedding: Jain 2012; Chignoli, Adrian, Kim and Wensing 2023). The structure at
// rest.
#pragma once

#include <axial/dynamics/free_response.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/robot/drive_clusters.hpp>
#include <axial/transmissions/driven_links.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace clusters {

/// The clusters of a robot's joints.
template <class R>
inline constexpr auto layout = [] {
  constexpr int n = R::chain.size;
  int parents[n] = {};
  for (int i = 0; i < n; ++i)
    parents[i] = R::chain.parent(i);
  return drive_clusters(parents, detail::drive_matrix<R>);
}();

/// f(Index<0>{}) ... as slots, `count` of them.
///@{
template <class F, int... I>
AXIAL_INLINE constexpr auto slots_of(const F& f, std::integer_sequence<int, I...>) {
  return Slots<std::decay_t<decltype(f(Index<I>{}))>...>{{{f(Index<I>{})}...}};
}
template <int count, class F>
AXIAL_INLINE constexpr auto slots(const F& f) {
  return slots_of(f, std::make_integer_sequence<int, count>{});
}
///@}
/// Entries of a lower triangle, row by row: index of an entry, and back.
constexpr int entry(int k, int l) { return k * (k + 1) / 2 + l; }
/// Row of an entry of a lower triangle.
constexpr int row_of(int at) {
  int k = 0;
  while (entry(k + 1, 0) <= at)
    ++k;
  return k;
}
/// Column of an entry of a lower triangle.
constexpr int column_of(int at) { return at - entry(row_of(at), 0); }

/// A force times a number.
template <class G, class N, class F>
AXIAL_INLINE constexpr auto times(const G& g, const ForceVector<N, F>& f) {
  return ForceVector{g * f.moment, g * f.force};
}
/// An inertia in its 6x6 form.
template <class I>
AXIAL_INLINE constexpr const I& as_articulated(const I& inertia) {
  return inertia;
}
/// Overload for a rigid body.
template <class M, class H, class J>
AXIAL_INLINE constexpr auto as_articulated(const RigidInertia<M, H, J>& body) {
  return articulated(body);
}

using None = detail::NoLoad;  ///< no joint of a cluster in a subtree
/// What a subtree leaves to a cluster whose joints are partly in it, a value a drive.
template <class F, class D, class U, class S>
struct Open {
  F forces;           ///< that its links need for a unit acceleration of each drive, in the frame at hand
  D inertia;          ///< of the drives so far: lower triangle
  U actuator_effort;  ///< effort that each feels of forces on the links
  S scales;           ///< bounds of the composite inertia
};
template <class F, class D, class U, class S>
Open(F, D, U, S) -> Open<F, D, U, S>;
/// A cluster of which no joint is in a subtree yet.
template <int drives>
AXIAL_INLINE constexpr auto opened(None) {
  const auto zeros = [](auto) { return Zero{}; };
  return Open{slots<drives>([](auto) { return ForceVector<ZeroVec3, ZeroVec3>{}; }), slots<entry(drives, 0)>(zeros),
              slots<drives>(zeros), slots<drives>(zeros)};
}
/// Overload for a cluster that has joints there already: as it was.
template <int, class F, class D, class U, class S>
AXIAL_INLINE constexpr const auto& opened(const Open<F, D, U, S>& open) {
  return open;
}

/// Sum, slot by slot.
template <class... V, class... W>
AXIAL_INLINE constexpr auto sum(const Slots<V...>& a, const Slots<W...>& b) {
  return slots<sizeof...(V)>([&](auto k) AXIAL_INLINE { return a[k] + b[k]; });
}
/// What two subtrees of one link leave to a cluster.
template <class A, class B, class C, class D, class E, class F, class G, class H>
AXIAL_INLINE constexpr auto operator+(const Open<A, B, C, D>& a, const Open<E, F, G, H>& b) {
  return Open{sum(a.forces, b.forces), sum(a.inertia, b.inertia), sum(a.actuator_effort, b.actuator_effort),
              sum(a.scales, b.scales)};
}
/// Two inertias of one frame as one.
template <class A, class B>
AXIAL_INLINE constexpr auto both(const A& a, const B& b) {
  return as_articulated(a) + as_articulated(b);
}
/// Rigid bodies stay rigid.
template <class A, class B, class C, class D, class E, class F>
AXIAL_INLINE constexpr auto both(const RigidInertia<A, B, C>& a, const RigidInertia<D, E, F>& b) {
  return a + b;
}

/// What a link bears: inertia, force, scale, and clusters that are not whole yet.
template <class I, class P, class R, class O>
struct Subtree {
  I inertia;  ///< rigid as long as it can be, else articulated
  P force;    ///< N m and N
  R scale;    ///< a CompositeScale
  O open;     ///< slots, one per cluster
};
template <class I, class P, class R, class O>
Subtree(I, P, R, O) -> Subtree<I, P, R, O>;
/// Two subtrees of one link as one.
template <class A, class B, class C, class D, class E, class F, class G, class... H>
AXIAL_INLINE constexpr auto operator+(const Subtree<A, B, C, D>& a, const Subtree<E, F, G, Slots<H...>>& b) {
  return Subtree{both(a.inertia, b.inertia), a.force + b.force, a.scale + b.scale,
                 slots<sizeof...(H)>([&](auto c) AXIAL_INLINE { return detail::loaded(a.open[c], b.open[c]); })};
}

/// What is kept of a drive of a cluster.
template <class U, class K, class G, class B, class L>
struct Solution {
  U free;      ///< acceleration if neither the carrier nor the drives before it moved
  K gain;      ///< force over D: what the carrier's acceleration takes of it
  G gains;     ///< what accelerations of the drives before it take of it
  B singular;  ///< whether D is lost in rounding
  L left;      ///< whether anything is left of D: the drive is held if not
};
template <class U, class K, class G, class B, class L>
Solution(U, K, G, B, L) -> Solution<U, K, G, detail::Decided<B>, L>;

/// A carrier's inertia and force with a whole cluster on it, and the solutions of its drives.
template <class I, class P, class S>
struct Closed {
  I inertia;  ///< an ArticulatedInertia
  P force;    ///< N m and N
  S solved;   ///< slots, a Solution a drive
};
template <class I, class P, class S>
Closed(I, P, S) -> Closed<I, P, S>;

/// s - a b^T, which is symmetric.
template <class S, class A, class B>
AXIAL_INLINE constexpr auto less_product(const S& s, const A& a, const B& b) {
  return Sym3{s.xx - a.x * b.x, s.yy - a.y * b.y, s.zz - a.z * b.z,
              s.xy - a.x * b.y, s.xz - a.x * b.z, s.yz - a.y * b.z};
}
/// An inertia without what a drive takes: less f k^T, f the force for a unit of the drive, k that over D.
template <class I, class F, class K>
AXIAL_INLINE constexpr auto reflected(const I& i, const F& f, const K& k) {
  const auto row = [&](const auto& r, const auto& x) AXIAL_INLINE {
    return Vec3{r.x - x * k.linear.x, r.y - x * k.linear.y, r.z - x * k.linear.z};
  };
  return ArticulatedInertia{
      less_product(i.angular, f.moment, k.angular),
      Mat3{row(i.coupling.x, f.moment.x), row(i.coupling.y, f.moment.y), row(i.coupling.z, f.moment.z)},
      less_product(i.linear, f.force, k.linear)};
}

/// Eliminates the drives of a cluster, the last one first.
template <int K, class T>
struct Elimination {
  /// Inertia and force of the carrier, and what is kept of each drive.
  template <class I, class P, class F, class D, class U, class S>
  AXIAL_INLINE static constexpr auto of(const I& inertia, const P& force, const F& forces, const D& d, const U& u,
                                        const S& scales) {
    constexpr Index<K> last{};
    const auto [inverse, singular, left] = resistance(T(d[Index<entry(K, K)>{}]), T(scales[last]));
    const auto& f = forces[last];
    const MotionVector gain{inverse * f.moment, inverse * f.force};
    const auto gains = slots<K>([&, inverse = inverse](auto l)
                                    AXIAL_INLINE { return inverse * d[Index<entry(K, decltype(l)::value)>{}]; });
    const auto free = inverse * u[last];
    const auto rest =
        Elimination<K - 1, T>::of(reflected(inertia, f, gain), force + times(free, f),
                                  slots<K>([&](auto l) AXIAL_INLINE { return forces[l] - times(gains[l], f); }),
                                  slots<entry(K, 0)>([&](auto at) AXIAL_INLINE {
                                    constexpr int n = decltype(at)::value;
                                    return d[at] - gains[Index<row_of(n)>{}] * d[Index<entry(K, column_of(n))>{}];
                                  }),
                                  slots<K>([&](auto l) AXIAL_INLINE { return u[l] - gains[l] * u[last]; }), scales);
    const Solution own{free, gain, gains, singular, left};
    return Closed{rest.inertia, rest.force, slots<K + 1>([&](auto k) AXIAL_INLINE {
                    if constexpr (decltype(k)::value == K)
                      return own;
                    else
                      return rest.solved[k];
                  })};
  }
};
/// Elimination of no drive: the end of the recursion.
template <class T>
struct Elimination<-1, T> {
  /// inertia and force, as they are
  template <class I, class P, class F, class D, class U, class S>
  AXIAL_INLINE static constexpr auto of(const I& inertia, const P& force, const F&, const D&, const U&, const S&) {
    return Closed{inertia, force, Slots<>{}};
  }
};

}  // namespace clusters
}  // namespace axial

#include <axial/options/end.hpp>
