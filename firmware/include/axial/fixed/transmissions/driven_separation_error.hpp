// Certified errors of the separated terms of drives that joints share: those of the joints' terms, and what G makes of
// their words.
#pragma once

#include <axial/fixed/transmissions/shared_drives_error.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Bounds of the terms of a scene S whose joints share drives, over words T.
template <class S, class T>
class DrivenTermErrors {
  using Word = typename T::Word;
  using Scene = scene_of<S>;
  using Sizes = DriveSizes<S, Word>;
  using Shares = driven::TermShares<Scene>;
  using Exponents = SeparatedExponents<S, T>;
  static constexpr int n = joint_count<S>;
  static constexpr const WordRounding& rounding = SharedDrives<S, T>::rounding;

  // A coefficient of the drives on its way to its word.
  struct Share {
    Ball bound{};
    bounds::TermsOf<driven::inertia_share_count<Scene> + driven::rate_share_count<Scene> + Sizes::joints + 4> terms{};

    constexpr void add(double factor, const bounds::Number& of) {
      bound.size += magnitude(factor) * of.bound.size, bound.error += magnitude(factor) * of.bound.error;
      SharedDrives<S, T>::add(terms, factor, of.exponent, of.bound.largest());
    }
    constexpr bounds::Number stored(int exponent) const {
      return bounds::word_of({bound.size, bound.error + terms.rounding(exponent, rounding)}, exponent);
    }
  };

 public:
  /// Coefficients as they are stored.
  static constexpr bounds::SeparatedBounds<n> terms() {
    const auto joints = DriveErrors<S, T>::joint_terms();
    Share inertias[n][n] = {}, rates[n * n * n] = {};  // GCC 12 leaves out initialisers of members in three dimensions
    Shares::each_inertia(
        [&](const driven::Share& share) { inertias[share.k][share.l].add(share.factor, joints.A[share.i][share.j]); });
    Shares::each_rates([&](const driven::RateShare& share) {
      const auto& [i, j, p] = share.of;
      rates[(share.d * n + share.k) * n + share.l].add(share.factor,
                                                       j == p ? joints.C[i][j] : joints.B[i][joints.pair(j, p)]);
    });
    bounds::SeparatedBounds<n> all;
    for (int d = 0; d < n; ++d) {
      Share rest{};
      for (int i = 0; i < Sizes::joints; ++i)
        if (Shares::g.is_moved(i, d)) rest.add(Shares::g.ratio[i][d], joints.G[i]);
      all.G[d] = rest.stored(Exponents::rest(d));
      if (Sizes::rotor(d) > 0.0) inertias[d][d].bound.size += Sizes::rotor(d), inertias[d][d].terms.add_literal();
      for (int k = 0; k <= d; ++k)
        all.A[d][k] = all.A[k][d] = inertias[d][k].stored(Exponents::inertia(d, k));
      for (int k = 0; k < n; ++k) {
        all.C[d][k] = rates[(d * n + k) * n + k].stored(Exponents::square(d, k));
        for (int l = k + 1; l < n; ++l)
          all.B[d][all.pair(k, l)] = rates[(d * n + k) * n + l].stored(Exponents::product(d, k, l));
      }
    }
    return all;
  }
  /// The drives as links by themselves, with the formats of their efforts.
  ///@{
  static constexpr const auto& mechanism() { return mechanism_of<Scene, FullParameters>; }
  static constexpr Ranges<n> ranges() {
    Ranges<n> all{};
    for (int k = 0; k < n; ++k)
      all.format[k].joint_effort = Exponents::rest(k);
    return all;
  }
  ///@}
};

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
