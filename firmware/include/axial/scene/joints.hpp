// One value per joint.
#pragma once

#include <axial/scene/scene.hpp>

#include <axial/options/begin.hpp>

/// What is said of another count (a macro: static_assert takes a literal only).
#define AXIAL_ONE_FOR_EACH "axial: joint values hold one number for each joint, or none: {}"

namespace axial {

namespace detail {

template <std::size_t, class T>
using Repeated = T;

}  // namespace detail

/// N values, given as so many, or none, or, of a capacity, as fewer. Not in detail: calls on joint values would look
/// there.
template <class T, bool is_capacity, class Each>
struct JointValues;
/// N values, or at most N of a capacity.
template <class T, bool is_capacity, std::size_t... I>
struct JointValues<T, is_capacity, std::index_sequence<I...>> {
  static constexpr std::size_t joints = sizeof...(I);  ///< N
  /// Whether so many are taken.
  static constexpr bool takes(std::size_t numbers) { return numbers == joints || (is_capacity && numbers < joints); }
  T values[joints] = {};  ///< from the base outwards; zero unless initialised

  AXIAL_INLINE constexpr JointValues() : values{} {}  ///< zeros, once
  /// A value for each joint, in braces or as an array, of which a capacity takes fewer.
  ///@{
  AXIAL_INLINE constexpr JointValues(const detail::Repeated<I, T>&... given) : values{given...} {}
  template <std::size_t numbers>
  AXIAL_INLINE constexpr JointValues(const T (&given)[numbers]) : values{I < numbers ? given[I] : T{}...} {
    static_assert(takes(numbers), AXIAL_ONE_FOR_EACH);
  }
  template <class... V, std::enable_if_t<takes(sizeof...(V)) && (sizeof...(V) < joints) &&
                                             (true && ... && std::is_convertible_v<V, T>),
                                         int> = 0>
  constexpr JointValues(const V&... given) : values{static_cast<T>(given)...} {}
  ///@}
  /// Refused. Not constexpr: a compiler would show its way to it before the sentence.
  template <class... V, class = std::enable_if_t<!takes(sizeof...(V)) && (true && ... && std::is_convertible_v<V, T>)>>
  JointValues(const V&...) {
    static_assert(takes(sizeof...(V)), AXIAL_ONE_FOR_EACH);
  }
};

namespace detail {
template <class S, class T>
using ValuesOf = JointValues<T, !is_described<typename scene_of<S>::Robot>, std::make_index_sequence<joint_count<S>>>;

}  // namespace detail

/// N values, one per joint, from the base outwards: `Joints<Robot, float> q{0.1F, 0.2F}`, or `q{}` for zeros.
/// `Role` is void where the numbers carry their own scale; fixed point has one type a role
/// (fixed/formats/joint_formats.hpp).
template <class S, class T, class Role>
struct Joints : detail::ValuesOf<S, T> {
  static_assert(detail::names_robot<S>, AXIAL_A_ROBOT_IS);
  static constexpr int size = joint_count<S>;  ///< number of joints
  using Base = detail::ValuesOf<S, T>;         ///< the values
  using Base::Base;                            ///< so many values
  AXIAL_INLINE constexpr Joints() : Base() {}  ///< or none

  AXIAL_INLINE constexpr T& operator[](int i) { return this->values[i]; }  ///< value of joint i; not checked
  AXIAL_INLINE constexpr const T& operator[](int i) const {
    return this->values[i];
  }  ///< value of joint i; not checked
};

/// Words without what computes with them: double, so that no second message follows.
template <class S, class Word>
struct Joints<S, Stored<Word>, void> {
  static_assert(detail::names_robot<S>, AXIAL_A_ROBOT_IS);
  static_assert(sizeof(Word) == 0 || !detail::names_robot<S>,
                "axial: fixed point is a plug-in: add #include <axial/fixed.hpp>");
  static constexpr int size = joint_count<S>;                                         ///< number of joints
  double values[size];                                                                ///< from the base outwards
  AXIAL_INLINE constexpr double& operator[](int i) { return values[i]; }              ///< value of joint i
  AXIAL_INLINE constexpr const double& operator[](int i) const { return values[i]; }  ///< value of joint i
};

/// What the values of joints can be.
namespace role {
struct Position {};          ///< rad or m
struct Velocity {};          ///< rad/s or m/s
struct Acceleration {};      ///< rad/s^2 or m/s^2
struct Effort {};            ///< N m or N
struct MotionEffort {};      ///< what a motion inside the limits needs, whatever efforts are declared: N m or N
struct FreeAcceleration {};  ///< what forward dynamics answers: bounded by efforts, not by a request's limits
struct Momentum {};          ///< N m s or N s
struct MomentumRate {};      ///< N m or N
struct WrenchEffort {};      ///< of a wrench at the tool: N m or N
/// Products of values of two roles, one per joint.
template <class A, class B>
struct Product {};
using Power = Product<Effort, Velocity>;  ///< W
struct None {};                           ///< of whole numbers, which are no joint values: no call takes them
}  // namespace role

namespace detail {
template <class T, class Role>
struct RoleOf {
  using type = void;
};
/// That role; of what is no robot one type for all, so that its sentence is said once.
template <class S, class T, class Role>
using role_of = std::conditional_t<std::is_integral_v<T>, role::None,
                                   std::conditional_t<names_robot<S>, typename RoleOf<T, Role>::type, void>>;
/// Whose joint values over numbers T are: the robot's; the scene's where formats follow from what it names.
template <class S, class T>
struct SubjectOf {
  using type = robot_of<S>;
};
}  // namespace detail

/// Roles: rad or m; rad/s or m/s; rad/s^2 or m/s^2; N m or N. One type in floating point.
template <class S, class T>
using Positions = Joints<S, T, detail::role_of<S, T, role::Position>>;
/// Joint values of that role.
///@{
template <class S, class T>
using Velocities = Joints<S, T, detail::role_of<S, T, role::Velocity>>;
template <class S, class T>
using Accelerations = Joints<S, T, detail::role_of<S, T, role::Acceleration>>;
template <class S, class T>
using Efforts = Joints<S, T, detail::role_of<S, T, role::Effort>>;
///@}
/// Whom results over numbers T belong to: the robot, unless their formats follow from what the scene puts on it.
template <class S, class T>
using subject_of = std::conditional_t<detail::names_robot<S>, typename detail::SubjectOf<S, T>::type, robot_of<S>>;
/// Efforts of a scene.
template <class S, class T>
using EffortsOf = Efforts<subject_of<S, T>, T>;
/// What forward dynamics answers: rad/s^2 or m/s^2.
template <class S, class T>
using FreeAccelerations = Joints<S, T, typename detail::RoleOf<T, role::FreeAcceleration>::type>;

/// Joint values that are zero by type: a query that leaves them out does not pay for them.
struct NoMotion {
  AXIAL_INLINE constexpr Zero operator[](int) const { return {}; }  ///< zero, for every joint
};

/// Roles of an algorithm's arguments behind links and run-time inputs: role::None of what is no joint values.
template <class... Role>
struct Roles {};
/// A role: columns of a Jacobian, twists by rates.
struct TwistByRate {};

/// The links as a tree of joints, for execute(): there are specialisations where joint values are not theirs.
struct JointLinks {
  /// the links themselves
  template <class Links>
  AXIAL_INLINE static constexpr const Links& run(const Links& links) {
    return links;
  }
};
/// The links to which joint values belong, with rotor and friction of each.
struct Actuators : JointLinks {};

}  // namespace axial

#include <axial/options/end.hpp>
