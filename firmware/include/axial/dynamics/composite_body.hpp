// Forward dynamics by composite bodies: M(q) qdd = tau - bias, eliminated from the tips along the branches of the tree.
#pragma once

#include <axial/dynamics/elimination_loss.hpp>
#include <axial/dynamics/mass_matrix.hpp>
#include <axial/recursion/reflection.hpp>
#include <axial/recursion/walks.hpp>
#include <axial/scene/status.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace crba {

/// Which entries of M (lower triangle), and of its elimination, are not zero by structure.
template <int N>
struct Structure {
  bool present[N][N] = {};  ///< by row and column

  constexpr void set(int, int, Zero) {}  ///< what is zero by type stays absent
  /// Anything else is present.
  template <class V>
  constexpr void set(int i, int j, const V&) {
    present[i][j] = true;
  }
  /// Adds what eliminating the joints from the last one on fills in.
  constexpr void fill() {
    for (int k = N; k-- > 0;)
      for (int i = k; i-- > 0;)
        for (int j = 0; j <= i; ++j)
          present[i][j] = present[i][j] || (present[k][i] && present[k][j]);
  }
};

/// Found by types alone, so at any q: the compiler runs CRBA once over zeros.
template <class Links>
constexpr auto structure_of() {
  using Scene = typename Links::Scene;
  constexpr StaticLinks<Scene, double, typename Links::Parameters> links;
  Structure<Links::capacity> structure;
  entries(links, Inputs<Scene, double>{}, map_links(links, [&](auto i) { return links.link(i).z(0.0); }), structure);
  structure.fill();
  return structure;
}
/// Structure of the matrix of these links.
template <class Links>
inline constexpr auto structure = structure_of<Links>();

/// True by type where M(i, j) or what the elimination makes of it is zero by structure.
template <class Links, class I, class J>
AXIAL_INLINE constexpr auto is_absent(I, J) {
  if constexpr (Links::unrolled)
    return std::bool_constant<!structure<Links>.present[I::value][J::value]>{};
  else
    return std::false_type{};
}

/// Whether a joint outboard of joint i, eliminated before it, leaves something in its row.
template <class Links>
constexpr bool is_met_outboard(int i) {
  bool met = false;
  for (int k = i + 1; k < Links::capacity; ++k)
    met = met || structure<Links>.present[k][i];
  return met;
}

/// Eliminates joint k: m becomes the gains of k on its ancestors, which take over its inertia and effort.
template <class Links, class K, class Matrix, class R, class X>
AXIAL_INLINE constexpr void eliminate(const Links& links, K k, const R& inverse, Matrix& m, X& x) {
  auto link = links.link(k);
  for_each_ancestor(links, k, [&](auto i) AXIAL_INLINE {
    if constexpr (!decltype(is_absent<Links>(k, i))::value) {
      const auto gain = link.quotient(quantity::AngularGain{}, inverse, m(k, i));
      m(i, i) = link.sum(quantity::JointInertia{}, m(i, i), -(gain * m(k, i)));
      for_each_ancestor(links, i, [&](auto j) AXIAL_INLINE {
        if constexpr (!decltype(is_absent<Links>(k, j))::value)
          m(i, j) = link.sum(quantity::JointInertia{}, m(i, j), -(gain * m(k, j)));
      });
      x[i] = link.sum(quantity::JointEffort{}, x[i], -(gain * x[k]));
      m(k, i) = gain;
    }
  });
}

/// A joint's pivot D = M(k, k) after the elimination of what is outboard: below 16 eps of the composite inertia it is
/// rounding and nothing else, so that the joint is held.
template <class Link, class T>
AXIAL_INLINE constexpr auto pivot(const Link&, const T& d, const T& composite) {
  if constexpr (detail::AlwaysResists<Link>::value) {
    return Resistance{reciprocal(d), std::false_type{}, std::true_type{}};
  } else {
    const auto left = d > T(T(Int<16>{}) * NumberTraits<T>::epsilon() * composite);
    return Resistance{select(left, reciprocal(d), T(Zero{})), !left, left};
  }
}

/// Whether the compiler knows that eliminating the matrix of these links loses little.
template <class Links>
constexpr bool loses_little() {
  if constexpr (IsModel<typename Links::Scene::Robot>::value || Links::Scene::template has<RotorDynamics>)
    return false;
  else
    return detail::elimination_loses_little<typename Links::Scene>;
}

