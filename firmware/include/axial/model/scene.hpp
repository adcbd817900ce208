// A scene: a robot and the features that its user needs.
#pragma once

#include <axial/model/chain.hpp>
#include <axial/model/features.hpp>

namespace axial {

/// Robot with exactly the named features: Gravity, RotorInertia, Friction, TipWrench, Payload, Looped, BaseParameters,
/// FullParameters.
template <class RobotType, class... Features>
struct Scene {
  using Robot = RobotType;
  template <class Feature>
  static constexpr bool has = (false || ... || std::is_same_v<Feature, Features>);
};

template <class T>
struct IsScene : std::false_type {};
template <class Robot, class... Features>
struct IsScene<Scene<Robot, Features...>> : std::true_type {};

namespace detail {
template <class S, bool scene = IsScene<S>::value>
struct SceneOf {
  using type = Scene<S, Gravity, RotorInertia>;
};
template <class S>
struct SceneOf<S, true> {
  using type = S;
};
}  // namespace detail

/// A bare robot stands for its scene with gravity and the rotor inertia that it declares, without friction.
template <class S>
using scene_of = typename detail::SceneOf<S>::type;
template <class S>
using robot_of = typename scene_of<S>::Robot;

/// Number of joints of a robot or a scene; for a run-time Model<N>, its capacity.
template <class S>
inline constexpr int joint_count = robot_of<S>::chain.size;

namespace detail {
template <class S, class T>
struct InputsOf;
template <class Robot, class... Features, class T>
struct InputsOf<Scene<Robot, Features...>, T> : Features::template Input<T>... {};
}  // namespace detail

/// Run-time inputs of a scene: one member for each named feature that has one (`payload`, `tip_wrench`), none for the
/// rest: touching the input of a feature that the scene does not name does not compile.
template <class S, class T>
struct Inputs : detail::InputsOf<scene_of<S>, T> {};

}  // namespace axial
