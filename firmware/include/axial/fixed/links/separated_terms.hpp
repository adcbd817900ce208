// Separated dynamics in fixed point: the formats of the coefficients, and how kernels write them.
#pragma once

#include <axial/fixed/links/fixed_values.hpp>
#include <axial/links/separated_terms.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

template <class S, class Word>
inline constexpr auto separation_ranges = separation_ranges_of(mechanism_of<scene_of<S>, FullParameters>,
                                                               WordRounding{8 * static_cast<int>(sizeof(Word)), true,
                                                                            false, 0.0});

constexpr int outermost(int i, int j, int k) { return i > j ? (i > k ? i : k) : (j > k ? j : k); }

/// value = raw 2^-exponent of the words of Separated<S, Stored<Word>>. Joints beyond the outermost one of its indices
/// have no part in a coefficient, so that joint's body gives the format.
template <class S, class Word>
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

template <class S, class Word, class Scalar>
struct CoefficientOf<S, Stored<Word>, Scalar> {
  using Format = SeparatedFormat<S, Word>;
  template <class I, class J, class V>
  AXIAL_INLINE static constexpr Stored<Word> inertia(I, J, const V& value) {
    return stored_at<Format::inertia(I::value, J::value), Scalar>(value);
  }
  template <class I, class J, class K, class V>
  AXIAL_INLINE static constexpr Stored<Word> product(I, J, K, const V& value) {
    return stored_at<Format::product(I::value, J::value, K::value), Scalar>(value);
  }
  template <class I, class J, class V>
  AXIAL_INLINE static constexpr Stored<Word> square(I, J, const V& value) {
    return stored_at<Format::square(I::value, J::value), Scalar>(value);
  }
  template <class I, class V>
  AXIAL_INLINE static constexpr Stored<Word> rest(I, const V& value) {
    return stored_at<Format::rest(I::value), Scalar>(value);
  }
};

}  // namespace detail

/// Exponents of the coefficients of separate<S>() in fixed point T.
template <class S, class T>
using SeparatedExponents = detail::SeparatedFormat<S, typename T::Word>;

}  // namespace axial

#include <axial/options/end.hpp>
