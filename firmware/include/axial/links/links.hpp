// The links of a robot as the algorithms walk over them, unrolled or looped.
#pragma once

#include <axial/links/plain_values.hpp>
#include <axial/links/table_link.hpp>

#include <axial/options/begin.hpp>

namespace axial {

// What kinematics alone asks of links: spatial/pose.hpp, recursion/tool_pose.hpp.
template <class T>
AXIAL_INLINE constexpr auto pose_of(const FixedPose& p);
namespace detail {
template <class Scalar, class Get>
AXIAL_INLINE constexpr auto constant_pose(Get get);
}

/// Which recursion walks over links: a number system with formats has others for each.
namespace recursion {
struct NewtonEuler {};              ///< inverse dynamics
struct MotionEfforts {};            ///< inverse dynamics where efforts are told from those that drive a motion
struct CompositeBodies {};          ///< the mass matrix
struct ArticulatedBodies {};        ///< the classical form
struct ArticulatedBodiesAtRest {};  ///< articulated bodies of the split form
struct Kinematics {};               ///< poses and Jacobians
struct Separation {};               ///< the separated terms
struct Momenta {};                  ///< joint momenta and their drift
struct BaseForce {};                ///< what carries the robot
struct Derivatives {};              ///< derivatives of inverse dynamics
}  // namespace recursion

/// Links without formats: results are kept as they come, joint values are as they are.
struct Unformatted {
  /// how link I rounds
  template <int>
  using Of = Plain;
  /// how joint values are read and written
  template <class Scene, class T>
  using Values = PlainValues<Scene, T>;
};

/// What unrolled links derive from: passes deduce the indices of all links, a pack, from an argument's type.
template <class Links, class Indices>
struct IndexedLinks {};

/// All links of a scene's robot, each with its own type. `Scalar` is the number, or what a number system computes by.
template <class SceneType, class ScalarType, class ParametersType, class FormatsType = Unformatted>
struct StaticLinks : FormatsType::template Values<SceneType, ScalarType>,
                     IndexedLinks<StaticLinks<SceneType, ScalarType, ParametersType, FormatsType>,
                                  std::make_integer_sequence<int, SceneType::Robot::chain.size>> {
  using Scene = SceneType;                ///< what the links belong to
  using Scalar = ScalarType;              ///< the number, or what a number system computes by
  using Parameters = ParametersType;      ///< fullParameters, or base parameters with or without rotors
  static constexpr bool unrolled = true;  ///< every link has its own type
  static constexpr int capacity = Scene::Robot::chain.size;  ///< number of links

  AXIAL_INLINE static constexpr int size() { return capacity; }  ///< number of links
  /// Link I as algorithms see it.
  template <int I>
  AXIAL_INLINE static constexpr auto link(Index<I>) {
    return StaticLink<Scene, I, Scalar, Parameters, typename FormatsType::template Of<I>>{};
  }
  /// index of the link that carries joint I, negative for the base
  template <int I>
  static constexpr int parent_of = Scene::Robot::chain.parent(I);
  /// index of the link that carries joint i, negative for the base
  AXIAL_INLINE static constexpr int parent_index(int i) { return Scene::Robot::chain.parent(i); }
  /// Acceleration of the base that stands for gravity, -g in frame 0.
  AXIAL_INLINE static constexpr auto base_acceleration() {
    if constexpr (Scene::template has<Gravity>) {
      return Vec3{literal<Scalar>([] { return -Scene::Robot::chain.gravity.x; }),
                  literal<Scalar>([] { return -Scene::Robot::chain.gravity.y; }),
                  literal<Scalar>([] { return -Scene::Robot::chain.gravity.z; })};
    } else {
      return ZeroVec3{};
    }
  }
  /// Pose of frame 0 in the world, and of the tool in the last link's frame.
  AXIAL_INLINE static constexpr auto base_pose() {
    return detail::constant_pose<Scalar>([] { return Scene::Robot::chain.base.pose; });
  }
  /// Pose of the tool in the last link's frame.
  AXIAL_INLINE static constexpr auto tool_pose() {
    return detail::constant_pose<Scalar>([] { return Scene::Robot::chain.tool.pose; });
  }
  AXIAL_INLINE static constexpr auto last() { return Index<capacity - 1>{}; }  ///< index of the last link
};

/// What a table of links stands on and carries: gravity, base and tool, as written by the robot's author.
struct Placement {
  GravityVector gravity{};  ///< m/s^2, axes of frame 0
  FixedPose base{};         ///< of frame 0 in the world
  FixedPose tool{};         ///< in the last link's frame
};

/// A table of links with one type for all; the table may be constexpr, or filled at run time.
template <class SceneType, class ScalarType, class Source, int Capacity,
          class Columns = detail::UnknownColumns<!SceneType::template has<Unbranched>>>
class TableLinks : public PlainValues<SceneType, ScalarType> {
 public:
  using Scene = SceneType;                                   ///< what the links belong to
  using Scalar = ScalarType;                                 ///< the number that kernels compute with
  using Dense = Scalar;                                      ///< what kernels keep
  static constexpr bool unrolled = false;                    ///< a loop walks over them
  static constexpr int capacity = Capacity;                  ///< number of links, at most
  using SharedColumns = Columns;                             ///< what all links have in common
  using Constants = typename Columns::template Row<Source>;  ///< row of the table

