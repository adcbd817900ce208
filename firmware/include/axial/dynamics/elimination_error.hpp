// How much eliminating M(q) loses at one configuration, from M there in double and in float.
#pragma once

#include <axial/scalar/math.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

inline constexpr double infinite_loss = 1e300;  ///< of a matrix that double cannot tell from a singular one

/// Parents of joints, negative for the base; those of a chain to begin with.
template <int N>
struct Parents {
  int of[N] = {};
  constexpr Parents() {
    for (int i = 0; i < N; ++i)
      of[i] = i - 1;
  }
};

/// C^-1 of C = S^-1 M S^-1 with S = sqrt(diag M), by L^T D L along the tree (Featherstone 2008, section 6.5), and the
/// errors that roundings of M make of it. Joints are numbered outwards. What no pair of joints on one path to the base
/// needs is not computed: compilers that evaluate this pay for every step, in time and in memory.
template <int N>
class ScaledInverse {
 public:
  template <class Matrix>
  constexpr ScaledInverse(const Matrix& m, const Parents<N>& parents, int n) : parents_(parents), n_(n) {
    double l[N][N] = {};
    invertible_ = is_scaled(m, l) && factorise(l);
    if (!invertible_) return;
    for (int i = 0; i < n; ++i)
      invert_row(l, i);
    sum_rows();
  }

  constexpr bool invertible() const { return invertible_; }  ///< whether no pivot is lost
  /// |C^-1(i, j)|
  constexpr double operator()(int i, int j) const { return i < j ? inverse_[j][i] : inverse_[i][j]; }

  /// The least that error() can be: every entry of M off by a quarter of a rounding, which needs no M in float.
  constexpr double least_error() const {
    double worst = 0.0;
    for (int l = 0; l < n_; ++l)
      worst = larger(worst, least * sum_[l] * farthest_ / largest_[l]);
    return worst;
  }

  /// What M's rounding makes of an effort on any one joint, in roundings of the largest acceleration that the effort
  /// gives: |M^-1| |dM| |M^-1 e|, dM at least a quarter of a rounding everywhere. That is a matrix of rank one; what
  /// goes beyond it is on pairs of joints that move each other.
  template <class Exact, class Float>
  constexpr double error(const Exact& m, const Float& rounded) const {
    double spread[N][N] = {}, errors[N] = {}, worst = 0.0;
    for (int i = 0; i < n_; ++i)
      for (int j = i; j >= 0; j = parents_.of[j])
        spread_change(change(m, rounded, i, j) - least, i, j, spread);
    for (int i = 0; i < n_; ++i)
      for (int l = base_[i]; l <= i; ++l) {
        if (base_[l] != base_[i]) continue;
        const double sum = least * sum_[i] * sum_[l] + carried(spread, i, l);
        errors[l] = larger(errors[l], sum / root_[i]), errors[i] = larger(errors[i], sum / root_[l]);
      }
    for (int l = 0; l < n_; ++l)  // joints that l does not move have the quarters alone
      worst = larger(worst, larger(errors[l], least * sum_[l] * farthest_) / largest_[l]);
    return worst;
  }

 private:
  static constexpr double least = 0.25;  ///< roundings of an entry that counts as exact
  static constexpr double larger(double a, double b) { return b > a ? b : a; }
  static constexpr double absolute(double x) { return x < 0.0 ? -x : x; }  ///< magnitude() takes bits apart

