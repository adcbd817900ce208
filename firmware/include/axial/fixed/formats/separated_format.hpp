// Separated dynamics in fixed point: the formats of the coefficients, and how kernels write and read them.
#pragma once

#include <axial/links/joint_access.hpp>
#include <axial/links/soundness.hpp>
#include <axial/scene/separated.hpp>

namespace axial {
namespace detail {

template <class S, class Word>
inline constexpr auto separation_ranges = separation_ranges_of(mechanism_of<scene_of<S>, FullParameters>,
                                                               Rounding{8 * static_cast<int>(sizeof(Word)), true, false,
                                                                        0.0});

constexpr int outermost(int i, int j, int k) { return i > j ? (i > k ? i : k) : (j > k ? j : k); }

/// value = raw 2^-exponent of the words of Separated<S, Stored<Word>>. Joints beyond the outermost one of its indices
/// have no part in a coefficient, so that joint's body gives the format.
template <class S, class Word>
struct SeparatedFormat {
  static constexpr int inertia(int i, int j) { return coefficient(i, j, j); }
  static constexpr int product(int i, int j, int k) { return coefficient(i, j, k); }
  static constexpr int square(int i, int j) { return coefficient(i, j, j); }
  static constexpr int rest(int i) { return exponents_of<S, Word, role::Effort>.of[i]; }

 private:
  static constexpr int coefficient(int i, int j, int k) {
    return separation_ranges<S, Word>.format[outermost(i, j, k)].joint_inertia;
  }
};

template <int E, class S, class Word, class V>
AXIAL_INLINE constexpr void store_coefficient(Stored<Word>& to, const V& value) {
  if constexpr (is_structural_v<V>)
    to.raw = Fx<E, S>(value).raw;
  else
    to.raw = round_to<E>(value).raw;
}

}  // namespace detail

/// Exponents of the coefficients of separate<S>() in fixed point T.
template <class S, class T>
using SeparatedExponents = detail::SeparatedFormat<S, typename T::Word>;

/// Takes the coefficients that Out has room for: any of SeparatedA, B, C, G, or all. `Scalar` is the kernel's number or
/// arithmetic.
template <class S, class T, class Scalar, class Out>
struct Collected {
  Out& out;  ///< what is filled

  /// Sets A(i, j) and A(j, i).
  template <class I, class J, class V>
  AXIAL_INLINE constexpr void inertia(I i, J j, const V& value) const {
    if constexpr (std::is_base_of_v<SeparatedA<S, T>, Out>) {
      if constexpr (is_stored_v<T>)
        detail::store_coefficient<SeparatedExponents<S, T>::inertia(i, j), Scalar>(out.A[i][j], value);
      else
        out.A[i][j] = static_cast<T>(value);
      out.A[j][i] = out.A[i][j];
    }
  }
  /// Sets the coefficient of qd_j qd_k in joint i's effort.
  template <class I, class J, class K, class V>
  AXIAL_INLINE constexpr void product(I i, J j, K k, const V& value) const {
    if constexpr (std::is_base_of_v<SeparatedB<S, T>, Out>) {
      T& entry = out.B[i][Out::pair(j, k)];
      if constexpr (is_stored_v<T>)
        detail::store_coefficient<SeparatedExponents<S, T>::product(i, j, k), Scalar>(entry, value);
      else
        entry = static_cast<T>(value);
    }
  }
  /// Sets the coefficient of qd_j^2 in joint i's effort.
  template <class I, class J, class V>
  AXIAL_INLINE constexpr void square(I i, J j, const V& value) const {
    if constexpr (std::is_base_of_v<SeparatedC<S, T>, Out>) {
      if constexpr (is_stored_v<T>)
        detail::store_coefficient<SeparatedExponents<S, T>::square(i, j), Scalar>(out.C[i][j], value);
      else
        out.C[i][j] = static_cast<T>(value);
    }
  }
  /// Sets joint i's effort at rest.
  template <class I, class V>
  AXIAL_INLINE constexpr void rest(I i, const V& value) const {
    if constexpr (std::is_base_of_v<SeparatedG<S, T>, Out>) {
      if constexpr (is_stored_v<T>)
        detail::store_coefficient<SeparatedExponents<S, T>::rest(i), Scalar>(out.G[i], value);
      else
        out.G[i] = static_cast<T>(value);
    }
  }
};

/// Passes coefficients on, and looks whether they are numbers.
template <class Terms, class T>
struct JudgedTerms {
  const Terms& terms;  ///< what takes them
  Soundness<T>& all;   ///< what looks at them

  /// Coefficients as Collected takes them.
  ///@{
  template <class I, class J, class V>
  AXIAL_INLINE constexpr void inertia(I i, J j, const V& value) const {
    terms.inertia(i, j, value), all.number(value);
  }
  template <class I, class J, class K, class V>
  AXIAL_INLINE constexpr void product(I i, J j, K k, const V& value) const {
    terms.product(i, j, k, value), all.number(value);
  }
  template <class I, class J, class V>
  AXIAL_INLINE constexpr void square(I i, J j, const V& value) const {
    terms.square(i, j, value), all.number(value);
  }
  template <class I, class V>
  AXIAL_INLINE constexpr void rest(I i, const V& value) const {
    terms.rest(i, value), all.number(value);
  }
  ///@}
};

}  // namespace axial
