// Separated terms in values of drives that joints share.
#pragma once

#include <axial/dynamics/drive_shares.hpp>
#include <axial/dynamics/separation_structure.hpp>
#include <axial/links/driven_links.hpp>

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
inline constexpr int inertia_share_count = [] {
  int count = 0;
  TermShares<Scene>::each_inertia([&](const Share&) { ++count; });
  return count;
}();
template <class Scene>
inline constexpr int rate_share_count = [] {
  int count = 0;
  TermShares<Scene>::each_rates([&](const RateShare&) { ++count; });
  return count;
}();
template <class Scene>
inline constexpr auto inertia_shares = [] {
  Row<Share, inertia_share_count<Scene> + 1> all{};  // a first one ends the last entry
  int next = 0;
  TermShares<Scene>::each_inertia([&](const Share& share) { all[next++] = share; });
  all[next].first = true;
  return all;
}();
template <class Scene>
inline constexpr auto rate_shares = [] {
  Row<RateShare, rate_share_count<Scene> + 1> all{};
  int next = 0;
  TermShares<Scene>::each_rates([&](const RateShare& share) { all[next++] = share; });
  all[next].first = true;
  return all;
}();
///@}

/// Separated terms of drives whose joints have a type each: sums that the compiler knows.
template <class Links, class Joints, class Out>
struct TermSums {
  using Scene = typename Links::Scene;                                                       ///< of the drives
  using T = typename Links::Scalar;                                                          ///< the number
  using Kept = detail::CoefficientOf<typename Links::JointScene, typename Links::Value, T>;  ///< those of the joints
  const Joints& joints;                                                                      ///< their coefficients
  const Out& out;  ///< takes those of the drives

  /// All of A, with the drives' rotors.
  template <int... I>
  AXIAL_INLINE constexpr void inertias(const Links& links, std::integer_sequence<int, I...>) const {
    (set_inertia<I>(links), ...);
  }
  /// All of B and C.
  template <int... I>
  AXIAL_INLINE constexpr void rates(std::integer_sequence<int, I...>) const {
    (set_rates<I>(), ...);
  }

 private:
  template <int I>
  AXIAL_INLINE constexpr void set_inertia(const Links& links) const {
    constexpr Share share = inertia_shares<Scene>[I];
    if constexpr (share.first) {
      const Index<share.k> k{};
      const Index<share.l> l{};
      if constexpr (share.k == share.l)
        out.inertia(k, l, Links::add(inertia_from<I>(), links.drives().link(k).rotor()));
      else
        out.inertia(k, l, inertia_from<I>());
    }
  }
  // The sum of shares from I to the end of their entry.
  template <int I>
  AXIAL_INLINE constexpr auto inertia_from() const {
    constexpr Share share = inertia_shares<Scene>[I];
    const auto own = literal<T>([] { return inertia_shares<Scene>[I].factor; }) *
                     Kept::template inertia_in<share.i, share.j>(joints);
    if constexpr (inertia_shares<Scene>[I + 1].first)
      return own;
    else
      return Links::add(own, inertia_from<I + 1>());
  }
  template <int I>
  AXIAL_INLINE constexpr void set_rates() const {
    constexpr RateShare share = rate_shares<Scene>[I];
    if constexpr (share.first) {
      if constexpr (share.k == share.l)
        out.square(Index<share.d>{}, Index<share.k>{}, rates_from<I>());
      else
        out.product(Index<share.d>{}, Index<share.k>{}, Index<share.l>{}, rates_from<I>());
    }
  }
  template <int I>
  AXIAL_INLINE constexpr auto rates_from() const {
    constexpr RateTerm of = rate_shares<Scene>[I].of;
    const auto own =
        literal<T>([] { return rate_shares<Scene>[I].factor; }) * Kept::template rates_in<of.i, of.j, of.p>(joints);
    if constexpr (rate_shares<Scene>[I + 1].first)
      return own;
    else
      return Links::add(own, rates_from<I + 1>());
  }
};

/// Whether Out has room for a term.
template <class Term, class Out>
inline constexpr bool takes = std::is_base_of_v<Term, Out>;

/// Efforts at rest, by G.
template <class S, class T, class Links, class Whole, class Out>
AXIAL_INLINE constexpr void separate_rest(const Links& links, const Whole& joints, Out& out) {
  typename Links::JointValues at_joints{};
  for (int i = 0; i < Links::size; ++i)
    at_joints[i] = joints.G[i];
  EffortsOf<S, T> felt{};
  const auto at_drives = links.felt_by_drives(at_joints);
  links.each_drive([&](auto k) AXIAL_INLINE {
    links.answer(felt, k, at_drives);
    out.G[k] = felt[k];
  });
}

