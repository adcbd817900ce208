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
  const Dense At = A.transpose(), Bt = B.transpose(), back = At.inverse(), Ri = R.inverse();
  const Dense BRi = B * Ri, G = BRi * Bt, Gb = G * back, GbQ = Gb * Q, bQ = back * Q;
  Dense Z(2 * n, 2 * n);
  Z << A + GbQ, -Gb, -bQ, back;
  const Eigen::EigenSolver<Dense> pairs(Z);
  Eigen::MatrixXcd upper(n, n), lower(n, n);
  for (Eigen::Index i = 0, k = 0; i < 2 * n && k < n; ++i) {
    if (std::abs(pairs.eigenvalues()(i)) >= 1.0) continue;
    const Eigen::VectorXcd stable = pairs.eigenvectors().col(i);
    upper.col(k) = stable.head(n), lower.col(k++) = stable.tail(n);
  }
  const Eigen::MatrixXcd inverse = upper.inverse(), ratio = lower * inverse;
  const Dense P = ratio.real(), BtP = Bt * P, BtPA = BtP * A, weight = BtP * B, sum = R + weight,
              solution = sum.inverse();
  return solution * BtPA;
}

}  // namespace regulator_reference
