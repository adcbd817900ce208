#pragma once
/// A step of the discrete Riccati equation, of a regulator and, transposed, of a Kalman filter.

#include "matrix.hpp"

namespace axial::apps {

/// P <- Q + A^T P (A - B K) with K = (R + B^T P B)^-1 B^T P A, which is returned; Q and R are diagonal. Repeated with
/// constant A and B it ends at the solution of the algebraic equation (Anderson and Moore, "Optimal Control", 1990,
/// section 2.4). With A^T for A and C^T for B it is the filter's: P its covariance, K^T its gain (section 4.2). P stays
/// symmetric: half of it is computed.
template <int X, int U>
constexpr Matrix<U, X> riccati_step(Matrix<X, X>& P, const Matrix<X, X>& A, const Matrix<X, U>& B, const float (&Q)[X],
                                    const float (&R)[U]) {
  const Matrix<X, X> PA = product(P, A);
  const Matrix<U, X> BPA = transposed_product(B, PA);
  Matrix<U, U> S = transposed_product(B, product(P, B));
  for (int i = 0; i < U; ++i)
    S(i, i) += R[i];
  const Matrix<U, X> K = solve(S, BPA);
  for (int i = 0; i < X; ++i)
    for (int j = 0; j <= i; ++j) {
      float p = i == j ? Q[i] : 0.0F;
      for (int k = 0; k < X; ++k)
        p += A(k, i) * PA(k, j);
      for (int k = 0; k < U; ++k)
        p -= BPA(k, i) * K(k, j);
      P(i, j) = P(j, i) = p;
    }
  return K;
}

}  // namespace axial::apps
