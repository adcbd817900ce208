// Chains whose joints share drives: q = G u + q0, with efforts by power, tau_u = G^T tau_q, and rotors on the drives.
// The equations of the joints without constraints between them, so G is all that is told.
#pragma once

#include <oracle/lagrange.hpp>
#include <oracle/recursive.hpp>

#include <utility>

namespace oracle {

/// What moves the joints of a chain: joints by rows, drives by columns.
template <class T>
struct Drives {
  Matrix<T> g;        ///< rad or m of a joint per unit of a drive
  Vector<T> q0;       ///< rad or m
  Vector<T> inertia;  ///< gear^2 J_rotor of a drive: kg m^2, or what its unit makes of it
};

/// A chain and its drives, without friction. u, ud, udd, tau hold a value per drive: per joint where each has a drive
/// of its own.
template <class T>
class DrivenChain {
 public:
  DrivenChain() = default;
  /// Each joint has a drive of its own.
  explicit DrivenChain(Chain<T> chain) : chain_(std::move(chain)) {}
  /// Joints share drives; rotors of the chain's links are left out.
  DrivenChain(const Chain<T>& chain, Drives<T> drives)
      : chain_(without_rotors(chain)), drives_(std::move(drives)), shared_(true) {}

  const Chain<T>& chain() const { return chain_; }
  Vector<T> positions(const Vector<T>& u) const {
    if (!shared_) return u;
    Vector<T> q = drives_.g * u;
    for (std::size_t i = 0; i < q.size(); ++i)
      q[i] += drives_.q0[i];
    return q;
  }
  Vector<T> rates(const Vector<T>& ud) const { return shared_ ? drives_.g * ud : ud; }

  Vector<T> inverse_dynamics(const Vector<T>& u, const Vector<T>& ud, const Vector<T>& udd) const {
    return efforts(chain_, u, ud, udd);
  }
  Vector<T> forward_dynamics(const Vector<T>& u, const Vector<T>& ud, Vector<T> tau) const {
    if (!shared_) return recursive_forward_dynamics(chain_, u, ud, tau);
    const auto bias = inverse_dynamics(u, ud, Vector<T>(u.size(), T(0)));
    for (std::size_t k = 0; k < tau.size(); ++k)
      tau[k] -= bias[k];
    return solve(mass_matrix(u), tau);
  }
  /// A column is the effort of a unit acceleration, without gravity and at rest.
  Matrix<T> mass_matrix(const Vector<T>& u) const {
    const int n = static_cast<int>(u.size());
    Chain<T> weightless = chain_;
    weightless.gravity = {};
    const Vector<T> rest(u.size(), T(0));
    Matrix<T> M(n, n);
    for (int k = 0; k < n; ++k) {
      Vector<T> unit = rest;
      unit[std::size_t(k)] = T(1);
      const auto column = efforts(weightless, u, rest, unit);
      for (int i = 0; i < n; ++i)
        M(i, k) = column[std::size_t(i)];
    }
    return M;
  }
  Pose<T> tool_pose(const Vector<T>& u) const { return oracle::tool_pose(chain_, positions(u)); }
  /// Columns by drives.
  Jacobian<T> tool_jacobian(const Vector<T>& u) const {
    const auto joints = oracle::tool_jacobian(chain_, positions(u));
    return shared_ ? Jacobian<T>{by_drives(joints.linear), by_drives(joints.angular)} : joints;
  }

 private:
  Vector<T> efforts(const Chain<T>& chain, const Vector<T>& u, const Vector<T>& ud, const Vector<T>& udd) const {
    const auto felt = recursive_inverse_dynamics(chain, positions(u), rates(ud), rates(udd));
    if (!shared_) return felt;
    Vector<T> tau;
    for (std::size_t k = 0; k < u.size(); ++k) {
      tau.push_back(drives_.inertia[k] * udd[k]);
      for (std::size_t i = 0; i < felt.size(); ++i)
        tau[k] += drives_.g(static_cast<int>(i), static_cast<int>(k)) * felt[i];
    }
    return tau;
  }
  Matrix<T> by_drives(const Matrix<T>& joints) const {
    Matrix<T> columns(3, drives_.g.columns());
    for (int row = 0; row < 3; ++row)
      for (int k = 0; k < columns.columns(); ++k)
        for (int i = 0; i < joints.columns(); ++i)
          columns(row, k) += joints(row, i) * drives_.g(i, k);
    return columns;
  }

  Chain<T> chain_;
  Drives<T> drives_;
  bool shared_ = false;
};

}  // namespace oracle
