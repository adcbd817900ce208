// Derivatives of forward dynamics: accelerations, inverse mass matrix and both Jacobians.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/derivatives/forward_slopes.hpp>
#include <axial/recursion/forward_soundness.hpp>
#include <axial/recursion/joint_screws.hpp>

#include <type_traits>

#include <axial/options/begin.hpp>

namespace axial {
namespace derivatives {

/// Whether sines are called: of arms of five joints and more that the compiler knows, where none are packed. A call
/// takes some twenty instructions more than the same in line, and stands for 45 of them.
template <class Links>
constexpr bool calls_sines() {
  using T = typename Links::Scalar;
  if constexpr (Links::unrolled && std::is_floating_point_v<T> && !Links::Scene::template has<SineCosines>)
    return Links::capacity > 4 && !packing_pays<T>(detail::revolute_joints<Links>());
  else
    return false;
}
/// sincos() as a function of its own.
template <class T>
[[gnu::noinline]] constexpr SinCos<T> called_sincos(T x) {
  return sincos(x);
}

/// joint_screws(), in less flash where that takes little time; the bits are the same.
template <class Links, class Input, class Q>
AXIAL_INLINE constexpr auto screws(const Links& links, const Input& in, const Q& q) {
  if constexpr (calls_sines<Links>())
    return map_links(links, [&](auto i) AXIAL_INLINE {
      if constexpr (Links::Scene::Robot::chain.links[i].type == JointType::revolute)
        return links.link(i).z(q[i], called_sincos(q[i]));
      else
        return links.link(i).z(q[i]);
    });
  else
    return joint_screws(links, in, q);
}

/// Takes the entries at rest: of the mass matrix, and the efforts that are left for accelerations.
template <class Matrix, class Tau, class A>
struct RestEntries {
  Matrix& m;       ///< referred to
  const Tau& tau;  ///< referred to
  A& left;         ///< referred to

