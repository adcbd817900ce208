// What an integrator moves on: positions, velocities, a count of steps; the rounding errors of the sums where asked.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/scalar/select.hpp>
#include <axial/scene/joints.hpp>

#include <axial/options/begin.hpp>

namespace axial {

namespace detail {
/// Says which numbers are not summed.
template <class T>
constexpr auto check_summed() {
  static_assert(is_number_v<T> && std::numeric_limits<T>::is_iec559,
                "axial: integrators move float and double; fixed point has no format for what they sum");
}
}  // namespace detail

/// State of a robot's joints: q (rad or m), qd (rad/s or m/s), owned by the caller. Time is the number of steps made:
/// a sum of steps in float is 2 % short after 2e6 of them, and stands still in the end.
template <class S, class T>
struct Motion {
  static_assert((detail::check_summed<T>(), true));
  using Subject = S;                ///< the robot or scene that moves
  using Scalar = T;                 ///< float or double
  Positions<robot_of<S>, T> q{};    ///< rad or m
  Velocities<robot_of<S>, T> qd{};  ///< rad/s or m/s
  std::uint64_t steps = 0;          ///< made since time 0

  /// Seconds after that many steps of h, rounded twice, however many there were.
  [[nodiscard]] AXIAL_INLINE constexpr T time(T h) const { return static_cast<T>(steps) * h; }
};

/// A motion with what rounding left of each sum: two more words per joint. In float, steps may then be as small as they
/// need to be (Kahan 1965, by the exact sum of two numbers of Knuth 1969).
template <class S, class T>
struct CompensatedMotion : Motion<S, T> {
  Positions<robot_of<S>, T> q_rest{};    ///< rad or m, what q lacks
  Velocities<robot_of<S>, T> qd_rest{};  ///< rad/s or m/s, what qd lacks
};

namespace detail {

/// x + rest += dx, with x the sum rounded and rest what that left.
template <class T>
AXIAL_INLINE constexpr void add_exactly(T& x, T& rest, const T& dx) {
  const T y = dx + rest;
  const T sum = x + y;
  const T of_y = sum - x;
  rest = (x - (sum - of_y)) + (y - of_y);
  x = sum;
}

template <class S, class T>
AXIAL_INLINE constexpr void add_position(Motion<S, T>& x, int i, const T& dq) {
  x.q[i] += dq;
}
template <class S, class T>
AXIAL_INLINE constexpr void add_velocity(Motion<S, T>& x, int i, const T& dqd) {
  x.qd[i] += dqd;
}
template <class S, class T>
AXIAL_INLINE constexpr void add_position(CompensatedMotion<S, T>& x, int i, const T& dq) {
  add_exactly(x.q[i], x.q_rest[i], dq);
}
template <class S, class T>
AXIAL_INLINE constexpr void add_velocity(CompensatedMotion<S, T>& x, int i, const T& dqd) {
  add_exactly(x.qd[i], x.qd_rest[i], dqd);
}

// Joint i of `moved` into x, or nothing.
template <class S, class T>
AXIAL_INLINE constexpr void keep_joint(bool keep, const Motion<S, T>& moved, Motion<S, T>& x, int i) {
  x.q[i] = select(keep, moved.q[i], x.q[i]), x.qd[i] = select(keep, moved.qd[i], x.qd[i]);
}
template <class S, class T>
AXIAL_INLINE constexpr void keep_joint(bool keep, const CompensatedMotion<S, T>& moved, CompensatedMotion<S, T>& x,
                                       int i) {
  const Motion<S, T>& plain = moved;
  Motion<S, T>& kept = x;
  keep_joint(keep, plain, kept, i);
  x.q_rest[i] = select(keep, moved.q_rest[i], x.q_rest[i]), x.qd_rest[i] = select(keep, moved.qd_rest[i], x.qd_rest[i]);
}

}  // namespace detail
}  // namespace axial

#include <axial/options/end.hpp>
