// Dynamics with its terms apart: what the Automatic Separation Method and the closed forms return.
#pragma once

#include <axial/model/joints.hpp>

namespace axial {

/// A(q) qdd + B(q) [qd qd] + C(q) [qd^2] + G(q) = tau, Djuric et al. 2016, eq. (1).
/// Columns of B follow the products (qd1 qd2, qd1 qd3, ..., qd_{n-1} qd_n), those of C (qd1^2, ..., qdn^2).
template <class S, class T>
struct Separated {
  static constexpr int size = joint_count<S>;
  static constexpr int pairs = size > 1 ? size*(size - 1) / 2 : 1;
  T A[size][size];   ///< mass matrix, kg m^2 (kg m, kg)
  T B[size][pairs];  ///< Coriolis
  T C[size][size];   ///< centrifugal
  T G[size];         ///< gravity torque, N m or N
};

}  // namespace axial
