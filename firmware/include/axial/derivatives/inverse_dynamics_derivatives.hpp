// Derivatives of inverse dynamics: efforts, mass matrix and both Jacobians in one pass.
#pragma once

#include <axial/derivatives/derivative_entries.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// The algorithm's results, joint values as callers have them.
template <class Result>
struct Slopes {
  /// over links
  template <class Links, class Input, class Q, class V, class A>
  AXIAL_INLINE static constexpr Result run(const Links& links, const Input& in, const Q& q, const V& qd, const A& qdd) {
    auto result = blank<Links, Result>();
    Entries<Links, Result> entries{result};
    derivatives::run(links, in, links.read(q), links.read(qd), links.read(qdd), entries);
    write_between_branches(links, entries);
    return result;
  }
};

}  // namespace derivatives

/// Inverse dynamics with its derivatives, in one pass: efforts tau (N m or N), mass matrix M, dtau_dq(i, j) = d tau_i /
/// d q_j and dtau_dqd(i, j) = d tau_i / d qd_j at given q, qd, qdd; d tau / d qdd is M. `Wanted` are with_efforts,
/// with_mass_matrix, with_position_jacobian, with_velocity_jacobian; all of them unless some are named: what is not
/// asked for has no member and no code.
/// Friction adds friction_slope() to the diagonal: no slope describes the jump of dry friction at rest. A payload moves
/// with the last link; wrenches are constant in the axes of the link that they act on. A base that moves or floats
/// keeps the motion that the inputs say. Errors: tests/property/algorithms/derivatives_test.cpp holds them below 1e-6
/// of a block's largest entry in float for three arms, below 1e-13 in double for all that it knows. In fixed point
/// every entry has an exponent and a certified error (error_bound()), where q, qd and qdd are inside the declared
/// limits. Source: Singh, Russell and Wensing 2022, "Efficient Analytical Derivatives of Rigid-Body Dynamics Using
/// Spatial Vector Algebra" (arXiv 2105.05102), in link frames with successive axial screws. NaN and infinities
/// propagate.
template <class S, class... Wanted, class T>
[[nodiscard]] constexpr InverseDynamicsDerivatives<S, T, Wanted...> inverse_dynamics_derivatives(
    const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd, const Accelerations<robot_of<S>, T>& qdd,
    const Inputs<S, T>& in = no_inputs<S, T>()) {
  detail::check_derivable<scene_of<S>, T>();
  return execute<derivatives::Slopes<InverseDynamicsDerivatives<S, T, Wanted...>>>(
      links_of<S, T, BaseParameters, recursion::Derivatives>(), in, q, qd, qdd);
}
/// Overload for a run-time model.
template <class... Wanted, int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr InverseDynamicsDerivatives<M, T, Wanted...> inverse_dynamics_derivatives(
    const Model<N, F...>& model, const Positions<M, T>& q, const Velocities<M, T>& qd, const Accelerations<M, T>& qdd,
    const Inputs<M, T>& in = no_inputs<M, T>()) {
  detail::check_derivable<scene_of<M>, T>();
  return execute<derivatives::Slopes<InverseDynamicsDerivatives<M, T, Wanted...>>>(model.template links<T>(), in, q, qd,
                                                                                   qdd);
}

}  // namespace axial

#include <axial/options/end.hpp>
