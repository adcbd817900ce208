// What an integrator moves on: positions, velocities, a count of steps; the rounding errors of the sums where asked.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/simulation/summation.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A step of time, s: of fixed point made of a double (FixedStep).
template <class S, class T>
using StepOf = typename detail::Summation<S, T>::Step;

/// State of a robot's joints: q (rad or m), qd (rad/s or m/s), owned by the caller. Time is the number of steps made:
/// a sum of steps in float is 2 % short after 2e6 of them, and stands still in the end. Numbers with formats specialise
/// it, and keep what rounding left of each sum (fixed/simulation/motion.hpp).
template <class S, class T>
struct Motion {
  static_assert((detail::check_summed<S, T>(), true));
  using Subject = S;                             ///< the robot or scene that moves
  using Scalar = T;                              ///< float, double, or a word
  static constexpr bool is_compensated = false;  ///< whether float and double keep what rounding left
  Positions<robot_of<S>, T> q{};                 ///< rad or m
  Velocities<robot_of<S>, T> qd{};               ///< rad/s or m/s
  std::uint64_t steps = 0;                       ///< made since time 0

  /// Seconds after that many steps of h and so many halves of one.
  [[nodiscard]] AXIAL_INLINE constexpr auto time(const StepOf<S, T>& h, int halves = 0) const {
    return detail::Summation<S, T>::time(steps, h, halves);
  }
};

/// A motion with what rounding left of each sum: two more words per joint. In float, steps may then be as small as they
/// need to be (Kahan 1965, by the exact sum of two numbers of Knuth 1969).
template <class S, class T>
struct CompensatedMotion : Motion<S, T> {
  static_assert(!detail::is_word<T>, "axial: in fixed point a Motion keeps what rounding leaves; take axial::Motion");
  static constexpr bool is_compensated = true;  ///< it does
  Positions<robot_of<S>, T> q_rest{};           ///< rad or m, what q lacks
  Velocities<robot_of<S>, T> qd_rest{};         ///< rad/s or m/s, what qd lacks
};

}  // namespace axial

#include <axial/options/end.hpp>
