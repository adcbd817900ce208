// Inverse dynamics along a direction: efforts, and their Jacobians times a vector, without a matrix.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/derivatives/derivative_results.hpp>
#include <axial/derivatives/taylor_motion.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A direction in which a motion changes: one number per joint and unit of the direction's parameter.
template <class S, class T>
struct MotionDirection {
  Positions<S, T> dq{};        ///< rad or m
  Velocities<S, T> dqd{};      ///< rad/s or m/s
  Accelerations<S, T> dqdd{};  ///< rad/s^2 or m/s^2
};
/// Efforts at a motion, and how they change in a direction of it.
template <class S, class T>
struct EffortsAlong {
  EffortsOf<S, T> tau{};   ///< N m or N
  EffortsOf<S, T> dtau{};  ///< N m or N
};

namespace derivatives {

/// Efforts along a direction, written into `result`.
template <class Links, class Input, class Q, class V, class A, class Direction, class Result>
AXIAL_INLINE constexpr void efforts_along(const Links& links, const Input& in, const Q& q, const V& qd, const A& qdd,
                                          const Direction& by, Result& result) {
  execute<Along>(links, in, TaylorValues{q, by.dq}, TaylorValues{qd, by.dqd}, TaylorValues{qdd, by.dqdd},
                 [&](auto i, const auto& effort) AXIAL_INLINE {
                   links.write(result.tau, i, value_of(effort));
                   links.write(result.dtau, i, slope_of(effort));
                 });
}

}  // namespace derivatives
namespace detail {

// Scenes and numbers that directions are offered for.
template <class Scene, class T>
constexpr void check_along() {
  static_assert(is_number_v<T>,
                "axial: derivatives along a direction have no formats in fixed point; compute in float");
  static_assert(!Scene::template has<Underwater>, "axial: derivatives have no water; take Underwater out of the scene");
}

}  // namespace detail

/// Efforts tau = inverse_dynamics(q, qd, qdd) and their change in a direction of the motion, dtau = d tau / d q dq +
/// d tau / d qd dqd + M dqdd, in one pass over the links whose time grows as their number: what Krylov and adjoint
/// methods, directional linearisation and sensitivity along a trajectory need of the Jacobians.
/// The inputs that the scene names stay as they are along the direction: a wrench is constant in the axes of its link,
/// a base that moves keeps its motion. Friction has friction_slope(): no slope describes the jump of dry friction at
/// rest. In floating point, in air. NaN and infinities propagate.
/// Source: forward-mode differentiation (Griewank and Walther 2008, chapter 3) of inverse_dynamics() itself; what a
/// joint's turn changes follows from what it has turned.
template <class S, class T>
[[nodiscard]] constexpr EffortsAlong<S, T> inverse_dynamics_along(const Positions<robot_of<S>, T>& q,
                                                                  const Velocities<robot_of<S>, T>& qd,
                                                                  const Accelerations<robot_of<S>, T>& qdd,
                                                                  const MotionDirection<robot_of<S>, T>& direction,
                                                                  const Inputs<S, T>& in = no_inputs<S, T>()) {
  detail::check_along<scene_of<S>, T>();
  EffortsAlong<S, T> result{};
  if constexpr (!detail::is_word<T>)  // else the message alone
    derivatives::efforts_along(links_of<S, T, BaseParameters>(), in, q, qd, qdd, direction, result);
  return result;
}
/// Overload for a run-time model.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr EffortsAlong<M, T> inverse_dynamics_along(const Model<N, F...>& model, const Positions<M, T>& q,
                                                                  const Velocities<M, T>& qd,
                                                                  const Accelerations<M, T>& qdd,
                                                                  const MotionDirection<M, T>& direction,
                                                                  const Inputs<M, T>& in = no_inputs<M, T>()) {
  detail::check_along<scene_of<M>, T>();
  EffortsAlong<M, T> result{};
  derivatives::efforts_along(model.template links<T>(), in, q, qd, qdd, direction, result);
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
