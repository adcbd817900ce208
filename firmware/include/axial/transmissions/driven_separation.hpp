// Separated terms in values of drives that joints share.
#pragma once

#include <axial/transmissions/driven_links.hpp>
#include <axial/transmissions/separation_shares.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace driven {

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
  EffortsOf<S, T> actuator_effort{};
  const auto at_drives = links.actuator_efforts(at_joints);
  links.each_drive([&](auto k) AXIAL_INLINE {
    links.answer(actuator_effort, k, at_drives);
    out.G[k] = actuator_effort[k];
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
      const T actuator_effort = links.ratio(i, d);
      if constexpr (takes<SeparatedG<S, T>, Out>) out.G[d] = out.G[d] + actuator_effort * joints.G[i];
      for (int k = 0; k < m; ++k) {
        if constexpr (takes<SeparatedA<S, T>, Out>)
          for (int j = 0; j < n; ++j)
            out.A[d][k] = out.A[d][k] + actuator_effort * joints.A[i][j] * links.ratio(j, k);
        if constexpr (takes<SeparatedC<S, T>, Out>) out.C[d][k] = out.C[d][k] + actuator_effort * pair_of(i, k, k);
        if constexpr (takes<SeparatedB<S, T>, Out>)
          for (int l = k + 1; l < m; ++l) {
            T& entry = out.B[d][Out::pair(k, l)];
            entry = entry + NumberTraits<T>::constant(2.0) * (actuator_effort * pair_of(i, k, l));
          }
      }
    }
    if constexpr (takes<SeparatedA<S, T>, Out>) out.A[d][d] = out.A[d][d] + links.drives().link(a).rotor();
  });
  return out;
}

}  // namespace driven

/// A, B, C and G of the drives from those of the joints, efforts and rates by G: A_u = G^T A G, and likewise the
/// coefficients of products. Only those of the four that Out has room for are computed.
template <class Out, class S, class T, class Links>
struct Execution<separation::Terms<Out, S, T>, Links, IfDriven<Links>> {
  /// the terms
  template <class Input, class U>
  [[nodiscard]] static constexpr Out run(const Links& links, const Input& in, const U& u) {
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
        return driven::unrolled_terms<Out, S, T>(links, joints);
      else
        return driven::looped_terms<Out, S, T>(links, joints);
    };
    Out out = drives();
    if constexpr (std::is_same_v<Out, Separated<S, T>>) out.status = joints.status;
    return out;
  }
};

}  // namespace axial

#include <axial/options/end.hpp>
