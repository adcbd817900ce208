// An upper bound of the largest eigenvalue of a symmetric matrix.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/scalar/math.hpp>
#include <axial/scalar/traits.hpp>

#include <limits>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// N x N numbers of which size x size count.
template <class T, int N>
struct Square {
  T values[N][N] = {};
};

template <class T, int N>
constexpr T largest_magnitude(const Square<T, N>& a, int size) {
  T most = T(0);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      most = magnitude(a.values[i][j]) > most ? magnitude(a.values[i][j]) : most;
  return most;
}
// Sum of the squares of all elements, rooted: the Frobenius norm. Computed of shares of the largest element, whose
// squares neither overflow nor vanish.
template <class T, int N>
constexpr T frobenius(const Square<T, N>& a, int size) {
  const T most = largest_magnitude(a, size);
  if (!(most > T(0)) || !is_finite(most)) return most;
  T sum = T(0);
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) {
      const T share = a.values[i][j] / most;
      sum += share * share;
    }
  return most * square_root(sum);
}
template <class T, int N>
constexpr bool is_finite_square(const Square<T, N>& a, int size) {
  bool finite = true;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      finite = finite && is_finite(a.values[i][j]);
  return finite;
}
template <class T, int N>
constexpr Square<T, N> squared(const Square<T, N>& a, int size) {
  Square<T, N> product{};
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      for (int k = 0; k < size; ++k)
        product.values[i][j] += a.values[i][k] * a.values[k][j];
  return product;
}

/// An upper bound of the largest eigenvalue of a symmetric matrix without negative ones: the 2p-th root of
/// trace(a^2p), p = 16, at most n^(1/32) times the eigenvalue (1.06 for n = 6). Infinite for a matrix that is not
/// finite.
template <class T, int N>
constexpr T largest_eigenvalue_bound(Square<T, N> a, int size) {
  if (!is_finite_square(a, size)) return std::numeric_limits<T>::infinity();
  constexpr int squarings = 4;
  T norms[squarings + 1] = {};
  for (int level = 0;; ++level) {
    const T norm = norms[level] = frobenius(a, size);
    if (!(norm > T(0)) || level == squarings) break;
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
        a.values[i][j] /= norm;
    a = squared(a, size);
  }
  T root = norms[squarings];
  for (int level = squarings; level-- > 0;)
    root = norms[level] * square_root(root);
  return root;
}

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
