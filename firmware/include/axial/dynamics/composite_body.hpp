// Forward dynamics by composite bodies: M(q) qdd = tau - bias, eliminated from the tips along the branches of the tree.
#pragma once

#include <axial/dynamics/mass_matrix.hpp>
#include <axial/dynamics/reflection.hpp>
#include <axial/model/status.hpp>

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
/// of the matrix of these links
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

/// Solves M x = x in place, M by its lower triangle (L^T D L; Featherstone 2008, section 6.5). D of a joint is compared
/// with its composite inertia, the diagonal of M.
template <class Links, class Matrix, class X>
AXIAL_INLINE constexpr Status solve(const Links& links, Matrix& m, X& x) {
  auto composite = map_links(links, [&](auto i) AXIAL_INLINE { return m(i, i); });
  int singular = -1;
  for_each_link_inwards(links, [&](auto k) AXIAL_INLINE {
    auto left = resistance_at(links.link(k), m(k, k), composite[k]);
    singular = select(left.singular, static_cast<int>(k), singular);
    eliminate(links, k, left.inverse, m, x);
    x[k] = links.link(k).quotient(quantity::JointAcceleration{}, left.inverse, x[k]);
  });
  for_each_link(links, [&](auto k) AXIAL_INLINE {
    for_each_ancestor(links, k, [&](auto i) AXIAL_INLINE {
      if constexpr (!decltype(is_absent<Links>(k, i))::value)
        x[k] = links.link(k).sum(quantity::JointAcceleration{}, x[k], -(m(k, i) * x[i]));
    });
  });
  return {singular < 0 ? Status::Code::ok : Status::Code::near_singular, singular};
}

/// The algorithm over any form of links; writes one acceleration a joint.
template <class Links, class Input, class Q, class V, class Tau, class A>
AXIAL_INLINE constexpr Status run_solve(const Links& links, const Input& in, const Q& q, const V& qd, const Tau& tau,
                                        A& qdd) {
  auto screws = joint_screws(links, in, q);
  rnea::efforts(links, in, q, screws, qd, NoMotion{}, qdd);
  for_each_link(links, [&](auto i) AXIAL_INLINE { qdd[i] = tau[i] - qdd[i]; });
  MassMatrix<typename Links::Scene::Robot, typename Links::Scalar> m{};
  entries(links, in, screws, m);
  return solve(links, m, qdd);
}

}  // namespace crba
}  // namespace axial
