// Declared limits as raw words, in the formats of the joints' roles.
#pragma once

#include <axial/fixed/formats/joint_formats.hpp>
#include <axial/fixed/words/round.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Largest magnitude of a speed, an acceleration or an effort, raw.
template <class Word>
struct RawMost {
  Word raw{};  ///< at the exponent of the role
  /// -1 where |x| is larger, else 0; a subtraction, which no compiler makes a branch.
  [[nodiscard]] constexpr std::int32_t outside(const Stored<Word>& x) const {
    const std::uint32_t up = static_cast<std::uint32_t>(x.raw) + static_cast<std::uint32_t>(raw);
    return static_cast<std::int32_t>((2 * std::int64_t{raw} - std::int64_t{up}) >> 32);
  }
  /// Whether |x| is no larger.
  [[nodiscard]] constexpr bool allows(const Stored<Word>& x) const { return x.raw <= raw && x.raw >= -raw; }
  /// x, or the nearer end.
  [[nodiscard]] constexpr Stored<Word> nearest(const Stored<Word>& x) const {
    const std::int32_t sign = x.raw >> (8 * static_cast<int>(sizeof(Word)) - 1), end = (raw ^ sign) - sign;
    return {static_cast<Word>(x.raw ^ ((x.raw ^ end) & outside(x)))};
  }
};

/// Range of a position, raw: for a revolute joint an arc, on which min to max counts upwards and may pass half a turn.
struct PositionRange {
  std::int32_t min = 0, max = 0;  ///< ends of the range; angles in 2^-32 turns
  std::uint32_t span = 0;         ///< max - min; all ones where every angle is allowed
  bool wraps = false;             ///< whether it is an arc of a circle

  /// One comparison for slides and arcs alike: what is below min is beyond any span.
  [[nodiscard]] constexpr bool reaches(const Fixed32& q) const { return outside(q) == 0; }
  /// -1 where q is not reached, else 0; by a subtraction.
  [[nodiscard]] constexpr std::int32_t outside(const Fixed32& q) const {
    return static_cast<std::int32_t>((std::int64_t{span} - std::int64_t{beyond(q.raw, min)}) >> 32);
  }
  /// q, or the nearer end; of an arc, along the circle.
  [[nodiscard]] constexpr Fixed32 nearest(const Fixed32& q) const {
    const std::uint32_t past = beyond(q.raw, max), before = beyond(min, q.raw);
    const bool to_min = wraps ? before < past : q.raw < min;
    const int inside = -static_cast<int>(reaches(q)), low = -static_cast<int>(to_min);
    return {(q.raw & inside) | (((min & low) | (max & ~low)) & ~inside)};
  }

 private:
  [[nodiscard]] static constexpr std::uint32_t beyond(std::int32_t x, std::int32_t from) {
    return static_cast<std::uint32_t>(x) - static_cast<std::uint32_t>(from);
  }
};

/// Declared limits of a scene's robot as raw words, each rounded to nearest: the limit itself is inside. A revolute
/// range of a whole turn or more is no limit in a binary angle.
template <class S, class Word>
struct FixedLimits {
  /// Limits of one joint; the base is those of its position.
  struct Joint : PositionRange {
    RawMost<Word> speed, acceleration, effort;  ///< in either direction
  };
  Joint joints[joint_count<S>];  ///< from the base outwards
};

namespace detail {

template <class Values>
struct RoleTraits;
template <class SceneOrRobot, class WordType, class RoleType>
struct RoleTraits<Joints<SceneOrRobot, Stored<WordType>, RoleType>> {
  using S = SceneOrRobot;
  using Word = WordType;
  using Role = RoleType;
};

/// Which joints turn, apart from all else that a chain says, so that an image holds no more.
template <class Robot>
struct Turns {
  bool of[Robot::chain.size] = {};
  constexpr Turns() {
    for (int i = 0; i < Robot::chain.size; ++i)
      of[i] = described_chain<Robot>.links[i].type == JointType::revolute;
  }
};
template <class Robot>
inline constexpr Turns<Robot> turns_of{};

template <class Values>
constexpr bool is_angle(int i) {
  using Traits = RoleTraits<Values>;
  return std::is_same_v<typename Traits::Role, role::Position> &&
         turns_of<typename scene_of<typename Traits::S>::Robot>.of[i];
}

inline constexpr double whole_turn = 6.283185307179586;  // rad

/// value * 2^exponent to nearest, at most what a word holds.
template <class Word>
constexpr Word raw_limit(double value, int exponent) {
  constexpr double most = static_cast<double>((std::numeric_limits<Word>::max)());
  const double scaled = value * power_of_two(exponent);
  return scaled >= most ? (std::numeric_limits<Word>::max)()
                        : static_cast<Word>(scaled <= -most ? -nearest_integer(most) : nearest_integer(scaled));
}

constexpr std::int32_t raw_angle(double radians) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(nearest_integer(radians * bam_per_radian)));
}

constexpr PositionRange position_range(const LinkParameters& p, int exponent) {
  PositionRange range;
  range.wraps = p.type == JointType::revolute;
  if (range.wraps && !(p.position_max - p.position_min < whole_turn)) {
    range.span = (std::numeric_limits<std::uint32_t>::max)();
    return range;
  }
  range.min = range.wraps ? raw_angle(p.position_min) : raw_limit<std::int32_t>(p.position_min, exponent);
  range.max = range.wraps ? raw_angle(p.position_max) : raw_limit<std::int32_t>(p.position_max, exponent);
  range.span = static_cast<std::uint32_t>(range.max) - static_cast<std::uint32_t>(range.min);
  return range;
}

template <class S, class Word>
constexpr FixedLimits<S, Word> fixed_limits() {
  using Robot = robot_of<S>;
  using T = Stored<Word>;
  FixedLimits<S, Word> all{};
  for (int i = 0; i < joint_count<S>; ++i) {
    const LinkParameters& p = scene_of<S>::Robot::chain.links[i];
    static_cast<PositionRange&>(all.joints[i]) = position_range(p, Positions<Robot, T>::exponent(i));
    all.joints[i].speed.raw = raw_limit<Word>(p.speed_limit, Velocities<Robot, T>::exponent(i));
    all.joints[i].acceleration.raw = raw_limit<Word>(p.acceleration_limit, Accelerations<Robot, T>::exponent(i));
    all.joints[i].effort.raw = raw_limit<Word>(p.effort_limit, EffortsOf<S, T>::exponent(i));
  }
  return all;
}

}  // namespace detail

/// The raw limits as a constant.
template <class S, class Word>
inline constexpr FixedLimits<S, Word> fixed_limits_of = detail::fixed_limits<S, Word>();

}  // namespace axial

#include <axial/options/end.hpp>
