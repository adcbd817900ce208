// The base body as the algorithms see it: a link without a joint.
#pragma once

#include <axial/links/links.hpp>
#include <axial/links/run_time_model.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// A robot whose only link is the base body of another, so that one view serves both.
template <class Robot>
struct BaseBodyOf {
  static constexpr auto chain = [] {
    Chain<1> body;
    body.links[0] = Robot::chain.base_body;
    return body;
  }();
};

/// Whether a body that floats is declared.
template <class Robot>
constexpr auto check_base_body() {
  if constexpr (is_described<Robot>)
    static_assert(Robot::chain.has_base_body,
                  "axial: FloatingBase needs the inertia of the body that floats; add "
                  "axial::base_body().mass(kg).com(x, y, z).inertia_com(...) to the robot's chain");
}

template <class Scene, class Robot>
struct SceneOnRobot;
template <class Old, class... Features, class Robot>
struct SceneOnRobot<Scene<Old, Features...>, Robot> {
  using type = Scene<Robot, Features...>;
};

}  // namespace detail

/// The base body: mass, first moment and inertia about the origin of frame 0, in its axes. Constants are types and
/// literals, in the looped form too; a run-time model's are its own numbers.
template <class Links>
AXIAL_INLINE constexpr auto base_link(const Links& links) {
  using Scene = typename Links::Scene;
  using Robot = typename Scene::Robot;
  if constexpr (IsModel<Robot>::value)
    return links.base_link();
  else
    return StaticLink<typename detail::SceneOnRobot<Scene, detail::BaseBodyOf<Robot>>::type, 0, typename Links::Scalar,
                      FullParameters>{};
}

}  // namespace axial

#include <axial/options/end.hpp>
