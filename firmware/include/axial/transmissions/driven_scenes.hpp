// Scenes of a robot whose joints share drives: that of its joints, and that of its clusters.
#pragma once

#include <axial/robot/drive_coordinates.hpp>
#include <axial/scene/scene.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

template <class R>
struct LinksOwner<DriveCoordinates<R>> {
  using type = JointCoordinates<R>;
};

template <class Kept, class... Features>
struct WithoutDrives {
  using type = Kept;
};
template <class R, class... Kept, class First, class... Rest>
struct WithoutDrives<Scene<R, Kept...>, First, Rest...> {
  static constexpr bool of_drives = std::is_same_v<First, RotorInertia> || std::is_same_v<First, Friction> ||
                                    std::is_same_v<First, RotorDynamics> || std::is_same_v<First, SharedDrives>;
  using type =
      typename WithoutDrives<std::conditional_t<of_drives, Scene<R, Kept...>, Scene<R, Kept..., First>>, Rest...>::type;
};

/// The scene of a robot's joints: what belongs to drives is left to them.
template <class Scene>
struct SceneOfJoints;
template <class R, class... Features>
struct SceneOfJoints<Scene<DriveCoordinates<R>, Features...>> {
  using type = typename WithoutDrives<Scene<JointCoordinates<R>>, Features...>::type;
};

/// The scene of a robot's clusters: that of its joints with the rotors that are a joint's alone.
template <class Scene>
struct SceneOfClusters;
template <class R, class... Features>
struct SceneOfClusters<Scene<DriveCoordinates<R>, Features...>> {
  using Robot = R;  ///< whose joints share drives
  using type = std::conditional_t<Scene<DriveCoordinates<R>, Features...>::template has<RotorInertia>,
                                  typename WithoutDrives<Scene<ClusterCoordinates<R>, RotorInertia>, Features...>::type,
                                  typename WithoutDrives<Scene<ClusterCoordinates<R>>, Features...>::type>;
};

template <class R, class... Features>
constexpr const auto& drive_matrix_of_scene(const Scene<DriveCoordinates<R>, Features...>*) {
  return drive_matrix<R>;
}

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
