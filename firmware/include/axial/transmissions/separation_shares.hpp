// What coefficients of the joints' separated terms add to those of the drives that joints share: tables for the
// compiler.
#pragma once

#include <axial/separation/separated_torque.hpp>
#include <axial/transmissions/coupling_terms.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace driven {

/// The coefficient of two joint rates in a joint's effort.
struct RateTerm {
  int i = 0;         ///< the joint that feels it
  int j = 0, p = 0;  ///< joints that move, j <= p: C(i, j) where they are one, else B(i; j p)
};
/// A coefficient of joint rates adds `factor` times itself to one of drive rates.
struct RateShare {
  RateTerm of{};        ///< of the joints
  int d = 0;            ///< the drive that feels it
  int k = 0, l = 0;     ///< drives that move, k <= l: C(d, k) where they are one, else B(d; k l)
  double factor = 0.0;  ///< G_id times what G makes of the two rates
  bool first = false;   ///< of those of this coefficient of the drives
};

/// What the coefficients of the joints of a scene, those that are not zero for every q, add to those of its drives.
template <class Scene>
struct TermShares {
  using Joint = typename detail::SceneOfJoints<Scene>::type;  ///< of the joints
  static constexpr const auto& g = detail::drive_matrix_of_scene(static_cast<const Scene*>(nullptr));  ///< G
  static constexpr int joints = Joint::Robot::chain.size;  ///< number of joints

  /// Whether a coefficient of the joints is there.
  static constexpr bool is_present(const RateTerm& term) {
    const auto& found = separation::present<Joint>;
    return term.j == term.p ? found.C[term.i][term.j] : found.B[term.i][found.pair(term.j, term.p)];
  }
  /// Calls f(share) for every share of A, those of one entry side by side.
  template <class F>
  static constexpr void each_inertia(const F& f) {
    each_share(
        g, [](int i, int j) { return separation::present<Joint>.A[i][j]; }, f);
  }
  /// Calls f(share) for every share of B and C, those of one coefficient side by side.
  template <class F>
  static constexpr void each_rates(const F& f) {
    for (int d = 0; d < g.drives; ++d)
      for (int k = 0; k < g.drives; ++k)
        for (int l = k; l < g.drives; ++l)
          each_of_coefficient(d, k, l, f);
  }

 private:
  // What G makes of the rates of joints j and p in the product of those of drives k and l.
  static constexpr double factor(int j, int p, int k, int l) {
    const double there = g.ratio[j][k] * g.ratio[p][l], back = g.ratio[j][l] * g.ratio[p][k];
    if (k == l) return there;
    return j == p ? 2.0 * there : there + back;
  }
  template <class F>
  static constexpr void each_of_coefficient(int d, int k, int l, const F& f) {
    bool first = true;
    for (int i = 0; i < joints; ++i)
      for (int j = 0; j < joints; ++j)
        for (int p = j; p < joints; ++p) {
          const double whole = g.ratio[i][d] * factor(j, p, k, l);
          if (whole == 0.0 || !is_present({i, j, p})) continue;
          f(RateShare{{i, j, p}, d, k, l, whole, first});
          first = false;
        }
  }
};

/// Shares as a table: of A, and of B and C.
///@{
template <class Scene>
inline constexpr int inertia_share_count = counted([](const auto& f) { TermShares<Scene>::each_inertia(f); });
template <class Scene>
inline constexpr int rate_share_count = counted([](const auto& f) { TermShares<Scene>::each_rates(f); });
template <class Scene>
inline constexpr auto inertia_shares = listed<Share, inertia_share_count<Scene>>([](const auto& f) {
  TermShares<Scene>::each_inertia(f);
});
template <class Scene>
inline constexpr auto rate_shares = listed<RateShare, rate_share_count<Scene>>([](const auto& f) {
  TermShares<Scene>::each_rates(f);
});
///@}

}  // namespace driven

namespace separation {
/// Coefficients of drives that joints share which are not zero for every q; efforts at rest are taken as such.
template <class S>
constexpr auto driven_present_terms() {
  using Shares = driven::TermShares<scene_of<S>>;
  Present<S> found{};
  PresentTerms<S> terms{found};
  Shares::each_inertia([&](const driven::Share& share) { terms.inertia(share.k, share.l, true); });
  Shares::each_rates([&](const driven::RateShare& share) {
    if (share.k == share.l)
      terms.square(share.d, share.k, true);
    else
      terms.product(share.d, share.k, share.l, true);
  });
  for (int k = 0; k < joint_count<S>; ++k)
    terms.inertia(k, k, true), terms.rest(k, true);
  return found;
}
}  // namespace separation

}  // namespace axial

#include <axial/options/end.hpp>