  /// `drives` may be null where the scene names neither Friction nor JointSprings.
  AXIAL_INLINE constexpr TableLinks(const Constants* table, const DriveConstants<Source>* drives, int size,
                                    const Placement& placement)
      : table_(table), drives_(drives), size_(size), placement_(placement) {}

  AXIAL_INLINE constexpr int size() const { return size_; }  ///< number of links
  /// Link i as algorithms see it.
  AXIAL_INLINE constexpr auto link(int i) const {
    return TableLink<Scene, Scalar, Source, Columns>(table_[i], drives_ == nullptr ? nullptr : drives_ + i,
                                                     i + 1 == size_);
  }
  /// index of the link that carries joint i, negative for the base
  AXIAL_INLINE constexpr int parent_index(int i) const { return table_[i].parent; }
  /// Acceleration of the base that stands for gravity, -g in frame 0.
  AXIAL_INLINE constexpr Vec3<Scalar> base_acceleration() const {
    using N = NumberTraits<Scalar>;
    const auto& g = placement_.gravity;
    if constexpr (Scene::template has<Gravity>)
      return {N::constant(-g.x), N::constant(-g.y), N::constant(-g.z)};
    else
      return ZeroVec3{};
  }
  /// Pose of frame 0 in the world.
  AXIAL_INLINE constexpr auto base_pose() const { return pose_of<Scalar>(placement_.base); }
  /// Pose of the tool in the last link's frame.
  AXIAL_INLINE constexpr auto tool_pose() const { return pose_of<Scalar>(placement_.tool); }
  AXIAL_INLINE constexpr int last() const { return size_ - 1; }  ///< index of the last link

