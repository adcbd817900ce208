// How joint torques change in time: inverse dynamics with its first and second derivative along a trajectory.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/derivatives/inverse_dynamics_along.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Efforts and their first derivative by time.
template <class S, class T>
struct TorqueRate {
  EffortsOf<S, T> tau{};   ///< N m or N
  EffortsOf<S, T> taud{};  ///< N m/s or N/s
};
/// Efforts and their first and second derivative by time.
template <class S, class T>
struct TorqueRates {
  EffortsOf<S, T> tau{};    ///< N m or N
  EffortsOf<S, T> taud{};   ///< N m/s or N/s
  EffortsOf<S, T> taudd{};  ///< N m/s^2 or N/s^2
};

namespace derivatives {

/// Efforts with their rates, written into `result`.
template <class Links, class Input, class Q, class V, class A, class J, class S, class Result>
AXIAL_INLINE constexpr void write_rates(const Links& links, const Input& in, const Q& q, const V& qd, const A& qdd,
                                        const J& q3, const S& q4, Result& result) {
  execute<InTime>(links, in, q, qd, qdd, q3, q4, [&](auto i, const auto& effort) AXIAL_INLINE {
    links.write(result.tau, i, value_at_0(effort));
    links.write(result.taud, i, linear_of(effort));
    links.write(result.taudd, i, twice(quadratic_of(effort)));
  });
}
/// Efforts with the first rate alone, written into `result`.
template <class Links, class Input, class Q, class V, class A, class J, class Result>
AXIAL_INLINE constexpr void write_rate(const Links& links, const Input& in, const Q& q, const V& qd, const A& qdd,
                                       const J& q3, Result& result) {
  execute<Along>(links, in, TaylorValues{q, qd}, TaylorValues{qd, qdd}, TaylorValues{qdd, q3},
                 [&](auto i, const auto& effort) AXIAL_INLINE {
                   links.write(result.tau, i, value_of(effort));
                   links.write(result.taud, i, slope_of(effort));
                 });
}

}  // namespace derivatives
namespace detail {

// Scenes and numbers that rates in time are offered for; kernels look at no others.
template <class Scene, class T>
inline constexpr bool has_rates =
    is_number_v<T> && !Scene::template has<BaseMotion> && !Scene::template has<FloatingBase> &&
    !Scene::template has<Underwater> && !Scene::template has<Friction>;
template <class Scene, class T>
constexpr auto check_rates() {
  static_assert(is_number_v<T>, "axial: torque rates have no formats in fixed point; compute them in float");
  static_assert(!Scene::template has<BaseMotion> && !Scene::template has<FloatingBase>,
                "axial: torque rates are those of a base at rest; take BaseMotion and FloatingBase out of the scene");
  static_assert(!Scene::template has<Underwater>,
                "axial: torque rates have no water; take Underwater out of the scene");
  static_assert(!Scene::template has<Friction>,
                "axial: dry friction jumps at rest and has no rate; take Friction out of the scene, and add friction "
                "where the drive is");
}

}  // namespace detail

/// Efforts tau = inverse_dynamics(q, qd, qdd) and their rate d tau / dt along a trajectory whose third derivative is q3
/// (rad/s^3 or m/s^3): what a drive's torque loop is asked to follow, and a limit of torque rates to be compared with.
/// Run-time inputs stay as they are: a wrench is constant in the axes of its link. NaN and infinities propagate; in
/// floating point, for a base at rest, in air, without friction.
/// Source: Buondonno and De Luca 2015; by differentiation of inverse_dynamics() itself along its motion.
template <class S, class T>
[[nodiscard]] constexpr TorqueRate<S, T> torque_rates(const Positions<robot_of<S>, T>& q,
                                                      const Velocities<robot_of<S>, T>& qd,
                                                      const Accelerations<robot_of<S>, T>& qdd,
                                                      const Joints<robot_of<S>, T>& q3,
                                                      const Inputs<S, T>& in = no_inputs<S, T>()) {
  detail::check_rates<scene_of<S>, T>();
  TorqueRate<S, T> result{};
  if constexpr (detail::has_rates<scene_of<S>, T>)
    derivatives::write_rate(links_of<S, T, BaseParameters>(), in, q, qd, qdd, q3, result);
  return result;
}
/// Overload with the second derivative d^2 tau / dt^2, for which q4 is the fourth derivative of q (rad/s^4 or m/s^4):
/// one pass over truncated Taylor numbers, constants of the model remaining plain ones.
template <class S, class T>
[[nodiscard]] constexpr TorqueRates<S, T> torque_rates(
    const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd, const Accelerations<robot_of<S>, T>& qdd,
    const Joints<robot_of<S>, T>& q3, const Joints<robot_of<S>, T>& q4, const Inputs<S, T>& in = no_inputs<S, T>()) {
  detail::check_rates<scene_of<S>, T>();
  TorqueRates<S, T> result{};
  if constexpr (detail::has_rates<scene_of<S>, T>)
    derivatives::write_rates(links_of<S, T, BaseParameters>(), in, q, qd, qdd, q3, q4, result);
  return result;
}
/// Overload for a run-time model.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr TorqueRate<M, T> torque_rates(const Model<N, F...>& model, const Positions<M, T>& q,
                                                      const Velocities<M, T>& qd, const Accelerations<M, T>& qdd,
                                                      const Joints<M, T>& q3,
                                                      const Inputs<M, T>& in = no_inputs<M, T>()) {
  detail::check_rates<scene_of<M>, T>();
  TorqueRate<M, T> result{};
  if constexpr (detail::has_rates<scene_of<M>, T>)
    derivatives::write_rate(model.template links<T>(), in, q, qd, qdd, q3, result);
  return result;
}
/// Overload with the second derivative, for a run-time model.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr TorqueRates<M, T> torque_rates(const Model<N, F...>& model, const Positions<M, T>& q,
                                                       const Velocities<M, T>& qd, const Accelerations<M, T>& qdd,
                                                       const Joints<M, T>& q3, const Joints<M, T>& q4,
                                                       const Inputs<M, T>& in = no_inputs<M, T>()) {
  detail::check_rates<scene_of<M>, T>();
  TorqueRates<M, T> result{};
  if constexpr (detail::has_rates<scene_of<M>, T>)
    derivatives::write_rates(model.template links<T>(), in, q, qd, qdd, q3, q4, result);
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
