// Dynamics with its terms apart: what the Automatic Separation Method and the closed forms return.
#pragma once

#include <axial/scene/joints.hpp>
#include <axial/scene/status.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Mass matrix, kg m^2 (kg m, kg).
template <class S, class T>
struct SeparatedA {
  static constexpr int size = joint_count<S>;  ///< number of joints
  T A[size][size];                             ///< A[i][j], symmetric
};
/// Coriolis matrix. Column pair(j, k) belongs to qd_j qd_k, j < k.
template <class S, class T>
struct SeparatedB {
  static constexpr int size = joint_count<S>;                       ///< number of joints
  static constexpr int pairs = size > 1 ? size*(size - 1) / 2 : 1;  ///< columns of B; one joint alone has an unused one
  T B[size][pairs];  ///< B[i][pair(j, k)]: kg m^2, or with prismatic joints kg m or kg

  /// (qd1 qd2, qd1 qd3, ..., qd_{n-1} qd_n), joints counted from 0 here, either way round.
  static constexpr int pair(int j, int k) {
    return j < k ? j * size - j * (j + 1) / 2 + k - j - 1 : k * size - k * (k + 1) / 2 + j - k - 1;
  }
};
/// Centrifugal matrix, columns (qd1^2, ..., qdn^2).
template <class S, class T>
struct SeparatedC {
  static constexpr int size = joint_count<S>;  ///< number of joints
  T C[size][size];                             ///< C[i][j]: kg m^2, or with prismatic joints kg m or kg
};
/// Effort at rest: gravity, and springs and wrenches that the scene names; N m or N.
template <class S, class T>
struct SeparatedG {
  static constexpr int size = joint_count<S>;  ///< number of joints
  T G[size];                                   ///< one per joint
};

/// A(q) qdd + B(q) [qd qd] + C(q) [qd^2] + G(q) = tau, Djuric et al. 2016, eq. (1). S is a robot or a scene.
template <class S, class T>
struct Separated : SeparatedA<S, T>, SeparatedB<S, T>, SeparatedC<S, T>, SeparatedG<S, T> {
  static constexpr int size = joint_count<S>;  ///< number of joints
  StatusOf<T> status{};                        ///< whether they are numbers, see separate()
};

}  // namespace axial

#include <axial/options/end.hpp>
