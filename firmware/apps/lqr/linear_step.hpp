#pragma once
/// One tick of an arm, and its derivatives.

#include <axial/axial.hpp>

#include "matrix.hpp"

namespace axial::apps {

/// x = (q, qd) after a tick: dx' = A dx + B du for small changes dx of x and du of the efforts.
template <int N>
struct LinearStep {
  Matrix<2 * N, 2 * N> A;
  Matrix<2 * N, N> B;
};

/// The derivatives of a tick of T seconds under constant acceleration, q' = q + T qd + T^2/2 qdd and qd' = qd + T qdd:
/// A = [1 + T^2/2 a, T + T^2/2 b; T a, 1 + T b] and B = [T^2/2 M^-1; T M^-1], where a = dqdd_dq, b = dqdd_dqd.
template <class S>
constexpr LinearStep<joint_count<S>> linear_step(const ForwardDynamicsDerivatives<S, float>& d, float T) {
  constexpr int n = joint_count<S>;
  const float half = 0.5F * T * T;
  LinearStep<n> step;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      step.A(i, j) = half * d.dqdd_dq(i, j), step.A(i, n + j) = half * d.dqdd_dqd(i, j);
      step.A(n + i, j) = T * d.dqdd_dq(i, j), step.A(n + i, n + j) = T * d.dqdd_dqd(i, j);
      step.B(i, j) = half * d.M_inverse(i, j), step.B(n + i, j) = T * d.M_inverse(i, j);
    }
    step.A(i, i) += 1.0F, step.A(i, n + i) += T, step.A(n + i, n + i) += 1.0F;
  }
  return step;
}

}  // namespace axial::apps
