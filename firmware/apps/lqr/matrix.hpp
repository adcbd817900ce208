#pragma once
/// Small dense matrices of float, and the two solutions that a Riccati step needs.

namespace axial::apps {

template <int Rows, int Columns>
struct Matrix {
  float values[Rows * Columns] = {};  ///< row by row

  constexpr float& operator()(int i, int j) { return values[i * Columns + j]; }
  constexpr const float& operator()(int i, int j) const { return values[i * Columns + j]; }
};

/// a b
template <int R, int K, int C>
constexpr Matrix<R, C> product(const Matrix<R, K>& a, const Matrix<K, C>& b) {
  Matrix<R, C> c;
  for (int i = 0; i < R; ++i)
    for (int k = 0; k < K; ++k)
      for (int j = 0; j < C; ++j)
        c(i, j) += a(i, k) * b(k, j);
  return c;
}

/// a^T b
template <int K, int R, int C>
constexpr Matrix<R, C> transposed_product(const Matrix<K, R>& a, const Matrix<K, C>& b) {
  Matrix<R, C> c;
  for (int k = 0; k < K; ++k)
    for (int i = 0; i < R; ++i)
      for (int j = 0; j < C; ++j)
        c(i, j) += a(k, i) * b(k, j);
  return c;
}

template <int R, int C>
constexpr Matrix<C, R> transpose(const Matrix<R, C>& a) {
  Matrix<C, R> t;
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j)
      t(j, i) = a(i, j);
  return t;
}

/// S^-1 b for a positive definite S, by S = L D L^T.
template <int N, int C>
constexpr Matrix<N, C> solve(Matrix<N, N> s, Matrix<N, C> b) {
  for (int k = 0; k < N; ++k)
    for (int i = k + 1; i < N; ++i) {
      const float gain = s(i, k) / s(k, k);
      for (int j = k + 1; j < N; ++j)
        s(i, j) -= gain * s(k, j);
      for (int j = 0; j < C; ++j)
        b(i, j) -= gain * b(k, j);
    }
  for (int k = N - 1; k >= 0; --k) {
    const float inverse = 1.0F / s(k, k);
    for (int j = 0; j < C; ++j)
      b(k, j) *= inverse;
    for (int i = 0; i < k; ++i)
      for (int j = 0; j < C; ++j)
        b(i, j) -= s(i, k) * b(k, j);
  }
  return b;
}

}  // namespace axial::apps
