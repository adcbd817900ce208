// Errors against a reference, joint by joint.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace host_sim {

/// Largest and root-mean-square error of one signal, and the reference's largest magnitude that they relate to.
class ErrorStatistics {
 public:
  void add(double value, double reference) {
    const double error = std::abs(value - reference);
    finite_ = finite_ && std::isfinite(value) && std::isfinite(reference);
    largest_ = std::max(largest_, error);
    squares_ += error * error;
    scale_ = std::max(scale_, std::abs(reference));
    ++count_;
  }

  /// Infinite as soon as one value was not finite: an error that cannot be missed.
  double largest() const { return finite_ ? largest_ : std::numeric_limits<double>::infinity(); }
  double rms() const {
    if (!finite_) return std::numeric_limits<double>::infinity();
    return count_ == 0 ? 0.0 : std::sqrt(squares_ / static_cast<double>(count_));
  }
  /// Largest magnitude of the reference.
  double scale() const { return scale_; }

 private:
  bool finite_ = true;
  double largest_ = 0.0, squares_ = 0.0, scale_ = 0.0;
  std::size_t count_ = 0;
};

/// Smallest and largest of a count.
struct Range {
  unsigned min = std::numeric_limits<unsigned>::max(), max = 0;
  void add(unsigned value) { min = std::min(min, value), max = std::max(max, value); }
};

}  // namespace host_sim
