// A scene: a robot and the features that its user needs.
#pragma once

#include <axial/robot/chain_parameters.hpp>
#include <axial/scene/absent_inputs.hpp>
#include <axial/scene/features.hpp>

#include <axial/options/begin.hpp>

namespace axial {

template <class R>
struct DriveCoordinates;  // robot/drive_coordinates.hpp

/// Robot with exactly the named features (features.hpp; doc/guides/scenes.md is the table of them).
template <class RobotType, class... Features>
struct Scene {
  using Robot = RobotType;  ///< the robot alone
  /// How often the features have a tag.
  template <class Tag>
  static constexpr int times_named = (0 + ... + static_cast<int>(std::is_same_v<Tag, Features>));
  /// Whether the scene names a feature.
  template <class Tag>
  static constexpr bool has = times_named<Tag> > 0;

  static_assert((true && ... && std::is_base_of_v<Feature<Features>, Features>),
                "axial: a Scene lists its robot first and then features only (axial::Gravity, axial::Friction, ...; "
                "scene/features.hpp has them all); take out the type that is none");
  static_assert((true && ... && (times_named<Features> == 1)),
                "axial: a Scene names a feature twice; name each feature once");
  static_assert(
      !(has<Gravity> && has<RuntimeGravity>),
      "axial: a Scene names both Gravity and RuntimeGravity; keep Gravity for the robot's declared vector, or "
      "RuntimeGravity for the input in.gravity");
  static_assert(!(has<FullParameters> && has<BaseParameters>),
                "axial: a Scene names both FullParameters and BaseParameters; keep one, or none for each algorithm's "
                "default");
  static_assert(!(has<FloatingBase> && has<BaseMotion>),
                "axial: a Scene names both FloatingBase and BaseMotion; keep FloatingBase for a base that is free, or "
                "BaseMotion for one that moves as it is told");
  static_assert(!(has<FloatingBase> && has<Gravity>),
                "axial: a Scene names Gravity for a floating base, in whose frame gravity turns; name RuntimeGravity "
                "and give in.gravity in axes of frame 0, or neither in free space");
  static_assert(!has<BaseWrench> || has<FloatingBase>,
                "axial: a Scene names BaseWrench for a base that is not free; add FloatingBase or take BaseWrench out");
  static_assert(!has<VelocityThroughWater> || has<Underwater>,
                "axial: a Scene names VelocityThroughWater but no water; add Underwater");
  static_assert(!(has<Underwater> && (has<FloatingBase> || has<BaseMotion>)) || has<VelocityThroughWater>,
                "axial: an underwater base that moves goes through the water; add VelocityThroughWater and give "
                "in.velocity_through_water in axes of frame 0");
  static_assert(!(has<FloatingBase> && (has<SplitArticulatedBody> || has<CompositeBody>)),
                "axial: forward dynamics of a floating base is that of ArticulatedBody; take SplitArticulatedBody or "
                "CompositeBody out");
  static_assert(
      !has<RotorDynamics> || has<RotorInertia>,
      "axial: a Scene names RotorDynamics, the coupling of rotors to their carriers, without what they are on "
      "their own joints; add RotorInertia");
  static_assert(
      !(has<RotorDynamics> && (has<FloatingBase> || has<ArticulatedBody> || has<SplitArticulatedBody>)),
      "axial: forward dynamics with RotorDynamics is that of CompositeBody on a base that does not float; take "
      "FloatingBase, ArticulatedBody and SplitArticulatedBody out");
  static_assert(times_named<ArticulatedBody> + times_named<SplitArticulatedBody> + times_named<CompositeBody> <= 1,
                "axial: a Scene names more than one form of forward dynamics; keep one of ArticulatedBody, "
                "SplitArticulatedBody and CompositeBody, or none to let the compiler choose");
};

namespace detail {
/// Whether chain() has stopped the compiler, with a message of its own: there are links, and they are no constant.
template <class R, bool = (R::chain.links[0].mass < 0.0 || true)>
std::false_type is_malformed(int);
template <class R>
auto is_malformed(long) -> decltype(R::chain.links[0].mass, std::true_type());
template <class R>
std::false_type is_malformed(...);

/// Whether joints of a robot share drives; its values are then those of the drives.
template <class R>
auto shares_drives(int) -> std::bool_constant<R::chain.shares_drives()>;
template <class R>
std::false_type shares_drives(...);

/// What kernels then compute with, so that nothing more is said: robot/chain.hpp.
template <class R>
struct StandIn;
template <class R, bool malformed = decltype(is_malformed<R>(0))::value>
struct Computed {
  /// the robot that kernels compute with
  using type = std::conditional_t<decltype(shares_drives<R>(0))::value, DriveCoordinates<R>, R>;
  using Named = R;  ///< the one that a user named
};
template <class R>
struct Computed<DriveCoordinates<R>, false> {
  using type = DriveCoordinates<R>;
  using Named = R;
};
template <class R>
struct Computed<R, true> : Computed<StandIn<R>, false> {};
template <class R>
struct Computed<StandIn<R>, false> {
  using type = StandIn<R>;
  using Named = R;
};
template <class S>
struct SceneOf {
  using type = Scene<typename Computed<S>::type, Gravity, RotorInertia>;
};
template <class Robot, class... Features>
struct SceneOf<Scene<Robot, Features...>> {
  using type = Scene<typename Computed<Robot>::type, Features...>;
};
}  // namespace detail

/// A bare robot stands for its scene with gravity and the rotor inertia that it declares, without friction.
template <class S>
using scene_of = typename detail::SceneOf<S>::type;
/// The robot of a scene, or the robot itself.
template <class S>
using robot_of = typename detail::Computed<typename scene_of<S>::Robot>::Named;

namespace detail {
/// The robot whose description formats and limits follow from: the one that a user named, or what stands for it.
template <class S, class R = robot_of<S>>
using described_by = std::conditional_t<decltype(is_malformed<R>(0))::value, StandIn<R>, R>;
}  // namespace detail

/// Number of joint values of a robot or a scene: one per joint, or one per drive where joints share drives; for a
/// run-time Model<N>, its capacity.
template <class S>
inline constexpr int joint_count = scene_of<S>::Robot::chain.size;
/// Number of links.
template <class S>
inline constexpr int link_count = robot_of<S>::chain.size;

namespace detail {
template <class S, class T>
struct InputsOf;
template <class Robot, class... Features, class T>
struct InputsOf<Scene<Robot, Features...>, T> : Features::template Input<Robot, T>... {};
/// What a number system has to say against a scene, before anything of it is computed: see
/// fixed/formats/input_formats.hpp.
template <class Scene, class T>
struct Offered {};
}  // namespace detail

/// Run-time inputs of a scene: one member for each named feature that has one (`payload`, `tip_wrench`, ...). Touching
/// the input of a feature that the scene does not name does not compile; the message says which to add.
template <class S, class T>
struct Inputs : detail::Offered<scene_of<S>, T>, detail::InputsOf<scene_of<S>, T>, AbsentInputs<scene_of<S>> {};

}  // namespace axial

#include <axial/options/end.hpp>
