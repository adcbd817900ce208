// Derivatives of forward dynamics: accelerations, inverse mass matrix and both Jacobians.
#pragma once

#include <axial/dynamics/composite_body.hpp>
#include <axial/dynamics/forward_soundness.hpp>
#include <axial/dynamics/inverse_dynamics_derivatives.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// What forward_dynamics_derivatives() may be asked for besides the accelerations.
///@{
struct with_inverse_mass_matrix {
  /// Its member.
  template <class S, class T>
  struct Result {
    MassMatrixOf<S, T> M_inverse{};  ///< d qdd / d tau, symmetric: 1/(kg m^2), 1/(kg m), 1/kg
  };
};
struct with_acceleration_by_position {
  /// Its member.
  template <class S, class T>
  struct Result {
    JointMatrixOf<S, T, by::Position> dqdd_dq{};  ///< (i, j) = d qdd_i / d q_j, at given efforts
  };
};
struct with_acceleration_by_velocity {
  /// Its member.
  template <class S, class T>
  struct Result {
    JointMatrixOf<S, T, by::Velocity> dqdd_dqd{};  ///< (i, j) = d qdd_i / d qd_j, at given efforts
  };
};
///@}

/// Accelerations, their derivatives that are wanted, and a status: all of them unless some are named.
template <class S, class T, class... Wanted>
struct ForwardDynamicsDerivatives : WantedResults<S, T, Wanted...> {
  ForwardDynamicsOf<S, T> qdd{};  ///< rad/s^2 or m/s^2; its status is that of all
};
/// All of them.
template <class S, class T>
struct ForwardDynamicsDerivatives<S, T>
    : ForwardDynamicsDerivatives<S, T, with_inverse_mass_matrix, with_acceleration_by_position,
                                 with_acceleration_by_velocity> {};

namespace derivatives {

/// M = L^T D L as crba::solve() leaves it: gains below the diagonal, D on it; and 1/D, 0 of a joint that is held.
template <class Matrix, class T, int N>
struct Factors {
  Matrix m{};            ///< gains and D
  Row<T, N> inverses{};  ///< 1/D
};

/// x[i] -= gain x[k] for what carries joint k, and x[k] / D.
template <class Links, class F, class X, class K>
AXIAL_INLINE constexpr void take_inwards(const Links& links, const F& factors, X& x, K k) {
  for_each_ancestor(links, k, [&](auto i) AXIAL_INLINE {
    if constexpr (!decltype(crba::is_absent<Links>(k, i))::value) x[i] = x[i] - factors.m(k, i) * x[k];
  });
  x[k] = factors.inverses[k] * x[k];
}
/// x[k] -= gain x[i] for what carries joint k.
template <class Links, class F, class X, class K>
AXIAL_INLINE constexpr void take_outwards(const Links& links, const F& factors, X& x, K k) {
  for_each_ancestor(links, k, [&](auto i) AXIAL_INLINE {
    if constexpr (!decltype(crba::is_absent<Links>(k, i))::value) x[k] = x[k] - factors.m(k, i) * x[i];
  });
}

/// columns = -M^-1 columns: a loop, for its code would be the longest of all.
template <class Links, class F, class Matrix>
AXIAL_INLINE constexpr void solve_columns(const Links& links, const F& factors, Matrix& matrix) {
  for (int j = 0; j < links.size(); ++j) {
    Row<typename Links::Scalar, Links::capacity> x{};
    for_each_link(links, [&](auto i) AXIAL_INLINE { x[i] = -matrix(i, j); });
    for_each_link_inwards(links, [&](auto k) AXIAL_INLINE { take_inwards(links, factors, x, k); });
    for_each_link(links, [&](auto k) AXIAL_INLINE { take_outwards(links, factors, x, k); });
    for_each_link(links, [&](auto i) AXIAL_INLINE { matrix(i, j) = x[i]; });
  }
}

/// Calls f(k) for links up to j: the others are left out by the compiler where it knows them.
template <class Links, class K, class J, class Step>
AXIAL_INLINE constexpr void up_to(J j, K k, const Step& f) {
  if constexpr (!Links::unrolled) {
    if (k <= j) f(k);
  } else if constexpr (K::value <= J::value) {
    f(k);
  }
}
/// inverse = M^-1: column j of a unit matrix has nothing below j, and what is right of j has a column of its own.
template <class Links, class F, class Matrix>
AXIAL_INLINE constexpr void invert(const Links& links, const F& factors, Matrix& inverse) {
  using T = typename Links::Scalar;
  for_each_link(links, [&](auto j) AXIAL_INLINE {
    Row<T, Links::capacity> x{};
    x[j] = T(One{});
    for_each_link_inwards(links, [&](auto k) AXIAL_INLINE {
      up_to<Links>(j, k, [&](auto at) AXIAL_INLINE { take_inwards(links, factors, x, at); });
    });
    for_each_link(links, [&](auto k) AXIAL_INLINE {
      up_to<Links>(j, k, [&](auto at) AXIAL_INLINE {
        take_outwards(links, factors, x, at);
        inverse(j, at) = x[at];
      });
    });
  });
}

/// Accelerations and the factors of M, from one pass at qdd = 0.
template <class Links, class Input, class Q, class V, class Tau, class A, class F>
AXIAL_INLINE constexpr void solve_and_factor(const Links& links, const Input& in, const Q& q, const V& qd,
                                             const Tau& tau, A& qdd, F& factors) {
  using T = typename Links::Scalar;
  using Robot = typename Links::Scene::Robot;
  InverseDynamicsDerivatives<Robot, T, with_efforts, with_mass_matrix> at_rest{};
  Entries<Links, decltype(at_rest)> entries{at_rest};
  run(links, in, q, qd, NoMotion{}, entries);
  for_each_link(links, [&](auto i) AXIAL_INLINE { qdd[i] = tau[i] - at_rest.tau[i]; });
  factors.m = at_rest.M;
  const auto composite = map_links(links, [&](auto i) AXIAL_INLINE { return factors.m(i, i); });
  qdd.status = crba::solve(links, factors.m, qdd);
  for_each_link(links, [&](auto i) AXIAL_INLINE {
    factors.inverses[i] = crba::pivot(links.link(i), factors.m(i, i), composite[i]).inverse;
  });
}

/// The algorithm over any form of links.
template <class Links, class Input, class Q, class V, class Tau, class Result>
AXIAL_INLINE constexpr void run_forward(const Links& links, const Input& in, const Q& q, const V& qd, const Tau& tau,
                                        Result& result) {
  using T = typename Links::Scalar;
  using Robot = typename Links::Scene::Robot;
  Factors<MassMatrix<Robot, T>, T, Links::capacity> factors;
  solve_and_factor(links, in, q, qd, tau, result.qdd, factors);
  InverseDynamicsDerivatives<Robot, T, with_position_jacobian, with_velocity_jacobian> slopes{};
  Entries<Links, decltype(slopes)> entries{slopes};
  run(links, in, q, qd, result.qdd, entries);
  if constexpr (Result::template has<with_acceleration_by_position>) {
    result.dqdd_dq = slopes.dtau_dq;
    solve_columns(links, factors, result.dqdd_dq);
  }
  if constexpr (Result::template has<with_acceleration_by_velocity>) {
    result.dqdd_dqd = slopes.dtau_dqd;
    solve_columns(links, factors, result.dqdd_dqd);
  }
  if constexpr (Result::template has<with_inverse_mass_matrix>) invert(links, factors, result.M_inverse);
}

}  // namespace derivatives

