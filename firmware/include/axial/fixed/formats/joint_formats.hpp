// Joint values in fixed point: integers, and the exponents that the robot's declared limits give them.
#pragma once

#include <axial/fixed/bounds/dynamics.hpp>
#include <axial/fixed/ranges/forward_error.hpp>
#include <axial/scene/joints.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {

template <class Word, class Role>
struct RoleOf<Stored<Word>, Role> {
  using type = Role;
};
template <class S, class Word>
struct SubjectOf<S, Stored<Word>> {
  using type = S;
};

/// The first joint whose limit is not there, -1 for none.
template <class Robot>
constexpr int first_joint_without(bool (*limit)(const LinkParameters&)) {
  if constexpr (is_described<Robot>)
    for (int i = 0; i < Robot::chain.size; ++i)
      if (!limit(Robot::chain.links[i])) return i;
  return -1;
}
constexpr bool is_slow(const LinkParameters& p) { return is_bounded(p.speed_limit); }
constexpr bool is_gentle(const LinkParameters& p) { return is_bounded(p.acceleration_limit); }
constexpr bool ends(const LinkParameters& p) {
  return p.type == JointType::revolute || (is_bounded(p.position_max) && is_bounded(-p.position_min));
}
/// Names the joint in what a compiler says, counted from 0.
template <int Joint>
inline constexpr bool joint_is_limited = Joint < 0;

/// What formats follow from, said where positions are declared, once: of other roles nothing.
template <class S, class Role>
struct LimitedJoints {
  template <class Robot = typename scene_of<S>::Robot>
  static constexpr int without(bool (*limit)(const LinkParameters&)) {
    return std::is_same_v<Role, role::Position> ? first_joint_without<Robot>(limit) : -1;
  }
  static constexpr int speed = without(is_slow), acceleration = speed < 0 ? without(is_gentle) : -1;
  static constexpr int position = speed < 0 && acceleration < 0 ? without(ends) : -1;
};
template <class S, class Word>
constexpr void check_limits() {
  static_cast<void>(sizeof(Positions<robot_of<S>, Stored<Word>>));
}

/// What joint values are rounded to, whatever the scene's arithmetic.
template <class Word>
inline constexpr WordRounding joint_rounding{8 * static_cast<int>(sizeof(Word)), true, false, 0.0};

/// Ranges of a scene's inverse dynamics on full parameters: the formats of efforts follow from them.
template <class S, class Word>
inline constexpr auto motion_ranges_of = newton_euler_ranges(mechanism_of<scene_of<S>, FullParameters>,
                                                             joint_rounding<Word>, Wanted::formats);

/// Ranges of a scene's momenta; what drives its joints; ranges of the accelerations that efforts give; how far efforts
/// can drive beyond the ranges of inverse dynamics.
///@{
template <class S, class Word>
inline constexpr auto momentum_ranges_of = momentum_ranges(mechanism_of<scene_of<S>, FullParameters>,
                                                           joint_rounding<Word>, Wanted::formats);
template <class S, class Word>
inline constexpr auto usual_drive_of = usual_drive(mechanism_of<scene_of<S>, FullParameters>, joint_rounding<Word>,
                                                   motion_ranges_of<S, Word>);
template <class S, class Word>
inline constexpr auto free_ranges_of = articulated_at_rest_sizes(mechanism_of<scene_of<S>, FullParameters>,
                                                                 joint_rounding<Word>, usual_drive_of<S, Word>);
template <class S, class Word>
inline constexpr double excess_of = excess_of_drive(mechanism_of<scene_of<S>, FullParameters>,
                                                    motion_ranges_of<S, Word>, usual_drive_of<S, Word>);
///@}

/// Effort, momentum and its rate at joints that share no drives, at most.
template <class S, class Word>
struct MotionSizes {
  static constexpr double effort(int i) { return motion_ranges_of<S, Word>.range[i].joint_effort.size; }
  static constexpr double momentum(int i) { return momentum_ranges_of<S, Word>.range[i].joint_effort.size; }
  static constexpr double momentum_rate(int i) { return momentum_ranges_of<S, Word>.slope[i].size + effort(i); }
};
/// Sizes of what drives of joints that share them answer: drive_formats.hpp.
template <class S, class Word>
struct DriveSizes;

/// Exponents of joint i's values by their role. A role asks for no more of the analyses than it needs.
template <class S, class Word>
struct RoleExponent {
  static constexpr bool shared = shares_drives_in<typename scene_of<S>::Robot>;
  static constexpr const LinkParameters& link(int i) { return described_chain<typename scene_of<S>::Robot>.links[i]; }
  // What has no limit was refused.
  static constexpr int fitting(double size) {
    return fitting_exponent(is_bounded(size) ? size : 1.0, joint_rounding<Word>.capacity());
  }
  using Sizes = std::conditional_t<shared, DriveSizes<S, Word>, MotionSizes<S, Word>>;
  /// Accelerations that efforts can give, over the declared ones, at most: what is beyond has a status.
  static constexpr double largest_excess = 16384.0;

