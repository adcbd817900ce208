// What frame 0 does: at rest, tilted, or moving as the scene's inputs say.
#pragma once

#include <axial/links/links.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Whether frame 0 moves: as it is told, or freely.
template <class Scene>
inline constexpr bool base_moves = Scene::template has<BaseMotion> || Scene::template has<FloatingBase>;

/// Acceleration of free fall in axes of frame 0, m/s^2.
template <class Links, class Input>
AXIAL_INLINE constexpr auto gravity_at_base(const Links& links, const Input& in) {
  if constexpr (Links::Scene::template has<RuntimeGravity>)
    return read_gravity<typename Links::Scene, typename Links::Scalar>(in.gravity);
  else
    return -links.base_acceleration();
}

/// No motion, of any kind.
template <class Links>
AXIAL_INLINE constexpr ZeroVec3 no_motion(const Links&) {
  return {};
}
/// Angular velocity of frame 0, rad/s; zero by type unless the scene moves it.
template <class Links, class Input>
AXIAL_INLINE constexpr auto base_angular_velocity(const Links&, const Input& in) {
  if constexpr (base_moves<typename Links::Scene>)
    return in.base_motion.angular_velocity;
  else
    return ZeroVec3{};
}
/// Angular acceleration of frame 0, rad/s^2.
template <class Links, class Input>
AXIAL_INLINE constexpr auto base_angular_acceleration(const Links&, const Input& in) {
  if constexpr (base_moves<typename Links::Scene>)
    return in.base_motion.angular_acceleration;
  else
    return ZeroVec3{};
}
/// Acceleration of its origin against gravity, m/s^2. Underwater without gravity, which is a force there: added mass
/// has no weight.
template <class Links, class Input>
AXIAL_INLINE constexpr auto base_acceleration(const Links& links, const Input& in) {
  using Scene = typename Links::Scene;
  if constexpr (Scene::template has<Underwater> && base_moves<Scene>)
    return in.base_motion.linear_acceleration;
  else if constexpr (Scene::template has<Underwater>)
    return ZeroVec3{};
  else if constexpr (base_moves<Scene> && Scene::template has<RuntimeGravity>)
    return in.base_motion.linear_acceleration - in.gravity;
  else if constexpr (base_moves<Scene>)
    return in.base_motion.linear_acceleration + links.base_acceleration();
  else if constexpr (Scene::template has<RuntimeGravity>)
    return -read_gravity<typename Links::Scene, typename Links::Scalar>(in.gravity);
  else
    return links.base_acceleration();
}

}  // namespace axial

#include <axial/options/end.hpp>
