// Separated dynamics in fixed point: the formats of the coefficients, and how kernels write them.
#pragma once

#include <axial/fixed/formats/drive_formats.hpp>
#include <axial/fixed/links/fixed_values.hpp>
#include <axial/links/separated_terms.hpp>
#include <axial/transmissions/driven_separation.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

template <class S, class Word>
inline constexpr auto separation_ranges = separation_ranges_of(mechanism_of<scene_of<S>, FullParameters>,
                                                               WordRounding{8 * static_cast<int>(sizeof(Word)), true,
                                                                            false, 0.0});

/// value = raw 2^-exponent of the words of Separated<S, Stored<Word>>. Joints beyond the outermost one of its indices
/// have no part in a coefficient, so that joint's body gives the format.
template <class S, class Word, bool shared = shares_drives_in<typename scene_of<S>::Robot>>
struct SeparatedFormat {
  static constexpr int inertia(int i, int j) { return coefficient(i, j, j); }
  static constexpr int product(int i, int j, int k) { return coefficient(i, j, k); }
  static constexpr int square(int i, int j) { return coefficient(i, j, j); }
  static constexpr int rest(int i) { return exponents_of<S, Word, role::Effort>.of[i]; }
  /// All formats, as a run on bounds takes them.
  static constexpr auto all() {
    bounds::SeparatedFormats<joint_count<S>> formats;
    for (int i = 0; i < joint_count<S>; ++i)
      formats.coefficient[i] = coefficient(i, i, i), formats.rest[i] = rest(i);
    return formats;
  }

 private:
  static constexpr int coefficient(int i, int j, int k) {
    return separation_ranges<S, Word>.format[outermost(i, j, k)].joint_inertia;
  }
};

/// Exponents of the coefficients of drives that joints share: each by what those of the joints add up to in it.
template <class S, class Word>
struct DrivenTermExponents {
  using Sizes = DriveSizes<S, Word>;
  using Joint = typename Sizes::Joint;
  using Shares = driven::TermShares<scene_of<S>>;
  static constexpr int n = joint_count<S>;
  int inertia[n][n] = {}, rates[n][n][n] = {};

  static constexpr DrivenTermExponents chosen() {
    constexpr auto joints =
        bounds::separated_bounds(mechanism_of<Joint, FullParameters>, joint_rounding<Word>,
                                 separation_ranges<Joint, Word>, SeparatedFormat<Joint, Word>::all());
    double inertias[n][n] = {}, products[n][n][n] = {};
    Shares::each_inertia([&](const driven::Share& share) {
      inertias[share.k][share.l] += magnitude(share.factor) * joints.A[share.i][share.j].bound.size;
    });
    Shares::each_rates([&](const driven::RateShare& share) {
      const auto& [i, j, p] = share.of;
      const auto& own = j == p ? joints.C[i][j] : joints.B[i][joints.pair(j, p)];
      products[share.d][share.k][share.l] += magnitude(share.factor) * own.bound.size;
    });
    DrivenTermExponents found;
    for (int d = 0; d < n; ++d)
      for (int k = 0; k < n; ++k) {
        if (k <= d)
          found.inertia[d][k] = found.inertia[k][d] =
              joint_rounding<Word>.exponent(inertias[d][k] + (d == k ? Sizes::rotor(k) : 0.0));
        for (int l = k; l < n; ++l)
          found.rates[d][k][l] = found.rates[d][l][k] = joint_rounding<Word>.exponent(products[d][k][l]);
      }
    return found;
  }
};
template <class S, class Word>
inline constexpr auto driven_term_exponents = DrivenTermExponents<S, Word>::chosen();

/// Of drives that joints share.
template <class S, class Word>
struct SeparatedFormat<S, Word, true> {
  static constexpr int inertia(int i, int j) { return driven_term_exponents<S, Word>.inertia[i][j]; }
  static constexpr int product(int i, int j, int k) { return driven_term_exponents<S, Word>.rates[i][j][k]; }
  static constexpr int square(int i, int j) { return product(i, j, j); }
  static constexpr int rest(int i) { return exponents_of<S, Word, role::Effort>.of[i]; }
};

template <class S, class Word, class Scalar>
struct CoefficientOf<S, Stored<Word>, Scalar> {
  using Format = SeparatedFormat<S, Word>;
  template <class I, class J, class V>
  AXIAL_INLINE static constexpr Stored<Word> inertia(I, J, const V& value) {
    return stored_at<Format::inertia(I::value, J::value), Scalar>(value);
  }
  template <class I, class J, class K, class V>
  AXIAL_INLINE static constexpr Stored<Word> rates(I, J, K, const V& value) {
    return stored_at<Format::product(I::value, J::value, K::value), Scalar>(value);
  }
  template <class I, class V>
  AXIAL_INLINE static constexpr Stored<Word> rest(I, const V& value) {
    return stored_at<Format::rest(I::value), Scalar>(value);
  }
  template <int I, int J, class Terms>
  AXIAL_INLINE static constexpr auto inertia_in(const Terms& terms) {
    return Fx<Format::inertia(I, J), Scalar>{terms.A[I][J].raw};
  }
  template <int I, int J, int P, class Terms>
  AXIAL_INLINE static constexpr auto rates_in(const Terms& terms) {
    if constexpr (J == P)
      return Fx<Format::square(I, J), Scalar>{terms.C[I][J].raw};
    else
      return Fx<Format::product(I, J, P), Scalar>{terms.B[I][Terms::pair(J, P)].raw};
  }
};

}  // namespace detail

/// Exponents of the coefficients of separate<S>() in fixed point T.
template <class S, class T>
using SeparatedExponents = detail::SeparatedFormat<S, typename T::Word>;

}  // namespace axial

#include <axial/options/end.hpp>
