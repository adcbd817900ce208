// A scene: a robot and the features that its user needs.
#pragma once

#include <axial/robot/chain_parameters.hpp>
#include <axial/scene/absent_inputs.hpp>
#include <axial/scene/features.hpp>

#include <axial/options/begin.hpp>

namespace axial {

template <class R>
struct DriveCoordinates;  // robot/drive_coordinates.hpp
template <class RobotType, class... Features>
struct Scene;

namespace detail {
/// Whether a robot's type says all about it; a run-time model's does not, whose number of joints is a capacity.
template <class R, class = void>
inline constexpr bool is_described = false;
template <class R>
inline constexpr bool is_described<R, std::void_t<decltype(R::chain.links)>> = true;
/// Whether a type is described by a chain, or such a model; whether a robot, or that of a scene, is.
template <class R, class = void>
inline constexpr bool is_robot = false;
template <class R>
inline constexpr bool is_robot<R, std::void_t<decltype(R::chain.size)>> = true;
template <class S>
inline constexpr bool names_robot = is_robot<S>;
template <class R, class... F>
inline constexpr bool names_robot<Scene<R, F...>> = is_robot<R>;
/// What is computed with instead, so that nothing more is said.
struct NoRobot {
  static constexpr Chain<1> chain{};
};
}  // namespace detail
/// What is said of a type that is no robot (a macro: static_assert takes a literal only).
#define AXIAL_A_ROBOT_IS                                                                                           \
  "axial: a robot is a struct with static constexpr auto chain = axial::chain(...), and a scene is axial::Scene< " \
  "of a robot and what it names>; give one of these"

namespace naming {  // of its own: a base's namespace is looked into for every call with a scene's links
/// What features say together, whatever the robot.
template <class... Features>
struct Named {
  /// How often the features have a tag.
  template <class Tag>
  static constexpr int times_named = (0 + ... + static_cast<int>(std::is_same_v<Tag, Features>));
  /// Whether the scene names a feature.
  template <class Tag>
  static constexpr bool has = times_named<Tag> > 0;