  template <class Matrix>
  constexpr bool is_scaled(const Matrix& m, double (&l)[N][N]) {
    for (int i = 0; i < n_; ++i) {
      if (!(m(i, i) > 0.0)) return false;
      root_[i] = square_root(m(i, i));
      base_[i] = parents_.of[i] < 0 ? i : base_[parents_.of[i]], last_[base_[i]] = i;
      for (int j = i; j >= 0; j = parents_.of[j])
        l[i][j] = m(i, j) / (root_[i] * root_[j]);
    }
    return true;
  }
  /// L below the diagonal, 1/D on it.
  constexpr bool factorise(double (&l)[N][N]) const {
    for (int k = n_; k-- > 0;) {
      if (!(l[k][k] > 1e-13)) return false;
      l[k][k] = 1.0 / l[k][k];
      for (int i = parents_.of[k]; i >= 0; i = parents_.of[i]) {
        const double factor = l[k][i] * l[k][k];
        for (int j = i; j >= 0; j = parents_.of[j])
          l[i][j] -= factor * l[k][j];
        l[k][i] = factor;
      }
    }
    return true;
  }
  // L C^-1 = D^-1 L^-T, of which row i is zero left of its diagonal.
  constexpr void invert_row(const double (&l)[N][N], int i) {
    for (int j = base_[i]; j <= i; ++j) {
      double value = i == j ? l[i][i] : 0.0;
      if (base_[i] != base_[j]) continue;
      for (int k = parents_.of[i]; k >= 0; k = parents_.of[k])
        value -= l[i][k] * (k < j ? inverse_[j][k] : inverse_[k][j]);
      inverse_[i][j] = value;
    }
  }
  constexpr void sum_rows() {
    for (int i = 0; i < n_; ++i)
      for (int j = base_[i]; j <= i; ++j) {
        if (base_[j] != base_[i]) continue;
        const double entry = inverse_[i][j] = absolute(inverse_[i][j]);
        largest_[i] = larger(largest_[i], entry / root_[j]), largest_[j] = larger(largest_[j], entry / root_[i]);
        sum_[i] += entry, sum_[j] += i == j ? 0.0 : entry;
      }
    for (int i = 0; i < n_; ++i)
      farthest_ = larger(farthest_, sum_[i] / root_[i]);
  }
  /// How far an entry of M in float is from M, in roundings of S_i S_j.
  template <class Exact, class Float>
  constexpr double change(const Exact& m, const Float& rounded, int i, int j) const {
    constexpr double rounding = 0.5 * static_cast<double>(std::numeric_limits<float>::epsilon());
    return absolute(static_cast<double>(rounded(i, j)) - m(i, j)) / (root_[i] * root_[j] * rounding);
  }
  /// Adds what a change of M(i, j) makes of all efforts' accelerations, scaled: dM |C^-1|.
  constexpr void spread_change(double by, int i, int j, double (&spread)[N][N]) const {
    if (!(by > 0.0)) return;
    for (int l = base_[i]; l <= last_[base_[i]]; ++l) {
      if (base_[l] != base_[i]) continue;
      spread[l][i] += by * (*this)(j, l);
      if (i != j) spread[l][j] += by * (*this)(i, l);
    }
  }
  constexpr double carried(const double (&spread)[N][N], int i, int l) const {
    double sum = 0.0;
    for (int j = base_[i]; j <= last_[base_[i]]; ++j)
      if (base_[j] == base_[i]) sum += (*this)(i, j) * spread[l][j];
    return sum;
  }

  Parents<N> parents_{};
  int n_ = 0, base_[N] = {},
      last_[N] = {};  ///< the joint on the base that carries a joint; the last one that it carries
  bool invertible_ = false;
  double inverse_[N][N] = {};                ///< lower triangle
  double root_[N] = {}, sum_[N] = {};        ///< S, row sums of |C^-1|
  double largest_[N] = {}, farthest_ = 0.0;  ///< largest of |C^-1| S^-1 by columns, of the row sums' S^-1
};

/// Error of an elimination at one configuration, in roundings of the largest acceleration, from M there in double and
/// in float. To first order; measured errors of random chains were at most some three times it (tests/property).
template <int N, class Exact, class Float>
constexpr double elimination_error(const Exact& m, const Float& rounded, int n, const Parents<N>& parents = {}) {
  const ScaledInverse<N> inverse(m, parents, n);
  return inverse.invertible() ? inverse.error(m, rounded) : infinite_loss;
}

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
