// A robot's motions as a board gets them, in words, and what the states that it answers are off.
#pragma once

#include <firmware/apps/plant/input.hpp>
#include <host_sim/plants/real_time/measured.hpp>
#include <host_sim/tools/analysis/largest.hpp>

#include <cstdint>
#include <vector>

namespace host_sim::real_time {

namespace image = axial::apps::plant;

/// Which steps a board makes.
struct Steps {
  bool runge_kutta = true;
  std::uint32_t choice = 0;  ///< of image::steps_per_tick
  std::uint32_t made = 0, report_every = 1;
};

/// What a board said after so many steps.
struct Reported {
  std::uint64_t steps = 0;
  std::vector<std::uint32_t> words;
};

/// What those states are off the same motion on this host, and off double.
struct Judged {
  bool same_bits = true;
  double difference = 0.0;  ///< of a joint's last position, from this host's, over how far the joint travels
  /// After each tick: positions, and what they are off the reference in double, likewise.
  std::vector<std::vector<double>> positions;
  std::vector<double> errors;
};

/// A motion by numbers T, driven by efforts or free.
template <class R, class T>
class OnBoard {
  using X = image::MotionOf<R, T>;
  using S = Plant<R>;

 public:
  explicit OnBoard(const Driven<R>& motion) : start_(Motions<R, X>::at(motion.start)), travel_(motion.travel) {
    for (const auto& efforts : motion.efforts)
      held_.push_back({in_numbers<axial::EffortsOf<S, T>>(efforts), {}});
  }
  /// Swings from there.
  explicit OnBoard(const axial::Joints<R, double>& start) : start_(Motions<R, X>::at(start)) {
    for (double& way : travel_.values)
      way = 1.0;
  }

  /// As firmware/apps/plant/input.hpp lays them out.
  std::vector<std::uint32_t> words(const Steps& steps) const {
    std::vector<std::uint32_t> all{steps.runge_kutta ? 1U : 0U, steps.choice, steps.made, steps.report_every,
                                   static_cast<std::uint32_t>(held_.size())};
    X x = start_;
    image::each_word(x, [&](const auto& value) { all.push_back(image::word_of(value)); });
    for (const auto& held : held_)
      for (int i = 0; i < held.tau.size; ++i)
        all.push_back(image::word_of(held.tau[i]));
    return all;
  }

  /// `reference`: positions after each tick; none of a free motion.
  Judged judge(const Steps& steps, const std::vector<Reported>& states,
               const std::vector<axial::Joints<R, double>>& reference) const {
    return steps.runge_kutta ? followed<axial::RungeKutta4>(steps, states, reference)
                             : followed<axial::SemiImplicitEuler>(steps, states, reference);
  }
  /// The largest change of energy from the start, J.
  double energy_drift(const std::vector<Reported>& states) const {
    const double first = Motions<R, X>::energy(start_);
    double drift = 0.0;
    for (const Reported& state : states)
      host_sim::note_size(drift, Motions<R, X>::energy(state_of(state)) - first);
    return drift;
  }

 private:
  template <class Method>
  Judged followed(const Steps& steps, const std::vector<Reported>& states,
                  const std::vector<axial::Joints<R, double>>& reference) const {
    const auto per_tick = static_cast<std::size_t>(image::steps_per_tick[steps.choice]);
    Judged judged;
    X x = start_;
    for (const Reported& state : states) {
      for (std::size_t made = x.steps; made < state.steps; ++made)
        (void)axial::advance<Method>(x, image::step_of<R, T>[steps.choice], held_in(made / per_tick));
      const X board = state_of(state);
      judged.same_bits = judged.same_bits && x.steps == state.steps && words_of(x) == state.words;
      const auto q = in_double<R>(board.q);
      judged.difference = largest(q, in_double<R>(x.q));
      if (state.steps % per_tick != 0 || state.steps / per_tick > reference.size() || state.steps == 0) continue;
      judged.positions.emplace_back(std::begin(q.values), std::end(q.values));
      judged.errors.push_back(largest(q, reference[state.steps / per_tick - 1]));
    }
    return judged;
  }
  axial::Held<S, T> held_in(std::size_t tick) const {
    return held_.empty() ? axial::Held<S, T>{} : held_[std::min(tick, held_.size() - 1)];
  }
  double largest(const axial::Joints<R, double>& a, const axial::Joints<R, double>& b) const {
    double most = 0.0;
    for (int i = 0; i < R::chain.size; ++i) {
      const double off = std::fabs(a[i] - b[i]) / travel_[i];
      most = off <= most ? most : off;
    }
    return most;
  }
  static std::vector<std::uint32_t> words_of(X x) {
    std::vector<std::uint32_t> words;
    image::each_word(x, [&](const auto& value) { words.push_back(image::word_of(value)); });
    return words;
  }
  static X state_of(const Reported& state) {
    X x;
    std::size_t at = 0;
    image::each_word(x, [&](auto& value) { image::put_word(value, state.words.at(at++)); });
    return x;
  }

  X start_;
  axial::Joints<R, double> travel_;
  std::vector<axial::Held<S, T>> held_;
};

}  // namespace host_sim::real_time
