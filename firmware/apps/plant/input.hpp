#pragma once
/// What a plant integrates, as words in the image's flash: the host writes them into the file before it starts the
/// board, so that one image has every motion of its robot and of its number system. Words are float's bits or fixed
/// point's.

#include <axial/axial.hpp>
#include <axial/fixed.hpp>
#include <axial/fixed/simulation/integrators.hpp>

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace axial::apps::plant {

/// A bare robot with its rotors: friction would hide what numbers lose.
template <class R>
using SceneOf = Scene<R, Gravity, RotorInertia>;

/// What moves: in float with compensated sums.
template <class R, class Number>
using MotionOf =
    std::conditional_t<is_stored_v<Number>, Motion<SceneOf<R>, Number>, CompensatedMotion<SceneOf<R>, Number>>;

constexpr double tick_s = 1e-3;  ///< between efforts
constexpr int choices = 4;       ///< of steps
constexpr int steps_per_tick[choices] = {1, 2, 5, 10};
constexpr std::uint32_t most_ticks = 1000;  ///< of efforts

/// A step per choice: s, or fixed point's.
template <class R, class Number, class Step = StepOf<SceneOf<R>, Number>>
inline constexpr Step step_of[choices] = {
    static_cast<Step>(tick_s / steps_per_tick[0]), static_cast<Step>(tick_s / steps_per_tick[1]),
    static_cast<Step>(tick_s / steps_per_tick[2]), static_cast<Step>(tick_s / steps_per_tick[3])};

/// Words before those of a start and of efforts.
enum Head : std::uint32_t {
  method,        ///< 0 semi-implicit Euler, 1 Runge-Kutta
  step_choice,   ///< index of steps_per_tick
  steps,         ///< to be made
  report_every,  ///< so many of them
  effort_ticks,  ///< 0: the robot moves freely; else efforts of so many ticks follow, the last one held
  head_words
};

/// q, qd, what rounding left of q, of qd.
template <class R>
constexpr std::uint32_t state_words = 4 * static_cast<std::uint32_t>(joint_count<R>);
template <class R>
constexpr std::uint32_t input_words = head_words + state_words<R> +
                                      most_ticks* static_cast<std::uint32_t>(joint_count<R>);

/// A value's word, and back.
///@{
template <class V>
std::uint32_t word_of(const V& value) {
  std::uint32_t word = 0;
  if constexpr (is_stored_v<V>)
    word = static_cast<std::uint32_t>(value.raw);
  else
    std::memcpy(&word, &value, sizeof word);
  return word;
}
template <class V>
void put_word(V& value, std::uint32_t word) {
  if constexpr (is_stored_v<V>)
    value.raw = static_cast<std::int32_t>(word);
  else
    std::memcpy(&value, &word, sizeof word);
}
///@}

/// f(value) for every word of a state, in their order.
template <class X, class F>
void each_word(X& x, F f) {
  constexpr int n = joint_count<typename X::Subject>;
  for (int i = 0; i < n; ++i)
    f(x.q[i]);
  for (int i = 0; i < n; ++i)
    f(x.qd[i]);
  for (int i = 0; i < n; ++i)
    f(x.q_rest[i]);
  for (int i = 0; i < n; ++i)
    f(x.qd_rest[i]);
}

}  // namespace axial::apps::plant
