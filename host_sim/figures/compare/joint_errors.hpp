// Errors of torques, relative to each joint's largest.
#pragma once

#include <host_sim/tools/analysis/largest.hpp>

#include <cmath>
#include <vector>

namespace compare {

/// Largest value and difference of every joint, as they come.
class JointErrors {
 public:
  explicit JointErrors(int joints) : largest_(std::size_t(joints)), worst_(largest_), squares_(largest_) {}
  /// Number may be finer than double, which rounds their difference alone.
  template <class Number>
  void add(int joint, const Number& value, const Number& exact) {
    const auto i = static_cast<std::size_t>(joint);
    const auto difference = static_cast<double>(value - exact);
    host_sim::note_size(largest_[i], static_cast<double>(exact));
    host_sim::note_size(worst_[i], difference);
    squares_[i] += difference * difference;
    if (i == 0) ++states_;
  }
  /// A joint that never has a torque has no error either.
  [[nodiscard]] double worst() const {
    double result = 0.0;
    for (std::size_t i = 0; i < worst_.size(); ++i)
      if (!(largest_[i] <= 0.0)) host_sim::note_size(result, worst_[i] / largest_[i]);
    return result;
  }
  [[nodiscard]] double rms() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < worst_.size(); ++i)
      if (!(largest_[i] <= 0.0)) sum += squares_[i] / (largest_[i] * largest_[i]);
    return std::sqrt(sum / (static_cast<double>(states_) * static_cast<double>(worst_.size())));
  }

 private:
  std::vector<double> largest_, worst_, squares_;
  int states_ = 0;
};

}  // namespace compare
