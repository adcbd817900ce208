// How kernels hand over the separated terms of the dynamics.
#pragma once

#include <axial/links/soundness.hpp>
#include <axial/scene/separated.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// How coefficients are kept: as numbers T; as bool, whether they differ from zero by type. A number system with
/// formats has one for each: of qdd_J (inertia), of qd_J qd_K (rates) and of what a joint feels at rest.
template <class S, class T, class Scalar>
struct CoefficientOf {
  template <class I, class J, class V>
  AXIAL_INLINE static constexpr T inertia(I, J, const V& value) {
    return kept(value);
  }
  template <class I, class J, class K, class V>
  AXIAL_INLINE static constexpr T rates(I, J, K, const V& value) {
    return kept(value);
  }
  template <class I, class V>
  AXIAL_INLINE static constexpr T rest(I, const V& value) {
    return kept(value);
  }
  /// A(I, J) and the coefficient of qd_J qd_P in joint I's effort as they were kept.
  template <int I, int J, class Terms>
  AXIAL_INLINE static constexpr const T& inertia_in(const Terms& terms) {
    return terms.A[I][J];
  }
  template <int I, int J, int P, class Terms>
  AXIAL_INLINE static constexpr const T& rates_in(const Terms& terms) {
    if constexpr (J == P)
      return terms.C[I][J];
    else
      return terms.B[I][Terms::pair(J, P)];
  }

 private:
  template <class V>
  AXIAL_INLINE static constexpr T kept(const V& value) {
    if constexpr (std::is_same_v<T, bool>)
      return !is_zero_v<V>;
    else
      return static_cast<T>(value);
  }
};

}  // namespace detail

/// Looks whether coefficients are numbers.
template <class T>
struct TermJudge {
  Soundness<T>& all;  ///< what looks at them
  /// looks at one
  template <class V>
  AXIAL_INLINE constexpr void number(const V& value) const {
    all.number(value);
  }
};
/// Looks at none.
template <>
struct TermJudge<void> {
  template <class V>
  AXIAL_INLINE constexpr void number(const V&) const {}  ///< does not look
};

/// Takes the coefficients that Out has room for: any of SeparatedA, B, C, G, or all. `Scalar` is the kernel's number,
/// or what it computes by.
template <class S, class T, class Scalar, class Out, class Judged = void>
struct Collected {
  using Coefficient = detail::CoefficientOf<S, T, Scalar>;  ///< how each is kept
  Out& out;                                                 ///< what is filled
  TermJudge<Judged> judge{};                                ///< what looks at all that comes

  /// Sets A(i, j) and A(j, i).
  template <class I, class J, class V>
  AXIAL_INLINE constexpr void inertia(I i, J j, const V& value) const {
    if constexpr (std::is_base_of_v<SeparatedA<S, T>, Out>) {
      out.A[i][j] = Coefficient::inertia(i, j, value);
      out.A[j][i] = out.A[i][j];
    }
    judge.number(value);
  }
  /// Sets the coefficient of qd_j qd_k in joint i's effort.
  template <class I, class J, class K, class V>
  AXIAL_INLINE constexpr void product(I i, J j, K k, const V& value) const {
    if constexpr (std::is_base_of_v<SeparatedB<S, T>, Out>) {
      T& entry = out.B[i][Out::pair(j, k)];
      entry = Coefficient::rates(i, j, k, value);
    }
    judge.number(value);
  }
  /// Sets the coefficient of qd_j^2 in joint i's effort.
  template <class I, class J, class V>
  AXIAL_INLINE constexpr void square(I i, J j, const V& value) const {
    if constexpr (std::is_base_of_v<SeparatedC<S, T>, Out>) out.C[i][j] = Coefficient::rates(i, j, j, value);
    judge.number(value);
  }
  /// Sets joint i's effort at rest.
  template <class I, class V>
  AXIAL_INLINE constexpr void rest(I i, const V& value) const {
    if constexpr (std::is_base_of_v<SeparatedG<S, T>, Out>) out.G[i] = Coefficient::rest(i, value);
    judge.number(value);
  }
};

}  // namespace axial

#include <axial/options/end.hpp>