/// What an elimination loses at the configuration at hand, where the compiler does not know that it is little: the sum
/// of composite over remaining inertia, joint by joint. Errors were at most some 25 roundings per unit of it (random
/// chains of 2 to 12 joints, doc/measurements/stability.md); from `most` on the answer is called inaccurate.
template <class T, bool known_to_be_little>
class Loss {
 public:
  static constexpr int most = 128;  ///< largest sum that is called ok: errors up to 2^13 roundings
  /// Sees a joint's composite inertia, and the inverse of what is left of it.
  AXIAL_INLINE constexpr void see(const T& composite, const T& inverse) { sum_ = sum_ + composite * inverse; }
  /// ok, or inaccurate; about no joint.
  [[nodiscard]] AXIAL_INLINE constexpr Ordinal<T> code() const {
    const auto much = sum_ > NumberTraits<T>::constant(most);
    return select(much, static_cast<int>(Status::Code::inaccurate), 0);
  }

 private:
  T sum_ = T(Zero{});
};
/// Nothing to see.
template <class T>
class Loss<T, true> {
 public:
  AXIAL_INLINE constexpr void see(const T&, const T&) {}                      ///< looks at nothing
  [[nodiscard]] AXIAL_INLINE constexpr Ordinal<T> code() const { return 0; }  ///< always ok
};

/// True by type where 1/D of joint k has one use, its own acceleration: a joint on the base, known to resist. Then x /
/// D is a multiplication and a rounding less than x times 1/D. A joint that nothing is eliminated from may have a
/// constant for D, of which the compiler knows the inverse.
template <class Links, class K>
AXIAL_INLINE constexpr auto takes_one_quotient(K) {
  if constexpr (Links::unrolled) {
    using Link = decltype(std::declval<const Links&>().link(K{}));
    return std::bool_constant < Links::template parent_of<K::value> < 0 && detail::AlwaysResists<Link>::value &&
           loses_little<Links>() && is_met_outboard<Links>(K::value) > {};
  } else {
    return std::false_type{};
  }
}

/// Solves M x = x in place, M by its lower triangle (L^T D L; Featherstone 2008, section 6.5). D of a joint is compared
/// with its composite inertia M(k, k), from which it was subtracted. The status names the innermost joint that is lost;
/// it is held: its acceleration is 0 and its ancestors bear what it carries as if it were locked.
template <class Links, class Matrix, class X>
AXIAL_INLINE constexpr auto solve(const Links& links, Matrix& m, X& x) {
  using T = typename Links::Scalar;
  auto composite = map_links(links, [&](auto i) AXIAL_INLINE { return m(i, i); });
  Loss<T, loses_little<Links>()> loss;
  Ordinal<T> singular = -1;
  for_each_link_inwards(links, [&](auto k) AXIAL_INLINE {
    auto left = pivot(links.link(k), m(k, k), composite[k]);
    singular = select(Truth<T>(left.singular), static_cast<int>(k), singular);
    loss.see(composite[k], left.inverse);
    eliminate(links, k, left.inverse, m, x);
    if constexpr (decltype(takes_one_quotient<Links>(k))::value)
      x[k] = x[k] / m(k, k);
    else
      x[k] = links.link(k).quotient(quantity::JointAcceleration{}, left.inverse, x[k]);
  });
  for_each_link(links, [&](auto k) AXIAL_INLINE {
    for_each_ancestor(links, k, [&](auto i) AXIAL_INLINE {
      if constexpr (!decltype(is_absent<Links>(k, i))::value)
        x[k] = links.link(k).sum(quantity::JointAcceleration{}, x[k], -(m(k, i) * x[i]));
    });
  });
  const Ordinal<T> lost = static_cast<int>(Status::Code::near_singular);
  return status_from(select(is_negative(singular), loss.code(), lost), singular);
}

/// The algorithm over any form of links; writes one acceleration per joint.
struct Accelerations {
  /// their status
  template <class Links, class Input, class Q, class V, class Tau, class A>
  AXIAL_INLINE static constexpr auto run(const Links& links, const Input& in, const Q& q, const V& qd, const Tau& tau,
                                         A& qdd) {
    auto screws = joint_screws(links, in, q);
    rnea::efforts(links, in, q, screws, qd, NoMotion{}, qdd);
    for_each_link(links, [&](auto i) AXIAL_INLINE { qdd[i] = tau[i] - qdd[i]; });
    MassMatrix<typename Links::Scene::Robot, typename Links::Scalar> m{};
    entries(links, in, screws, m);
    return solve(links, m, qdd);
  }
};

}  // namespace crba
}  // namespace axial

#include <axial/options/end.hpp>