/// The terms by sums that the compiler knows.
template <class Out, class S, class T, class Links, class Whole>
AXIAL_INLINE constexpr Out unrolled_terms(const Links& links, const Whole& joints) {
  using Scene = typename Links::Scene;
  Out out{};
  const Collected<S, T, typename Links::Scalar, Out> terms{out};
  const TermSums<Links, Whole, Collected<S, T, typename Links::Scalar, Out>> sums{joints, terms};
  if constexpr (takes<SeparatedA<S, T>, Out>)
    sums.inertias(links, std::make_integer_sequence<int, inertia_share_count<Scene>>{});
  if constexpr (takes<SeparatedB<S, T>, Out> || takes<SeparatedC<S, T>, Out>)
    sums.rates(std::make_integer_sequence<int, rate_share_count<Scene>>{});
  if constexpr (takes<SeparatedG<S, T>, Out>) separate_rest<S, T>(links, joints, out);
  return out;
}

/// The terms by loops, where joints have a table.
template <class Out, class S, class T, class Links, class Whole>
constexpr Out looped_terms(const Links& links, const Whole& joints) {
  constexpr int n = Links::size, m = Links::capacity;
  Out out{};
  // What the joints' coefficients of one effort make of a pair of drives: sum of C_j G_jk G_jl and half of B_jp.
  const auto pair_of = [&](int i, int k, int l) {
    T sum(Zero{});
    for (int j = 0; j < n; ++j) {
      const T jk = links.ratio(j, k), jl = links.ratio(j, l);
      sum = sum + joints.C[i][j] * (jk * jl);
      for (int p = j + 1; p < n; ++p)
        sum = sum + joints.B[i][Whole::pair(j, p)] *
                        (NumberTraits<T>::constant(0.5) * (jk * links.ratio(p, l) + jl * links.ratio(p, k)));
    }
    return sum;
  };
  links.each_drive([&](auto a) {
    const int d = a;
    for (int i = 0; i < n; ++i) {
      const T felt = links.ratio(i, d);
      if constexpr (takes<SeparatedG<S, T>, Out>) out.G[d] = out.G[d] + felt * joints.G[i];
      for (int k = 0; k < m; ++k) {
        if constexpr (takes<SeparatedA<S, T>, Out>)
          for (int j = 0; j < n; ++j)
            out.A[d][k] = out.A[d][k] + felt * joints.A[i][j] * links.ratio(j, k);
        if constexpr (takes<SeparatedC<S, T>, Out>) out.C[d][k] = out.C[d][k] + felt * pair_of(i, k, k);
        if constexpr (takes<SeparatedB<S, T>, Out>)
          for (int l = k + 1; l < m; ++l) {
            T& entry = out.B[d][Out::pair(k, l)];
            entry = entry + NumberTraits<T>::constant(2.0) * (felt * pair_of(i, k, l));
          }
      }
    }
    if constexpr (takes<SeparatedA<S, T>, Out>) out.A[d][d] = out.A[d][d] + links.drives().link(a).rotor();
  });
  return out;
}

/// A, B, C and G of the drives from those of the joints, efforts and rates by G: A_u = G^T A G, and likewise the
/// coefficients of products. Only those of the four that Out has room for are computed.
template <class Out, class S, class T, class Links, class Input, class U>
constexpr Out separated(const Links& links, const Input& in, const U& u) {
  static_assert(!Links::Scene::template has<RotorDynamics>,
                "axial: separate() has no rotors as bodies; take RotorDynamics out of the scene, or use "
                "inverse_dynamics, bias_torque and mass_matrix");
  using Joint = typename Links::JointScene;
  const auto joints = separation::collected<Separated<Joint, T>, Joint, T>(links.joints(), in, links.positions(u));
  constexpr bool known = [] {
    if constexpr (Links::unrolled)
      return std::decay_t<decltype(links.joints())>::unrolled;
    else
      return false;
  }();
  const auto drives = [&] {
    if constexpr (known)
      return unrolled_terms<Out, S, T>(links, joints);
    else
      return looped_terms<Out, S, T>(links, joints);
  };
  Out out = drives();
  if constexpr (std::is_same_v<Out, Separated<S, T>>) out.status = joints.status;
  return out;
}

}  // namespace driven

namespace separation {
/// Coefficients of drives that joints share which are not zero for every q; efforts at rest are taken as such.
template <class S>
constexpr auto driven_present_terms() {
  using Shares = driven::TermShares<scene_of<S>>;
  Present<S> found{};
  Shares::each_inertia([&](const driven::Share& share) { found.inertia(share.k, share.l, true); });
  Shares::each_rates([&](const driven::RateShare& share) {
    if (share.k == share.l)
      found.square(share.d, share.k, true);
    else
      found.product(share.d, share.k, share.l, true);
  });
  for (int k = 0; k < joint_count<S>; ++k)
    found.inertia(k, k, true), found.rest(k, true);
  return found;
}
}  // namespace separation
}  // namespace axial

#include <axial/options/end.hpp>
