// Joint values in fixed point: integers, and the exponents that the robot's declared limits give them.
#pragma once

#include <axial/model/joints.hpp>
#include <axial/model/ranges/forward_error.hpp>
#include <axial/model/ranges/momentum.hpp>

namespace axial {

namespace detail {

template <class Word, class Role>
struct RoleOf<Stored<Word>, Role> {
  using type = Role;
};

constexpr bool is_bounded(double limit) { return limit < std::numeric_limits<double>::max(); }

template <class Robot>
constexpr void check_limits() {
  constexpr auto all = [](bool (*good)(const LinkParameters&)) {
    for (const LinkParameters& link : Robot::chain.links)
      if (!good(link)) return false;
    return true;
  };
  static_assert(all([](const LinkParameters& p) { return is_bounded(p.speed_limit); }),
                "axial: fixed point takes its formats from the declared limits; give every link a speed_limit()");
  static_assert(all([](const LinkParameters& p) { return is_bounded(p.acceleration_limit); }),
                "axial: fixed point takes its formats from the declared limits; give every link an "
                "acceleration_limit()");
  static_assert(all([](const LinkParameters& p) {
                  return p.type == JointType::revolute || (is_bounded(p.position_max) && is_bounded(-p.position_min));
                }),
                "axial: fixed point takes its formats from the declared limits; give every prismatic link "
                "position_limits()");
}

template <class S, class Word, class Role>
constexpr auto role_exponents() {
  using Robot = robot_of<S>;
  check_limits<Robot>();
  constexpr int size = Robot::chain.size;
  struct Table {
    int of[size] = {};
  } table;
  constexpr Rounding rounding{8 * static_cast<int>(sizeof(Word)), true, false, 0.0};
  const auto efforts = newton_euler_ranges(mechanism_of<scene_of<S>, FullParameters>, rounding);
  for (int i = 0; i < size; ++i) {
    const LinkParameters& p = Robot::chain.links[i];
    const double low = magnitude(p.position_min), high = magnitude(p.position_max);
    const double effort = efforts.range[i].joint_effort.size;
    if (std::is_same_v<Role, role::Position> && p.type == JointType::prismatic)
      table.of[i] = fitting_exponent(low > high ? low : high, rounding.capacity());
    if (std::is_same_v<Role, role::Position> && p.type == JointType::revolute) table.of[i] = 0;
    if (std::is_same_v<Role, role::Velocity>) table.of[i] = fitting_exponent(p.speed_limit, rounding.capacity());
    if (std::is_same_v<Role, role::Acceleration>)
      table.of[i] = fitting_exponent(p.acceleration_limit, rounding.capacity());
    if (std::is_same_v<Role, role::Effort>)
      table.of[i] = rounding.exponent(is_bounded(p.effort_limit) && p.effort_limit > effort ? p.effort_limit : effort);
  }
  if constexpr (std::is_same_v<Role, role::FreeAcceleration>) {
    constexpr const auto& mechanism = mechanism_of<scene_of<S>, FullParameters>;
    const auto free = articulated_at_rest_ranges(mechanism, rounding);
    const double excess = excess_of_drive(mechanism, rounding, efforts);
    for (int i = 0; i < size; ++i)
      table.of[i] = rounding.exponent(excess * free.range[i].joint_acceleration.size);
  }
  if constexpr (std::is_same_v<Role, role::Momentum> || std::is_same_v<Role, role::MomentumRate>) {
    constexpr const auto& mechanism = mechanism_of<scene_of<S>, FullParameters>;
    const auto momenta = momentum_ranges(mechanism, rounding);
    for (int i = 0; i < size; ++i)
      table.of[i] =
          rounding.exponent(std::is_same_v<Role, role::Momentum>
                                ? momenta.range[i].joint_effort.size
                                : kinetic_slope_range(mechanism, momenta, i).size + efforts.range[i].joint_effort.size);
  }
  return table;
}
template <class S, class Word, class Role>
inline constexpr auto exponents_of = role_exponents<S, Word, Role>();

}  // namespace detail

/// Joint values of one role in fixed point: value = raw * 2^-exponent(i) in SI units; revolute positions are BAM32,
/// angle = raw * 2 pi / 2^32, in 32 bits whatever the word.
template <class S, class Word, class Role>
struct Joints<S, Stored<Word>, Role> {
  /// a stored word; positions have 32 bits
  using Value = std::conditional_t<std::is_same_v<Role, role::Position>, Fixed32, Stored<Word>>;
  static constexpr int size = joint_count<S>;  ///< number of joints
  Value values[size];                          ///< from the base outwards

  /// Exponent of joint i's value; 0 for revolute positions.
  static constexpr int exponent(int i) { return detail::exponents_of<S, typename Value::Word, Role>.of[i]; }
  constexpr Value& operator[](int i) { return values[i]; }              ///< value of joint i; the index is not checked
  constexpr const Value& operator[](int i) const { return values[i]; }  ///< value of joint i; the index is not checked
};

}  // namespace axial
