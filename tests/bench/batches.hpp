// Batches of states as a contender: what they gain over one state at a time.
#pragma once

#include <axial/batch.hpp>
#include <bench/ours.hpp>

namespace bench {

/// Arrays of states are loaded, and answers stored, within what is timed. States that fill no batch are answered one by
/// one.
template <class S, class T, Algorithm A>
class Batches : public Contender {
  using Values = axial::Joints<axial::robot_of<S>, T>;
  using Caller = OfRobot<S>;
  static constexpr int lanes = axial::native_lanes<T>;

 public:
  explicit Batches(const States& states)
      : q_(values(states, states.q)),
        qd_(values(states, states.qd)),
        x_(values(states, is_forward(A) ? states.tau : states.qdd)),
        results_(q_.size()),
        statuses_(q_.size()) {}

  void run(int first, int count) override {
    const auto end = static_cast<std::size_t>(first + count);
    auto k = static_cast<std::size_t>(first);
    for (; k + lanes <= end; k += lanes)
      keep(Caller::call(Choice<A>{}, axial::load(&q_[k]), axial::load(&qd_[k]), axial::load(&x_[k])), k);
    for (; k < end; ++k)
      results_[k] = Caller::call(Choice<A>{}, q_[k], qd_[k], x_[k]);
  }
  std::vector<double> result(int state) override {
    const int first = state - state % lanes;
    run(first, lanes);
    const Values& values = results_[std::size_t(state)];
    return std::vector<double>(values.values, values.values + Values::size);
  }

 private:
  static std::vector<Values> values(const States& states, const std::vector<double>& all) {
    std::vector<Values> result(std::size_t(states.count));
    for (std::size_t k = 0; k < result.size(); ++k)
      for (int i = 0; i < states.joints; ++i)
        result[k][i] = static_cast<T>(all[k * std::size_t(states.joints) + std::size_t(i)]);
    return result;
  }
  template <class Answer>
  void keep(const Answer& answer, std::size_t k) {
    axial::store(answer, &results_[k]);
    if constexpr (is_forward(A)) statuses_[k] = answer.status;
  }

  std::vector<Values> q_, qd_, x_, results_;
  std::vector<axial::StatusOf<axial::Batch<T>>> statuses_;
};

/// Null for what does not answer joint values.
template <class S, class T>
std::unique_ptr<Contender> make_batches(Algorithm algorithm, const States& states) {
  switch (algorithm) {
    case Algorithm::inverse_dynamics:
      return std::make_unique<Batches<S, T, Algorithm::inverse_dynamics>>(states);
    case Algorithm::bias:
      return std::make_unique<Batches<S, T, Algorithm::bias>>(states);
    case Algorithm::forward_dynamics:
      return std::make_unique<Batches<S, T, Algorithm::forward_dynamics>>(states);
    default:
      return nullptr;
  }
}

}  // namespace bench