  static constexpr int of(role::Position, int i) {
    const double low = magnitude(link(i).position_min), high = magnitude(link(i).position_max);
    return link(i).type == JointType::revolute ? 0 : fitting(low > high ? low : high);
  }
  static constexpr int of(role::Velocity, int i) { return fitting(link(i).speed_limit); }
  static constexpr int of(role::Acceleration, int i) { return fitting(link(i).acceleration_limit); }
  static constexpr int of(role::Effort, int i) {
    const double declared = link(i).effort_limit, own = Sizes::effort(i);
    return joint_rounding<Word>.exponent(is_bounded(declared) && declared > own ? declared : own);
  }
  /// In formats of the declared motion as fine as motions allow, up to what a difference of both has bits for.
  static constexpr int of(role::MotionEffort, int i) {
    constexpr int finest = 24;
    if constexpr (shared) {
      return of(role::Effort{}, i);
    } else {
      if (free_ranges_of<S, Word>.halvings == 0) return of(role::Effort{}, i);
      return smaller(joint_rounding<Word>.exponent(Sizes::effort(i)), of(role::Effort{}, i) + finest);
    }
  }
  static constexpr int of(role::FreeAcceleration, int i) {
    const double declared = link(i).acceleration_limit * largest_excess;
    if constexpr (shared) {
      const double free = Sizes::mobility(i) * Sizes::energy();
      return joint_rounding<Word>.exponent(declared < free ? declared : free);
    } else {
      const double free = excess_of<S, Word> * free_ranges_of<S, Word>.range[i].joint_acceleration.size;
      return joint_rounding<Word>.exponent(free_ranges_of<S, Word>.halvings > 0 && declared < free ? declared : free);
    }
  }
  static constexpr int of(role::Momentum, int i) { return joint_rounding<Word>.exponent(Sizes::momentum(i)); }
  static constexpr int of(role::MomentumRate, int i) { return joint_rounding<Word>.exponent(Sizes::momentum_rate(i)); }
  /// With room for the errors of both.
  template <class A, class B>
  static constexpr int of(role::Product<A, B>, int i) {
    return joint_rounding<Word>.exponent((1.0 + power_of_two(-12)) * largest(A{}, i) * largest(B{}, i));
  }
  /// What values of a role reach inside the declared limits.
  ///@{
  static constexpr double largest(role::Velocity, int i) { return link(i).speed_limit; }
  static constexpr double largest(role::Effort, int i) { return Sizes::effort(i); }
  ///@}
};

template <class S, class Word, class Role>
inline constexpr auto exponents_of = [] {
  check_limits<S, Word>();
  return per_joint<joint_count<S>>([](int i) { return RoleExponent<S, Word>::of(Role{}, i); });
}();

}  // namespace detail

/// Joint values of one role in fixed point: value = raw * 2^-exponent(i) in SI units; revolute positions are BAM32,
/// angle = raw * 2 pi / 2^32, in 32 bits whatever the word.
template <class S, class Word, class Role>
struct Joints<S, Stored<Word>, Role>
    : detail::ValuesOf<S, std::conditional_t<std::is_same_v<Role, role::Position>, Fixed32, Stored<Word>>> {
  static_assert(detail::joint_is_limited<detail::LimitedJoints<S, Role>::speed>,
                "axial: fixed point takes its formats from the declared limits; give every link a "
                "speed_limit(), of a drive that joints share drive_limits()");
  static_assert(detail::joint_is_limited<detail::LimitedJoints<S, Role>::acceleration>,
                "axial: fixed point takes its formats from the declared limits; give every link an "
                "acceleration_limit(), of a drive that joints share drive_limits()");
  static_assert(detail::joint_is_limited<detail::LimitedJoints<S, Role>::position>,
                "axial: fixed point takes its formats from the declared limits; give every prismatic link "
                "position_limits(), of a drive that joints share drive_limits()");
  /// a stored word; positions have 32 bits
  using Value = std::conditional_t<std::is_same_v<Role, role::Position>, Fixed32, Stored<Word>>;
  static constexpr int size = joint_count<S>;  ///< number of joints
  using Base = detail::ValuesOf<S, Value>;     ///< the values
  using Base::Base;                            ///< so many values
  AXIAL_INLINE constexpr Joints() : Base() {}  ///< or none

  /// Exponent of joint i's value; 0 for revolute positions.
  AXIAL_INLINE static constexpr int exponent(int i) {
    return detail::exponents_of<S, typename Value::Word, Role>.of[i];
  }
  AXIAL_INLINE constexpr Value& operator[](int i) {
    return this->values[i];
  }  ///< value of joint i; the index is not checked
  AXIAL_INLINE constexpr const Value& operator[](int i) const {
    return this->values[i];
  }  ///< value of joint i; the index is not checked
};

}  // namespace axial

#include <axial/options/end.hpp>
