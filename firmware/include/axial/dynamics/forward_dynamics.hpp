// Forward dynamics: accelerations from efforts.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/articulated_body.hpp>
#include <axial/dynamics/composite_body.hpp>
#include <axial/dynamics/free_response.hpp>
#include <axial/dynamics/route.hpp>
#include <axial/recursion/forward_soundness.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

template <Route route, class Scene, class T, class Input, class Q, class V, class Tau, class A>
AXIAL_INLINE constexpr StatusOf<T> solve(const Input& in, const Q& q, const V& qd, const Tau& tau, A& qdd) {
  if constexpr (route == Route::composite_body)
    return execute<crba::Accelerations>(links_of<Scene, T, BaseParameters>(), in, q, qd, tau, qdd);
  else if constexpr (route == Route::split_articulated_body)
    return execute<aba::SplitForm>(links_of<Scene, T, FullParameters, recursion::ArticulatedBodiesAtRest>(),
                                   links_of<Scene, T, BaseParameters, recursion::MotionEfforts>(), in, q, qd, tau, qdd);
  else
    return aba::run(links_of<Scene, T, FullParameters, recursion::ArticulatedBodies>(), in, q, qd, tau, qdd);
}

/// Route of a scene over numbers T; a number system may have fewer.
template <class S, class T>
struct RouteOver {
  static constexpr Route value = forward_dynamics_route<S>;
};
template <class S, class T>
inline constexpr Route route_over = RouteOver<S, T>::value;

/// Says which joint of a scene moves no mass, for calls that then leave forward dynamics out: a parameter, so that
/// compilers print its index.
template <class Scene, int joint = unresisted_joint<Scene>()>
constexpr auto check_resisted() {
  static_assert(every_joint_moves_mass_but<joint>, AXIAL_JOINTS_MOVE_MASS);
}
/// What forward dynamics refuses, said once for a scene; a number system may refuse more.
template <class Scene, class T>
constexpr auto check_solvable() {
  if constexpr (Scene::template has<FloatingBase>) check_base_body<typename Scene::Robot>();
  Forms<Scene, T>::template check<recursion::ArticulatedBodiesAtRest>();
}

/// A run-time model has full parameters and no compile-time choice: ABA unless its features name another form.
template <class Scene>
inline constexpr Route model_route = Scene::by_composite_bodies                  ? Route::composite_body
                                     : Scene::template has<SplitArticulatedBody> ? Route::split_articulated_body
                                                                                 : Route::articulated_body;

template <Route route, class Links, class Input, class Q, class V, class Tau, class A>
AXIAL_INLINE constexpr auto solve_model(const Links& links, const Input& in, const Q& q, const V& qd, const Tau& tau,
                                        A& qdd) {
  if constexpr (route == Route::composite_body)
    return execute<crba::Accelerations>(links, in, q, qd, tau, qdd);
  else if constexpr (route == Route::split_articulated_body)
    return execute<aba::SplitForm>(links, links, in, q, qd, tau, qdd);
  else
    return aba::run(links, in, q, qd, tau, qdd);
}

}  // namespace detail

/// Accelerations for given efforts, by the route that `forward_dynamics_route<S>` names: ABA on full parameters
/// (articulated_body.hpp), its split form, or composite bodies on base parameters (composite_body.hpp).
/// In: q (rad or m), qd, tau (N m or N); `in` carries the run-time inputs that the scene names.
/// Out: rad/s^2 or m/s^2, indexed by joint, and a status: not_finite where an input or a result is NaN or infinite,
/// angle_range where angles are too large for exact sines; near_singular names a joint whose articulated inertia is
/// lost in the rounding of the composite one. It is solved for all the same; where nothing is left of it, it is held:
/// its acceleration is 0 and the rest moves as if it were locked. On a floating base the result holds the base's
/// acceleration too, and joint -1 stands for the base. A robot with a joint that no mass, inertia or rotor resists does
/// not compile.
/// In fixed point any words may be given. Efforts beyond the declared ones: see fixed/dynamics/drive_scale.hpp. Where
/// efforts could drive a joint at over 1024 times what it declares an answer so far beyond that it may be off by more
/// than a thousandth of the largest declared acceleration stands, named (acceleration_limit). A
/// position or a speed beyond its limit is named (position_limit, speed_limit: the first joint from the base), inputs
/// beyond what is declared likewise (payload_limit, input_limit); accelerations are then 0, for formats hold no more,
/// unless nothing but the angles of turning joints is beyond: those have no end, and are solved all the same. Who wants
/// the nearest state inside takes clamped_request() first.
template <class S, class T>
[[nodiscard]] constexpr ForwardDynamicsOf<S, T> forward_dynamics(const Positions<robot_of<S>, T>& q,
                                                                 const Velocities<robot_of<S>, T>& qd,
                                                                 const EffortsOf<S, T>& tau,
                                                                 const Inputs<S, T>& in = no_inputs<S, T>()) {
  constexpr int joint = unresisted_joint<S>();
  static_assert(every_joint_moves_mass_but<joint>, AXIAL_JOINTS_MOVE_MASS);
  detail::check_solvable<scene_of<S>, T>();
  ForwardDynamicsOf<S, T> result{};
  const detail::StateCheck<S, T> check(in, q, qd);
  result.status = detail::solve<detail::route_over<S, T>, scene_of<S>, T>(in, q, qd, tau, result);
  check.judge(result);
  return result;
}
/// Overload for a run-time model: ABA, unless its features name another form.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr ForwardDynamicsOf<M, T> forward_dynamics(const Model<N, F...>& model, const Positions<M, T>& q,
                                                                 const Velocities<M, T>& qd, const Efforts<M, T>& tau,
                                                                 const Inputs<M, T>& in = no_inputs<M, T>()) {
  ForwardDynamicsOf<M, T> result{};
  const auto links = model.template links<T>();
  if constexpr (!is_refused<std::decay_t<decltype(links)>>) {
    const auto asked = detail::collected_request(links, in, q, qd);
    const auto solved = detail::solve_model<detail::model_route<scene_of<M>>>(links, in, q, qd, tau, result);
    result.status = detail::sound_status(links, asked, result, solved);
  }
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
