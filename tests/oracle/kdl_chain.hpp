// Orocos KDL behind the oracle's data types: an implementation by other people, in double. Serial chains only.
#pragma once

#include <memory>

#include <oracle/lagrange.hpp>

namespace oracle {

/// Built by to_kdl (kdl_model.hpp). KDL has rotor inertia (as joint inertia), tip wrench and gravity; friction is added
/// by the caller.
class KdlChain {
 public:
  explicit KdlChain(const Chain<double>& chain);
  ~KdlChain();

  Pose<double> tool_pose(const Vector<double>& q) const;          ///< in the root frame
  Jacobian<double> tool_jacobian(const Vector<double>& q) const;  ///< at the tool, axes of the root frame
  /// Rate of the tool's velocity at constant joint rates, the linear part in `force`, the angular one in `moment`:
  /// ChainJntToJacDotSolver, hybrid representation.
  Wrench<double> tool_bias_acceleration(const Vector<double>& q, const Vector<double>& qd) const;
  Matrix<double> mass_matrix(const Vector<double>& q) const;  ///< ChainDynParam (composite bodies)
  Vector<double> coriolis_torque(const Vector<double>& q, const Vector<double>& qd) const;
  Vector<double> gravity_torque(const Vector<double>& q) const;
  Vector<double> inverse_dynamics(const Vector<double>& q, const Vector<double>& qd, const Vector<double>& qdd,
                                  const Wrench<double>& tip = {}) const;  ///< ChainIdSolver_RNE
  Vector<double> forward_dynamics(const Vector<double>& q, const Vector<double>& qd, const Vector<double>& tau,
                                  const Wrench<double>& tip = {}) const;  ///< ChainFdSolver_RNE (M, then L D L^T)

 private:
  struct Solvers;
  std::unique_ptr<Solvers> solvers_;
};

}  // namespace oracle