/// Forward dynamics with its derivatives: accelerations qdd with a status, M_inverse = d qdd / d tau, dqdd_dq(i, j) =
/// d qdd_i / d q_j and dqdd_dqd(i, j) at given q, qd and efforts tau: -M^-1 times those of inverse dynamics at that
/// qdd. `Wanted` are with_inverse_mass_matrix, with_acceleration_by_position, with_acceleration_by_velocity; all of
/// them unless some are named. By composite bodies and L^T D L, whatever route forward_dynamics() takes; `qdd.status`
/// is as that of forward_dynamics(): inaccurate where the elimination loses too much, near_singular with the joint that
/// is held. In floating point; for a base at rest. Source: Carpentier and Mansard 2018, "Analytical Derivatives of
/// Rigid Body Dynamics Algorithms", eq. (5); the rest as inverse_dynamics_derivatives().
template <class S, class... Wanted, class T>
[[nodiscard]] constexpr ForwardDynamicsDerivatives<S, T, Wanted...> forward_dynamics_derivatives(
    const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd, const EffortsOf<S, T>& tau,
    const Inputs<S, T>& in = {}) {
  detail::check_forward_derivable<scene_of<S>, T>();
  static_assert(
      every_joint_is_resisted<S>(),
      "axial: forward dynamics needs every joint to move some mass, inertia or rotor; give the links outboard of "
      "each joint a mass, an inertia about the joint axis, or rotor_inertia()");
  ForwardDynamicsDerivatives<S, T, Wanted...> result{};
  const detail::StateCheck<S, T> check(in, q, qd);
  derivatives::run_forward(links_of<S, T, BaseParameters, recursion::Derivatives>(), in, q, qd, tau, result);
  check.judge(result.qdd);
  return result;
}
/// The same for a run-time model.
template <class... Wanted, int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr ForwardDynamicsDerivatives<M, T, Wanted...> forward_dynamics_derivatives(
    const Model<N, F...>& model, const Positions<M, T>& q, const Velocities<M, T>& qd, const Efforts<M, T>& tau,
    const Inputs<M, T>& in = {}) {
  detail::check_forward_derivable<scene_of<M>, T>();
  ForwardDynamicsDerivatives<M, T, Wanted...> result{};
  const auto links = model.template links<T>();
  const auto asked = detail::collected_request(links, in, q, qd);
  derivatives::run_forward(links, in, q, qd, tau, result);
  result.qdd.status = detail::sound_status(links, asked, result.qdd, result.qdd.status);
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
