// Forward dynamics along a direction: accelerations, and their Jacobians times a vector, without those matrices.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/derivatives/forward_dynamics_derivatives.hpp>
#include <axial/derivatives/inverse_dynamics_along.hpp>
#include <axial/scene/joints.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A direction in which a state and its efforts change: one number per joint and unit of the direction's parameter.
template <class S, class T>
struct StateDirection {
  Positions<S, T> dq{};    ///< rad or m
  Velocities<S, T> dqd{};  ///< rad/s or m/s
  Efforts<S, T> dtau{};    ///< N m or N
};
/// Accelerations of a state, and how they change in a direction of it.
template <class S, class T>
struct AccelerationsAlong {
  ForwardDynamicsOf<S, T> qdd{};         ///< rad/s^2 or m/s^2; its status is that of both
  Accelerations<robot_of<S>, T> dqdd{};  ///< rad/s^2 or m/s^2
};

namespace derivatives {

/// solve_and_factor() from positions themselves.
struct FactorsAt {
  /// status of the accelerations
  template <class Links, class Input, class Q, class V, class Tau, class A, class F>
  AXIAL_INLINE static constexpr auto run(const Links& links, const Input& in, const Q& q, const V& qd, const Tau& tau,
                                         A& qdd, F& factors) {
    return solve_and_factor(links, in, q, joint_screws(links, in, q), qd, tau, qdd, factors);
  }
};
/// Accelerations along a direction, written into `result`: `links` as derivatives of matrices walk over them,
/// `recursion` as inverse dynamics does.
template <class Links, class Recursion, class Input, class Q, class V, class Tau, class Direction, class Result>
AXIAL_INLINE constexpr void accelerations_along(const Links& links, const Recursion& recursion, const Input& in,
                                                const Q& q, const V& qd, const Tau& tau, const Direction& by,
                                                Result& result) {
  using T = typename Links::Scalar;
  Factors<MassMatrix<typename Links::Scene::Robot, T>, T, Links::capacity> factors;
  result.qdd.status = execute<FactorsAt>(links, in, q, qd, tau, result.qdd, factors);
  auto& x = result.dqdd;
  execute<Along>(recursion, in, TaylorValues{q, by.dq}, TaylorValues{qd, by.dqd}, TaylorValues{result.qdd, NoMotion{}},
                 [&](auto i, const auto& effort) AXIAL_INLINE { x[i] = by.dtau[i] - slope_of(effort); });
  substitute(Any{}, execute<Actuators>(links), factors, x);
}

/// Scenes that this is offered for: in floating point alone.
template <class Scene, class T>
constexpr void check_directions() {
  static_assert(is_number_v<T>,
                "axial: accelerations along a direction have no formats in fixed point; compute them in float, or take "
                "forward_dynamics_derivatives()");
  detail::check_forward_derivable<Scene, T>();
}

}  // namespace derivatives

/// Accelerations qdd of forward dynamics, with a status, and their change in a direction of the state, dqdd = d qdd /
/// d q dq + d qdd / d qd dqd + M^-1 dtau: by the factors of M that the accelerations took, and one pass of
/// inverse_dynamics_along(). By composite bodies and L^T D L, whatever route forward_dynamics() takes; `qdd.status` as
/// of forward_dynamics_derivatives(): a joint that is held has no change either. Scenes as there, inputs as of
/// inverse_dynamics_along(). In floating point; a base may move as it is told, not freely.
template <class S, class T>
[[nodiscard]] constexpr AccelerationsAlong<S, T> forward_dynamics_along(const Positions<robot_of<S>, T>& q,
                                                                        const Velocities<robot_of<S>, T>& qd,
                                                                        const EffortsOf<S, T>& tau,
                                                                        const StateDirection<robot_of<S>, T>& direction,
                                                                        const Inputs<S, T>& in = no_inputs<S, T>()) {
  derivatives::check_directions<scene_of<S>, T>();
  static_assert(every_joint_moves_mass_but<unresisted_joint<S>()>, AXIAL_JOINTS_MOVE_MASS);
  AccelerationsAlong<S, T> result{};
  if constexpr (!detail::is_word<T>) {  // else the message alone
    const detail::StateCheck<S, T> check(in, q, qd);
    derivatives::accelerations_along(links_of<S, T, BaseParameters, recursion::Derivatives>(),
                                     links_of<S, T, BaseParameters>(), in, q, qd, tau, direction, result);
    check.judge(result.qdd, [&](auto& all) AXIAL_INLINE {
      for (const auto& x : result.dqdd.values)
        all.number(x);
    });
  }
  return result;
}
/// Overload for a run-time model.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr AccelerationsAlong<M, T> forward_dynamics_along(
    const Model<N, F...>& model, const Positions<M, T>& q, const Velocities<M, T>& qd, const Efforts<M, T>& tau,
    const StateDirection<M, T>& direction, const Inputs<M, T>& in = no_inputs<M, T>()) {
  derivatives::check_directions<scene_of<M>, T>();
  AccelerationsAlong<M, T> result{};
  const auto links = model.template links<T>();
  auto asked = detail::collected_request(links, in, q, qd);
  derivatives::accelerations_along(links, links, in, q, qd, tau, direction, result);
  for (const auto& x : result.dqdd.values)
    asked.number(x);
  result.qdd.status = detail::sound_status(links, asked, result.qdd, result.qdd.status);
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
