// Joint values at the border between real numbers and fixed point: by integers alone, nearest, never silently wrong.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/control/limits.hpp>
#include <axial/fixed/words/real_words.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Joint values after a conversion, and the first joint whose value could not be kept as it was.
template <class Values>
struct Converted {
  Values values{};  ///< one per joint, in the formats of their role
  Status status{};  ///< names the first joint that was not kept as it was
};

namespace detail {

/// Declared range of a role's value: real, and raw; what is said of a value beyond it.
template <class T, class Word>
struct RoleRange {
  T low, high;
  Word raw_low, raw_high;
  Status::Code beyond;
};

template <class S, class T, class Word, class Role>
constexpr auto role_range(int i) {
  using RoleWord = typename Joints<S, Stored<Word>, Role>::Value::Word;
  const auto& real = limits_of<robot_of<S>, T>.joints[i];
  const auto& raw = fixed_limits_of<S, Word>.joints[i];
  using Range = RoleRange<T, RoleWord>;
  using Code = Status::Code;
  const auto either_way = [](const T& most, const auto& word, Code beyond) {
    return Range{-most, most, Word(-word.raw), word.raw, beyond};
  };
  if constexpr (std::is_same_v<Role, role::Position>)
    return Range{real.position_min, real.position_max, raw.min, raw.max, Code::position_limit};
  else if constexpr (std::is_same_v<Role, role::Velocity>)
    return either_way(real.speed, raw.speed, Code::speed_limit);
  else if constexpr (std::is_same_v<Role, role::Acceleration>)
    return either_way(real.acceleration, raw.acceleration, Code::acceleration_limit);
  else
    return either_way(real.effort, raw.effort, Code::effort_limit);
}

/// Joint i's value in its role's format, the nearest within the declared range.
template <class Values, class T>
constexpr Status::Code convert(typename Values::Value& to, int i, const T& x) {
  using Traits = RoleTraits<Values>;
  using Word = typename Values::Value::Word;
  const auto range = role_range<typename Traits::S, T, typename Traits::Word, typename Traits::Role>(i);
  bool under = below(x, range.low), over = below(range.high, x);
  if (is_angle<Values>(i)) {
    const PositionRange& reached = fixed_limits_of<typename Traits::S, typename Traits::Word>.joints[i];
    const Fixed32 angle = reached.nearest({to_angle(x)});  // a limit may round outwards
    to = {static_cast<Word>(angle.raw)};
    const T farthest = static_cast<T>(most_radians);
    under = under || below(x, -farthest), over = over || below(farthest, x);
  } else {
    const Word raw = to_word<Word>(x, Values::exponent(i));
    to = {raw < range.raw_low ? range.raw_low : raw > range.raw_high ? range.raw_high : raw};
  }
  if (!is_finite(x)) return Status::Code::not_finite;
  return under || over ? range.beyond : Status::Code::ok;
}

}  // namespace detail

/// Real joint values (SI, rad) in the formats of a role: to_fixed<Positions<Robot, Fixed32>>(q).
/// Each is rounded to nearest: halves away from 0; angles modulo a turn, to 2^-20 of their unit of 2^-32 turns. A value
/// outside the declared limits gives the nearest limit (an angle the nearer end along the circle) and a status that
/// names the first such joint and the limit; NaN gives 0, brought inside the limits, and `not_finite`, as infinities
/// do. Joints without position limits take angles up to 512 rad; count turns as encoders do (encoder.hpp) to go
/// further. Integers alone: no float routine is linked, and the loop's length is the only bound there is on time.
template <class Values, class T>
[[nodiscard]] constexpr Converted<Values> to_fixed(
    const Joints<robot_of<typename detail::RoleTraits<Values>::S>, T>& x) {
  Converted<Values> result;
  for (int i = Values::size; i-- > 0;) {
    const Status::Code code = detail::convert<Values>(result.values[i], i, x[i]);
    if (code != Status::Code::ok) result.status = {code, i};
  }
  return result;
}

/// A desired motion in fixed point. The status is that of check_request() on the real numbers; feedforward() must not
/// see a motion that has a bad one, unless the caller means to follow it as far as the limits go.
template <class S, class Word, class T>
[[nodiscard]] constexpr Request<S, Stored<Word>> to_fixed_request(const Joints<robot_of<S>, T>& q,
                                                                  const Joints<robot_of<S>, T>& qd,
                                                                  const Joints<robot_of<S>, T>& qdd) {
  using Robot = robot_of<S>;
  Request<S, Stored<Word>> request;
  for (int i = joint_count<S>; i-- > 0;) {
    using Code = Status::Code;
    const Code a = detail::convert<Positions<Robot, Stored<Word>>>(request.q[i], i, q[i]);
    const Code b = detail::convert<Velocities<Robot, Stored<Word>>>(request.qd[i], i, qd[i]);
    const Code c = detail::convert<Accelerations<Robot, Stored<Word>>>(request.qdd[i], i, qdd[i]);
    const bool number = a != Code::not_finite && b != Code::not_finite && c != Code::not_finite;
    const Code first = !number ? Code::not_finite : a != Code::ok ? a : b != Code::ok ? b : c;
    if (first != Code::ok) request.status = {first, i};
  }
  return request;
}

/// Joint values of a role as real numbers (SI, rad in [-pi, pi)), to nearest: halves to even, angles to the last bit of
/// T but for a few in 2^32 (float) or one unit (double). to_fixed() of the result is the argument where T is double.
template <class T, class SceneOrRobot, class Word, class Role>
[[nodiscard]] constexpr Joints<robot_of<SceneOrRobot>, T> to_real(
    const Joints<SceneOrRobot, Stored<Word>, Role>& values) {
  using Values = Joints<SceneOrRobot, Stored<Word>, Role>;
  Joints<robot_of<SceneOrRobot>, T> result{};
  for (int i = 0; i < Values::size; ++i)
    result[i] = detail::is_angle<Values>(i) ? detail::from_angle<T>(values[i].raw)
                                            : detail::from_word<T>(values[i].raw, Values::exponent(i));
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
