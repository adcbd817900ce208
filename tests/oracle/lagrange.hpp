// The oracle: Lagrange's equations written with the Jacobians of every link's centre of mass (see README.md).
//
// q, qd, qdd, tau hold one value per joint. Gravity has the sign of tau = M(q) qdd + c(q, qd) + g(q) + friction - J^T
// w: g is the torque that holds the chain still. Rotor inertia counts wherever the chain declares it.
#pragma once

#include <oracle/chain.hpp>

namespace oracle {

/// Velocity of a frame per unit of each joint's rate: 3xN each.
template <class T>
struct Jacobian {
  Matrix<T> linear, angular;
};

/// Pose of every link's frame in frame 0, from the product of homogeneous transforms.
template <class T>
std::vector<Pose<T>> link_poses(const Chain<T>& chain, const Vector<T>& q);

/// Pose of the tool in the root frame.
template <class T>
Pose<T> tool_pose(const Chain<T>& chain, const Vector<T>& q);

/// Velocity of the tool's origin and its angular velocity, axes of the root frame.
template <class T>
Jacobian<T> tool_jacobian(const Chain<T>& chain, const Vector<T>& q);

/// M = sum_k m_k Jv_k^T Jv_k + Jw_k^T I_k Jw_k, plus gear^2 J_rotor on the diagonal.
template <class T>
Matrix<T> mass_matrix(const Chain<T>& chain, const Vector<T>& q);

/// dM/dq_l for every l, from the closed-form derivatives of the Jacobians.
template <class T>
std::vector<Matrix<T>> mass_matrix_derivatives(const Chain<T>& chain, const Vector<T>& q);

/// c_i = sum_jl (dM_ij/dq_l - 1/2 dM_jl/dq_i) qd_j qd_l: Coriolis and centrifugal torque.
template <class T>
Vector<T> coriolis_torque(const Chain<T>& chain, const Vector<T>& q, const Vector<T>& qd);

template <class T>
Vector<T> gravity_torque(const Chain<T>& chain, const Vector<T>& q);

/// Torque that overcomes friction: viscous qd + dry friction by the sign of qd, 0 at rest. Dry friction falls from the
/// static one as 1 / (1 + (qd/vs)^2) to the Coulomb one; below the smooth speed v0 it is taken times |x| (3 - x^2) / 2,
/// x = qd/v0.
template <class T>
Vector<T> friction_torque(const Chain<T>& chain, const Vector<T>& qd);

/// Torque that holds the springs across the joints.
template <class T>
Vector<T> spring_torque(const Chain<T>& chain, const Vector<T>& q);

/// J^T w: torque that a wrench on a link (by default the last) exerts on the joints.
template <class T>
Vector<T> wrench_torque(const Chain<T>& chain, const Vector<T>& q, const Wrench<T>& wrench, int link = -1);

template <class T>
Vector<T> inverse_dynamics(const Chain<T>& chain, const Vector<T>& q, const Vector<T>& qd, const Vector<T>& qdd,
                           const Load<T>& load = {});

/// qdd of M qdd = tau - c - g - friction - springs + J^T w.
template <class T>
Vector<T> forward_dynamics(const Chain<T>& chain, const Vector<T>& q, const Vector<T>& qd, const Vector<T>& tau,
                           const Load<T>& load = {});

/// 1/2 sum_k (m_k v_k^2 + w_k^T I_k w_k) + 1/2 sum_i gear_i^2 J_i qd_i^2, from the links' velocities.
template <class T>
T kinetic_energy(const Chain<T>& chain, const Vector<T>& q, const Vector<T>& qd);

/// -sum_k m_k gravity . c_k, zero at the origin of frame 0.
template <class T>
T potential_energy(const Chain<T>& chain, const Vector<T>& q);

}  // namespace oracle