 private:
  const Constants* table_;
  const DriveConstants<Source>* drives_;
  int size_;
  const Placement& placement_;
};

namespace detail {

template <class Robot, class Parameters>
using ColumnsOf = CommonConstants<RobotConstants<Robot, Parameters>>;
template <class Robot, class T, class Parameters, int... I>
AXIAL_INLINE constexpr auto converted_table(std::integer_sequence<int, I...>) {
  using Row = typename ColumnsOf<Robot, Parameters>::template Row<T>;
  struct Table {
    Row links[sizeof...(I)];
  };
  return Table{{converted_row<Row>(robot_constants<Robot, Parameters>.links[I])...}};
}
template <class Robot, class T, class Parameters>
inline constexpr auto robot_table =
    converted_table<Robot, T, Parameters>(std::make_integer_sequence<int, Robot::chain.size>{});
template <class Scene, class T>
AXIAL_INLINE constexpr const DriveConstants<T>* drives_of() {
  if constexpr (Scene::template has<Friction> || Scene::template has<JointSprings>)
    return robot_drives<typename Scene::Robot, T>.links;
  else
    return nullptr;
}
template <class Robot>
inline constexpr Placement robot_placement{Robot::chain.gravity, Robot::chain.base.pose, Robot::chain.tool.pose};

}  // namespace detail

/// What an algorithm computes with: its default, unless the scene names FullParameters or BaseParameters.
template <class Scene, class Default>
using parameters_of =
    std::conditional_t<Scene::template has<FullParameters>, FullParameters,
                       std::conditional_t<Scene::template has<BaseParameters>, BaseParameters, Default>>;

namespace detail {
template <class Scene, class Parameters>
using with_rotors =
    std::conditional_t<std::is_same_v<Parameters, BaseParameters> && Scene::template has<RotorInertia> &&
                           !Scene::template has<BaseMotion> && !Scene::template has<FloatingBase>,
                       BaseParametersAndRotors, Parameters>;

/// Whether unrolled links may have axial masses: rigid bodies to which neither a payload nor water adds.
template <class Scene, class Recursion>
inline constexpr bool knows_axial_masses = !Scene::template has<Payload> && !Scene::template has<Underwater> &&
                                           !std::is_same_v<Recursion, recursion::ArticulatedBodies> &&
                                           !std::is_same_v<Recursion, recursion::ArticulatedBodiesAtRest>;
// Whether no link declares a rotor: then a scene that leaves them out is the one that names them.
template <class Robot>
constexpr bool has_no_rotor() {
  bool none = true;
  for (const LinkParameters& link : Robot::chain.links)
    none = none && link.rotor_inertia == 0.0;
  return none;
}
/// Base parameters of a fixed base, with the rotors that the scene has.
template <class Scene, class Parameters>
inline constexpr bool regroups_all = std::is_same_v<Parameters, BaseParametersAndRotors> ||
                                     (std::is_same_v<Parameters, BaseParameters> &&
                                      has_no_rotor<typename Scene::Robot>() && !Scene::template has<BaseMotion> &&
                                      !Scene::template has<FloatingBase>);
template <class Robot>
inline constexpr bool shares_drives_in = false;
template <class R>
inline constexpr bool shares_drives_in<DriveCoordinates<R>> = true;
template <class Scene, class Parameters, class Recursion>
using with_axial_masses = std::conditional_t<regroups_all<Scene, Parameters> && knows_axial_masses<Scene, Recursion>,
                                             BaseParametersAndAxialMasses, Parameters>;
}  // namespace detail

/// Stands for links that a number system has refused: kernels answer anything, so that nothing more is said.
template <class SceneType>
struct RefusedLinks {
  using Scene = SceneType;  ///< what was refused
  /// Any answer.
  template <class Any>
  constexpr operator Any() const {
    return {};
  }
};
template <class Links>
inline constexpr bool is_refused = false;  ///< whether links are such ones
template <class Scene>
inline constexpr bool is_refused<RefusedLinks<Scene>> = true;  ///< they are

/// How an algorithm runs over links: by itself, not at all where they are refused; what couples joints specialises it.
template <class Algorithm, class Links, class = void>
struct Execution : Algorithm {};
/// Over links that are refused: nothing.
template <class Algorithm, class Links>
struct Execution<Algorithm, Links, std::enable_if_t<is_refused<Links>>> {
  /// what was refused
  template <class... Arguments>
  AXIAL_INLINE static constexpr const Links& run(const Links& links, const Arguments&...) {
    return links;
  }
};
/// Specialised to stop the compiler at links over which no recursion walks.
template <class Links, class = void>
struct Walkable {};
/// Runs an algorithm over links; joint values as callers have them.
template <class Algorithm, class Links, class... Arguments>
AXIAL_INLINE constexpr decltype(auto) execute(const Links& links, Arguments&&... arguments) {
  return Execution<Algorithm, Links>::run(links, arguments...);
}
namespace detail {
/// What a number system refuses of a recursion over a scene. Calls say it first, before links do; at once, for a
/// function whose result is deduced is looked into where it is called.
template <class Scene, class Number>
struct Forms {
  template <class Recursion>
  static constexpr auto check() {}
};
}  // namespace detail

/// What a recursion walks over for a scene and numbers T; a number system with formats specialises it.
template <class Scene, class Number, class Parameters, class Recursion>
struct LinksOf {
  using T = typename detail::Substitute<Number>::type;  ///< the number
  using Robot = typename Scene::Robot;                  ///< of the scene

  static_assert(!detail::shares_drives_in<Robot>,
                "axial: joints of this robot share drives: add #include <axial/transmissions/shared_drives.hpp>");
  /// the links, in the form that the scene asks for
  AXIAL_INLINE static constexpr auto links() {
    if constexpr (Scene::template has<Looped>) {
      using Columns = detail::ColumnsOf<Robot, Parameters>;
      using Source = Lane<T>;
      return TableLinks<Scene, T, Source, Robot::chain.size, Columns>(
          detail::robot_table<Robot, Source, Parameters>.links, detail::drives_of<Scene, Source>(), Robot::chain.size,
          detail::robot_placement<Robot>);
    } else {
      return StaticLinks<Scene, T, detail::with_axial_masses<Scene, Parameters, Recursion>>{};
    }
  }
};

/// The links of a scene (or of a bare robot) over numbers T, with the parameters that the scene asks for.
template <class S, class T, class DefaultParameters = FullParameters, class Recursion = recursion::NewtonEuler>
AXIAL_INLINE constexpr auto links_of() {
  using Scene = scene_of<S>;
  using Parameters = detail::with_rotors<Scene, parameters_of<Scene, DefaultParameters>>;
  return LinksOf<Scene, T, Parameters, Recursion>::links();
}

}  // namespace axial

#include <axial/options/end.hpp>
