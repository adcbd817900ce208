// The solution of the discrete algebraic Riccati equation, for the reference of a regulator.
#include <Eigen/Dense>

#include <complex>

namespace regulator_reference {

using Dense = Eigen::MatrixXd;

/// K of the algebraic equation, by the eigenvectors of the symplectic matrix that belong to the eigenvalues inside the
/// unit circle.
Dense solved(const Dense& A, const Dense& B, const Dense& Q, const Dense& R);
Dense solved(const Dense& A, const Dense& B, const Dense& Q, const Dense& R) {
  const auto n = A.rows();
  const Dense G = B * R.inverse() * B.transpose(), back = A.transpose().inverse();
  Dense Z(2 * n, 2 * n);
  Z << A + G * back * Q, -G * back, -back * Q, back;
  const Eigen::EigenSolver<Dense> pairs(Z);
  Eigen::MatrixXcd stable(2 * n, n);
  for (Eigen::Index i = 0, k = 0; i < 2 * n && k < n; ++i)
    if (std::abs(pairs.eigenvalues()(i)) < 1.0) stable.col(k++) = pairs.eigenvectors().col(i);
  const Dense P = (stable.bottomRows(n) * stable.topRows(n).inverse()).real();
  return (R + B.transpose() * P * B).inverse() * B.transpose() * P * A;
}

}  // namespace regulator_reference
