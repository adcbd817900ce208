// M of drives from M of the joints that they share: which entries add to which, and by how much.
#pragma once

#include <axial/dynamics/composite_body.hpp>
#include <axial/transmissions/driven_links.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace driven {

/// M(i, j) of the joints adds `factor` times itself to M(k, l) of the drives.
struct Share {
  int i = 0, j = 0;     ///< joints, i >= j
  int k = 0, l = 0;     ///< drives, k >= l
  double factor = 0.0;  ///< G_ik G_jl + G_jk G_il, or one of them on the diagonal
  bool first = false;   ///< of those of M(k, l)
};
/// Calls f(share) for every one, those of one entry side by side; `present` tells which entries of the joints' matrix
/// are not zero by structure.
template <int N, class Present, class F>
constexpr void each_share(const DriveMatrix<N>& g, const Present& present, const F& f) {
  for (int k = 0; k < g.drives; ++k)
    for (int l = 0; l <= k; ++l) {
      bool first = true;
      for (int i = 0; i < N; ++i)
        for (int j = 0; j <= i; ++j) {
          const double there = g.ratio[i][k] * g.ratio[j][l], back = g.ratio[j][k] * g.ratio[i][l];
          const double factor = i == j ? there : there + back;
          if (factor == 0.0 || !present(i, j)) continue;
          f(Share{i, j, k, l, factor, first});
          first = false;
        }
    }
}

/// Calls f(share) for every share of DrivenLinks.
template <class Links, class F>
constexpr void each_share_of(const F& f) {
  using JointLinks = decltype(Links::joints());
  const auto present = [](int i, int j) {
    if constexpr (JointLinks::unrolled)
      return crba::structure<JointLinks>.present[i][j];
    else
      return true;
  };
  each_share(Links::matrix, present, f);
}
/// Number of shares that each(f) hands to f.
template <class Each>
constexpr int counted(const Each& each) {
  int count = 0;
  each([&](const auto&) { ++count; });
  return count;
}
/// All of them as a table, those of one entry side by side; a first one ends the last entry.
template <class S, int count, class Each>
constexpr auto listed(const Each& each) {
  Row<S, count + 1> all{};
  int next = 0;
  each([&](const S& share) { all[next++] = share; });
  all[next].first = true;
  return all;
}
/// Number of shares, and all of them.
///@{
template <class Links>
inline constexpr int share_count = counted([](const auto& f) { each_share_of<Links>(f); });
template <class Links>
inline constexpr auto shares = listed<Share, share_count<Links>>([](const auto& f) { each_share_of<Links>(f); });
///@}

/// The sum of shares First to Last - 1.
template <class Links, int First, int Last, class M>
AXIAL_INLINE constexpr auto sum_of_shares(const M& joints) {
  using T = typename Links::Scalar;
  constexpr Share share = shares<Links>[Last - 1];
  const auto last =
      literal<T>([] { return shares<Links>[Last - 1].factor; }) * Links::template entry<share.i, share.j>(joints);
  if constexpr (Last - First == 1)
    return last;
  else
    return Links::add(sum_of_shares<Links, First, Last - 1>(joints), last);
}
/// How far the shares of the entry that begins with share `first` go.
template <class Links>
constexpr int end_of_entry(int first) {
  int end = first + 1;
  while (!shares<Links>[end].first)
    ++end;
  return end;
}
/// m = G^T M G and the drives' rotors, M of the joints.
template <class Links, class M, class Drives, int... I>
AXIAL_INLINE constexpr void reduce(const Links& links, const M& joints, Drives& m, std::integer_sequence<int, I...>) {
  auto set = [&](auto index) AXIAL_INLINE {
    constexpr int first = decltype(index)::value;
    constexpr Share share = shares<Links>[first];
    if constexpr (share.first) {
      const auto sum = sum_of_shares<Links, first, end_of_entry<Links>(first)>(joints);
      if constexpr (share.k == share.l)
        m.set(Index<share.k>{}, Index<share.l>{}, Links::add(sum, links.drives().link(Index<share.k>{}).rotor()));
      else
        m.set(Index<share.k>{}, Index<share.l>{}, sum);
    }
  };
  (set(Index<I>{}), ...);
}

}  // namespace driven
}  // namespace axial

#include <axial/options/end.hpp>