  /// What effort x leaves of tau_i, N m or N.
  template <class I, class X>
  AXIAL_INLINE constexpr void effort(I i, const X& x) {
    left[i] = tau[i] - x;
  }
  /// M(i, j)
  template <class I, class J, class X>
  AXIAL_INLINE constexpr void mass(I i, J j, const X& x) {
    m.set(i, j, x);
  }
  /// Entries of the Jacobians are not taken.
  ///@{
  template <class I, class J, class X>
  AXIAL_INLINE constexpr void position(I, J, const X&) {}
  template <class I, class J, class X>
  AXIAL_INLINE constexpr void velocity(I, J, const X&) {}
  ///@}
};
template <class Matrix, class Tau, class A>
RestEntries(Matrix&, const Tau&, A&) -> RestEntries<Matrix, Tau, A>;

/// M becomes its factors and what efforts leave, `qdd`, becomes accelerations; their status.
template <class Links, class A, class F>
AXIAL_INLINE constexpr auto eliminate(const Links& links, A& qdd, F& factors) {
  const auto composite = map_links(links, [&](auto i) AXIAL_INLINE { return factors.m(i, i); });
  const auto status = crba::solve(links, factors.m, qdd);
  for_each_link(links, [&](auto i) AXIAL_INLINE {
    factors.inverses[i] = crba::pivot(links.link(i), factors.m(i, i), composite[i]).inverse;
  });
  return status;
}
/// Accelerations, their status and the factors of M, from one pass at qdd = 0.
template <class Links, class Input, class Q, class Screws, class V, class Tau, class A, class F>
AXIAL_INLINE constexpr auto solve_and_factor(const Links& links, const Input& in, const Q& q, const Screws& screws,
                                             const V& qd, const Tau& tau, A& qdd, F& factors) {
  RestEntries at_rest{factors.m, tau, qdd};
  entries(links, in, q, screws, qd, NoMotion{}, at_rest);
  return eliminate(links, qdd, factors);
}

/// How a number system with formats computes them: fixed/derivatives/forward_derivatives.hpp.
template <class S, class T>
struct ForwardOver;

/// The algorithm over any form of links: all results but the status, which it returns.
struct ForwardSlopes {
  /// the algorithm
  template <class Links, class Input, class Q, class V, class Tau, class Result>
  AXIAL_INLINE static constexpr auto run(const Links& links, const Input& in, const Q& q, const V& qd, const Tau& tau,
                                         Result& result) {
    using T = typename Links::Scalar;
    const auto screws = derivatives::screws(links, in, q);
    Row<T, Links::capacity> qdd;  // not the result, a store to which may change q for all that the compiler knows
    Factors<MassMatrix<typename Links::Scene::Robot, T>, T, Links::capacity> factors;
    if constexpr (is_long<Links>) {
      Row<T, Links::capacity> at, rates;
      for_each_link(links, [&](auto i) AXIAL_INLINE {
        at[i] = q[i];
        rates[i] = qd[i];
      });
      const Input given = in;
      const auto status = solve_and_factor(links, given, at, screws, rates, tau, qdd, factors);
      for_each_link(links, [&](auto i) AXIAL_INLINE { result.qdd[i] = qdd[i]; });
      long_slopes(links, given, at, screws, rates, qdd, factors, result);
      return status;
    } else {
      const auto status = solve_and_factor(links, in, q, screws, qd, tau, qdd, factors);
      SlopeEntries<Result> slopes{result};
      entries(links, in, q, screws, qd, qdd, slopes);
      write_between_branches(links, slopes);
      for_each_link(links, [&](auto i) AXIAL_INLINE { result.qdd[i] = qdd[i]; });
      if constexpr (Result::template has<with_inverse_mass_matrix>) invert(links, factors, result.M_inverse);
      solve_slopes(links, factors, result);
      return status;
    }
  }
};

/// Collects what of a matrix is the answer's.
template <class T, class Matrix>
AXIAL_INLINE constexpr void collect_entries(Soundness<T>& all, int size, const Matrix& matrix) {
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      all.number(matrix(i, j));
}
/// Collects the derivatives, which may overflow where accelerations do not.
template <class T, class Result>
AXIAL_INLINE constexpr void collect_slopes(Soundness<T>& all, int size, const Result& result) {
  if constexpr (Result::template has<with_inverse_mass_matrix>)
    for (int i = 0; i < size; ++i)
      for (int j = 0; j <= i; ++j)
        all.number(result.M_inverse(i, j));  // symmetric
  if constexpr (Result::template has<with_acceleration_by_position>) collect_entries(all, size, result.dqdd_dq);
  if constexpr (Result::template has<with_acceleration_by_velocity>) collect_entries(all, size, result.dqdd_dqd);
}

/// The results of a robot's links in floating point, in a variable that no block of its own keeps from being the
/// caller's.
template <class S, class T, class... Wanted>
AXIAL_INLINE constexpr ForwardDynamicsDerivatives<S, T, Wanted...> forward_of_numbers(
    const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd, const EffortsOf<S, T>& tau,
    const Inputs<S, T>& in) {
  constexpr auto links = links_of<S, T, BaseParameters, recursion::Derivatives>();
  auto result = blank<decltype(links), ForwardDynamicsDerivatives<S, T, Wanted...>>();
  const detail::StateCheck<S, T> check(in, q, qd);
  result.qdd.status = execute<ForwardSlopes>(links, in, q, qd, tau, result);
  check.judge(result.qdd, [&](auto& all) AXIAL_INLINE { collect_slopes(all, joint_count<S>, result); });
  return result;
}

}  // namespace derivatives

/// Forward dynamics with its derivatives: accelerations qdd with a status, M_inverse = d qdd / d tau, dqdd_dq(i, j) =
/// d qdd_i / d q_j and dqdd_dqd(i, j) at given q, qd and efforts tau: -M^-1 times those of inverse dynamics at that
/// qdd. `Wanted` are with_inverse_mass_matrix, with_acceleration_by_position, with_acceleration_by_velocity; all of
/// them unless some are named. By composite bodies and L^T D L, whatever route forward_dynamics() takes; `qdd.status`
/// is as that of forward_dynamics(): inaccurate where the elimination loses too much, near_singular with the joint that
/// is held. A base may move as it is told, not freely. In 32-bit words: certified_forward_dynamics_derivatives()
/// without its bounds, which has other statuses. Source: Carpentier and Mansard 2018, "Analytical Derivatives of Rigid
/// Body Dynamics Algorithms", eq. (5); the rest as inverse_dynamics_derivatives().
template <class S, class... Wanted, class T>
[[nodiscard]] constexpr ForwardDynamicsDerivatives<S, T, Wanted...> forward_dynamics_derivatives(
    const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd, const EffortsOf<S, T>& tau,
    const Inputs<S, T>& in = no_inputs<S, T>()) {
  detail::check_forward_derivable<scene_of<S>, T>();
  static_assert(every_joint_moves_mass_but<unresisted_joint<S>()>, AXIAL_JOINTS_MOVE_MASS);
  if constexpr (is_number_v<T>)
    return derivatives::forward_of_numbers<S, T, Wanted...>(q, qd, tau, in);
  else
    return derivatives::ForwardOver<S, T>::template of<Wanted...>(q, qd, tau, in);
}
/// Overload for a run-time model.
template <class... Wanted, int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr ForwardDynamicsDerivatives<M, T, Wanted...> forward_dynamics_derivatives(
    const Model<N, F...>& model, const Positions<M, T>& q, const Velocities<M, T>& qd, const Efforts<M, T>& tau,
    const Inputs<M, T>& in = no_inputs<M, T>()) {
  detail::check_forward_derivable<scene_of<M>, T>();
  ForwardDynamicsDerivatives<M, T, Wanted...> result{};
  const auto links = model.template links<T>();
  auto asked = detail::collected_request(links, in, q, qd);
  const auto solved = execute<derivatives::ForwardSlopes>(links, in, q, qd, tau, result);
  derivatives::collect_slopes(asked, joint_count<M>, result);
  result.qdd.status = detail::sound_status(links, asked, result.qdd, solved);
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
