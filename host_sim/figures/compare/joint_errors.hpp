// Errors of torques, relative to each joint's largest.
#pragma once

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
    largest_[i] = std::fmax(largest_[i], std::fabs(static_cast<double>(exact)));
    worst_[i] = std::fmax(worst_[i], std::fabs(difference));
    squares_[i] += difference * difference;
    if (i == 0) ++states_;
  }
  /// A joint that never has a torque has no error either.
  [[nodiscard]] double worst() const {
    double result = 0.0;
    for (std::size_t i = 0; i < worst_.size(); ++i)
      if (largest_[i] > 0.0) result = std::fmax(result, worst_[i] / largest_[i]);
    return result;
  }
  [[nodiscard]] double rms() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < worst_.size(); ++i)
      if (largest_[i] > 0.0) sum += squares_[i] / (largest_[i] * largest_[i]);
    return std::sqrt(sum / (static_cast<double>(states_) * static_cast<double>(worst_.size())));
  }

 private:
  std::vector<double> largest_, worst_, squares_;
  int states_ = 0;
};

}  // namespace compare