  // What a Scene refuses; kernels then compute with the bare robot, so that nothing more is said.
  static constexpr bool lists_no_feature =
      (false || ... || !std::is_base_of_v<Feature<Features>, Features>);                  ///< a type that is none
  static constexpr bool repeats = (false || ... || (times_named<Features> > 1));          ///< a feature twice
  static constexpr bool has_two_gravities = has<Gravity> && has<RuntimeGravity>;          ///< declared and given
  static constexpr bool has_two_parameters = has<FullParameters> && has<BaseParameters>;  ///< of the links
  static constexpr bool has_two_bases = has<FloatingBase> && has<BaseMotion>;             ///< free and told
  static constexpr bool turns_gravity = has<FloatingBase> && has<Gravity>;       ///< declared in a frame that turns
  static constexpr bool pushes_no_base = has<BaseWrench> && !has<FloatingBase>;  ///< a wrench on a base at rest
  static constexpr bool flows_in_air = has<VelocityThroughWater> && !has<Underwater>;  ///< a flow without water
  static constexpr bool moves = has<FloatingBase> || has<BaseMotion>;                  ///< its base
  static constexpr bool by_composite_bodies =
      has<CompositeBody> || has<RotorDynamics> || has<SharedDrives>;  ///< a run-time model's forward dynamics
  static constexpr bool swims_unseen =
      has<Underwater> && moves && !has<VelocityThroughWater>;  ///< water without a flow
  static constexpr bool floats_otherwise =
      has<FloatingBase> && (has<SplitArticulatedBody> || has<CompositeBody>);         ///< than by one form
  static constexpr bool couples_no_rotor = has<RotorDynamics> && !has<RotorInertia>;  ///< rotors that are none
  static constexpr bool couples_otherwise =
      has<RotorDynamics> && (has<FloatingBase> || has<ArticulatedBody> || has<SplitArticulatedBody>);  ///< likewise
  static constexpr bool has_two_forms =
      times_named<ArticulatedBody> + times_named<SplitArticulatedBody> + times_named<CompositeBody> >
      1;  ///< of a solve
  /// any of these
  static constexpr bool is_refused = lists_no_feature || repeats || has_two_gravities || has_two_parameters ||
                                     has_two_bases || turns_gravity || pushes_no_base || flows_in_air || swims_unseen ||
                                     floats_otherwise || couples_no_rotor || couples_otherwise || has_two_forms;
  /// Says so, once. No members of a class, which Clang would then take for none.
  static constexpr auto check() {
    static_assert(!lists_no_feature,
                  "axial: a Scene lists its robot first and then features only (axial::Gravity, axial::Friction, ...; "
                  "scene/features.hpp has them all); take out the type that is none");
    static_assert(!repeats, "axial: a Scene names a feature twice; name each feature once");
    static_assert(
        !has_two_gravities,
        "axial: a Scene names both Gravity and RuntimeGravity; keep Gravity for the robot's declared vector, or "
        "RuntimeGravity for the input in.gravity");
    static_assert(!has_two_parameters,
                  "axial: a Scene names both FullParameters and BaseParameters; keep one, or none for each algorithm's "
                  "default");
    static_assert(
        !has_two_bases,
        "axial: a Scene names both FloatingBase and BaseMotion; keep FloatingBase for a base that is free, or "
        "BaseMotion for one that moves as it is told");
    static_assert(!turns_gravity,
                  "axial: a Scene names Gravity for a floating base, in whose frame gravity turns; name RuntimeGravity "
                  "and give in.gravity in axes of frame 0, or neither in free space");
    static_assert(
        !pushes_no_base,
        "axial: a Scene names BaseWrench for a base that is not free; add FloatingBase or take BaseWrench out");
    static_assert(!flows_in_air, "axial: a Scene names VelocityThroughWater but no water; add Underwater");
    static_assert(!swims_unseen,
                  "axial: an underwater base that moves goes through the water; add VelocityThroughWater and give "
                  "in.velocity_through_water in axes of frame 0");
    static_assert(!floats_otherwise,
                  "axial: forward dynamics of a floating base is that of ArticulatedBody; take SplitArticulatedBody or "
                  "CompositeBody out");
    static_assert(
        !couples_no_rotor,
        "axial: a Scene names RotorDynamics, the coupling of rotors to their carriers, without what they are on "
        "their own joints; add RotorInertia");
    static_assert(
        !couples_otherwise,
        "axial: forward dynamics with RotorDynamics is that of CompositeBody on a base that does not float; take "
        "FloatingBase, ArticulatedBody and SplitArticulatedBody out");
    static_assert(!has_two_forms,
                  "axial: a Scene names more than one form of forward dynamics; keep one of ArticulatedBody, "
                  "SplitArticulatedBody and CompositeBody, or none to let the compiler choose");
  }
};
}  // namespace naming

/// Robot with exactly the named features (features.hpp; doc/guides/scenes.md is the table of them).
template <class RobotType, class... Features>
struct Scene : naming::Named<Features...> {
  using Robot = RobotType;  ///< the robot alone
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
  using Named = std::conditional_t<is_robot<R>, R, StandIn<NoRobot>>;  ///< the one that a user named
  /// the robot that kernels compute with
  using type = std::conditional_t<decltype(shares_drives<R>(0))::value, DriveCoordinates<R>, Named>;
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
  using Given = type;  ///< whose run-time inputs there are
  using Names = naming::Named<>;
};
/// Of features that are refused every input is there, so that nothing is said of those.
template <class Robot, class... Features>
struct SceneOf<Scene<Robot, Features...>> {
  using Of = typename Computed<Robot>::type;
  using AsNamed = Scene<Of, Features...>;
  using Names = naming::Named<Features...>;
  static constexpr bool refused = Names::is_refused;
  using type = std::conditional_t<refused, Scene<Of, Gravity, RotorInertia>, AsNamed>;
  using Given = std::conditional_t<refused,
                                   Scene<Of, RuntimeGravity, FloatingBase, BaseWrench, Underwater, VelocityThroughWater,
                                         TipWrench, ExternalWrenches, Payload, SineCosines>,
                                   AsNamed>;
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
inline constexpr int joint_count = (detail::SceneOf<S>::Names::check(), scene_of<S>::Robot::chain.size);
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
struct Offered {
  static constexpr bool leaves_room = true;  // for the payload
};
}  // namespace detail

namespace detail {
/// Whether the robot of a scene under gravity declares which way it pulls; a run-time model's is given.
template <class S, class R = robot_of<S>>
constexpr bool says_gravity() {
  if constexpr (scene_of<S>::template has<Gravity> && is_described<R> && !decltype(is_malformed<R>(0))::value)
    return R::chain.says_gravity;
  else
    return true;
}
}  // namespace detail
/// What is said of what holds an arm where it does not (a macro: static_assert takes a literal only).
#define AXIAL_GRAVITY_IS                                                                                               \
  "axial: the chain does not say which way gravity pulls; add axial::gravity(x, y, z), m/s^2 in axes of frame 0: (0, " \
  "0, -9.81) where z points up"

/// Run-time inputs of a scene: one member for each named feature that has one (`payload`, `tip_wrench`, ...). Touching
/// the input of a feature that the scene does not name does not compile; the message says which to add.
template <class S, class T>
struct Inputs : detail::Offered<scene_of<S>, T>,
                detail::InputsOf<typename detail::SceneOf<S>::Given, T>,
                AbsentInputs<typename detail::SceneOf<S>::Given> {
  static_assert((detail::SceneOf<S>::Names::check(), true));
  static_assert(detail::names_robot<S>, AXIAL_A_ROBOT_IS);
  static_assert(detail::Offered<scene_of<S>, T>::leaves_room,
                "axial: fixed point leaves room for the declared payload; add axial::payload_limit(mass, com_reach, "
                "inertia) to the robot's chain");
};

/// What a call that is given no inputs takes: those of a scene that names none. There is no default for the others, for
/// an arm would sag under a payload that a call does not know of.
template <class S, class T>
[[nodiscard]] constexpr Inputs<S, T> no_inputs() {
  constexpr bool none = std::is_empty_v<detail::InputsOf<scene_of<S>, T>>;
  static_assert(none, "axial: the scene names run-time inputs (in.payload, ...); give this call its Inputs<Scene, T>");
  return {};
}

}  // namespace axial

#include <axial/options/end.hpp>
