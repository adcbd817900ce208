// The force between a robot and what carries it.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/base/floating_base.hpp>
#include <axial/dynamics/inverse_dynamics.hpp>
#include <axial/scene/joints.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A force as plain numbers: moment (N m) about the origin of a frame and force (N), in its axes.
template <class T>
using Wrench = ForceVector<Vec3<T>, Vec3<T>>;

namespace rnea {

/// Force that moves the base body as the scene's inputs say, less what pushes it; zero by type where nothing floats.
template <class Links, class Input>
AXIAL_INLINE constexpr auto base_body_force(const Links& links, const Input& in) {
  if constexpr (Links::Scene::template has<FloatingBase>) {
    auto body = base_link(links);
    auto motion = base(links, in);
    return newton_euler(body, body.body(), body.inertia_differences(), motion) - base_load(links, in) +
           base_force_on_water(links, in, body, motion.p, motion.u, motion.dw, motion.a);
  } else {
    return ForceVector<ZeroVec3, ZeroVec3>{};
  }
}

/// The inward pass of inverse dynamics, without the joints' efforts.
struct ForceOnBase {
  using Roles = axial::Roles<role::Position, role::Velocity, role::Acceleration>;  ///< of its arguments
  /// the force, N m and N
  template <class Links, class Input, class Q, class V, class A>
  AXIAL_INLINE static constexpr auto run(const Links& links, const Input& in, const Q& q, const V& qd, const A& qdd) {
    auto screws = joint_screws(links, in, q);
    auto motions = link_motions(links, in, screws, qd, qdd);
    auto water = immersions(links, in, screws, qd);
    auto own = [&](auto i) AXIAL_INLINE { return own_force(links, in, motions, water, i); };
    auto joint = [&](auto i, const auto& force)
                     AXIAL_INLINE { return InwardResult{force_on_parent(links, screws, i, force)}; };
    return with_roots(links, inward(links, own, joint), base_body_force(links, in));
  }
};
/// The same over any links; nothing where calls have refused the scene.
template <class Links, class... Arguments>
AXIAL_INLINE constexpr auto force_on_base(const Links& links, Arguments&&... arguments) {
  if constexpr (Links::Scene::template has<RotorDynamics>)
    return RefusedLinks<typename Links::Scene>{};
  else
    return execute<ForceOnBase>(links, arguments...);
}

/// What a wrench of the base refuses, once for a scene. In fixed point Inputs have refused rotors.
template <class Scene, class T>
constexpr auto check_base_wrench() {
  static_assert(detail::is_word<T> || !Scene::template has<RotorDynamics>,
                "axial: base_wrench has no rotors as bodies; take RotorDynamics out of the scene");
  if constexpr (Scene::template has<FloatingBase>) detail::check_base_body<typename Scene::Robot>();
  detail::Forms<Scene, T>::template check<recursion::BaseForce>();
}

}  // namespace rnea

/// Answer of base_wrench() for a scene.
template <class, class T>
using WrenchOf = Wrench<T>;

/// Force that whatever carries the robot exerts on it at frame 0 for a given motion: moment (N m) about the origin and
/// force (N), in axes of frame 0, gravity held up. On a floating base: what must push it, besides the input
/// `base_wrench`, to move with in.base_motion; zero for the motion that forward_dynamics finds.
/// Inputs as for inverse_dynamics. Always on full parameters: a mount feels what no joint feels.
template <class S, class T>
[[nodiscard]] constexpr Wrench<T> base_wrench(const Positions<robot_of<S>, T>& q, const Velocities<robot_of<S>, T>& qd,
                                              const Accelerations<robot_of<S>, T>& qdd,
                                              const Inputs<S, T>& in = no_inputs<S, T>()) {
  static_assert(!scene_of<S>::template has<BaseParameters>,
                "axial: base_wrench needs every link's own parameters, which BaseParameters regroups; take "
                "BaseParameters out of the scene");
  rnea::check_base_wrench<scene_of<S>, T>();
  return rnea::force_on_base(links_of<S, T, FullParameters, recursion::BaseForce>(), in, q, qd, qdd);
}
/// Overload for a run-time model.
template <int N, class... F, class T, class M = Model<N, F...>>
[[nodiscard]] constexpr Wrench<T> base_wrench(const Model<N, F...>& model, const Positions<M, T>& q,
                                              const Velocities<M, T>& qd, const Accelerations<M, T>& qdd,
                                              const Inputs<M, T>& in = no_inputs<M, T>()) {
  rnea::check_base_wrench<scene_of<M>, T>();
  return rnea::force_on_base(model.template links<T>(), in, q, qd, qdd);
}

}  // namespace axial

#include <axial/options/end.hpp>
