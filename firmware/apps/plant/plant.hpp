#pragma once
/// A board that integrates a robot by the words of its input, and tells what it made of them. README.md has the format.

#include <hal/counter.hpp>
#include <hal/text.hpp>

#include "input.hpp"

namespace axial::apps::plant {

template <class Board, class R, class Number>
class Plant {
 public:
  constexpr explicit Plant(const std::uint32_t* input) : input_(input) {}

  /// `semi_implicit` and `runge_kutta`: functions of one step, to be counted.
  void run(hal::Measured semi_implicit, hal::Measured runge_kutta) {
    take_start();
    const auto kernel = input_[method] == 0 ? semi_implicit : runge_kutta;
    const auto per_tick = static_cast<std::uint32_t>(steps_per_tick[input_[step_choice]]);
    std::uint32_t least = ~0U, most = 0;
    for (std::uint32_t k = 0, of_tick = 0, tick = 0; k < input_[steps]; ++k) {
      if (of_tick == 0) take_efforts(tick++);
      of_tick = of_tick + 1 == per_tick ? 0 : of_tick + 1;
      const std::uint32_t count = Board::Counter::count(kernel, this);
      least = count < least ? count : least, most = count > most ? count : most;
      if ((k + 1) % input_[report_every] == 0) report(count);
    }
    Board::print("steps"), print_number(steps_made()), print_number(least), print_number(most);
    Board::print("\n");
  }

  /// One step.
  template <class Method>
  void move() {
    (void)advance<Method>(x_, step_of<R, Number>[input_[step_choice]], held_);  // one that is not made is not counted
  }

 private:
  static constexpr auto joints = static_cast<std::uint32_t>(joint_count<R>);

  void take_start() {
    std::uint32_t at = head_words;
    each_word(x_, [&](auto& value) { put_word(value, input_[at++]); });
  }
  /// Efforts of a tick; the last that there are from then on.
  void take_efforts(std::uint32_t tick) {
    const std::uint32_t ticks = input_[effort_ticks], held = tick < ticks ? tick : ticks - 1;
    if (ticks == 0) return;
    for (std::uint32_t i = 0; i < joints; ++i)
      put_word(held_.tau[static_cast<int>(i)], input_[head_words + state_words<R> + held * joints + i]);
  }

  std::uint32_t steps_made() const { return static_cast<std::uint32_t>(x_.steps); }
  static void print_number(std::uint32_t number) { Board::print(","), Board::print(hal::decimal(number).text); }
  void report(std::uint32_t count) {
    Board::print("count"), print_number(count);
    Board::print("\nstate"), print_number(steps_made());
    each_word(x_, [](const auto& value) { Board::print(","), Board::print(hal::hex(word_of(value)).text); });
    Board::print("\n");
  }

  const std::uint32_t* input_;
  MotionOf<R, Number> x_{};
  Held<SceneOf<R>, Number> held_{};
};

}  // namespace axial::apps::plant
