// A scene without what belongs to drives: rotors, friction, what they share.
#pragma once

#include <axial/scene/scene.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// Of `Kept`, a scene, and what is added to it of features: those that are not the drives'.
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

}  // namespace axial::detail

#include <axial/options/end.hpp>
